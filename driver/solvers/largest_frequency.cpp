#include "largest_frequency.hpp"

#include <algorithm>
#include <cmath>

namespace pd {

LargestEigenvalue largestSquaredFrequency(Simulation& simulation, const std::vector<double>& density,
                                          const std::vector<char>& isHeld, double relativeTolerance,
                                          int maximumIterations) {
  Model& model = simulation.model;
  const int n = 3 * model.nOwned();
  double* displacement = model.field("Displacement");
  const double* force = model.field("Force_Density");
  const double* volume = model.field("Volume");
  const std::vector<double> origin(displacement, displacement + n);
  const auto evaluate = [&] {
    model.updateCoordinates();
    model.evaluateForce(0.0);
  };
  evaluate();
  const std::vector<double> forceAtOrigin(force, force + n);
  // Strains of 1e-6: nonlinear terms and round-off both stay near 1e-6 of the tangent.
  const double probe = 1.0e-6 * model.discretization().shortestBond;
  const auto isFree = [&](int i) { return isHeld[static_cast<std::size_t>(i)] == 0; };

  SelfAdjointOperator op;
  op.dot = [&](const double* a, const double* b) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) sum += density[static_cast<std::size_t>(i / 3)] * volume[i / 3] * a[i] * b[i];
    return model.comm().sum(sum);
  };
  op.apply = [&](const double* direction, double* image) {
    double length = 0.0;
    for (int i = 0; i < n; ++i) length = std::max(length, std::abs(direction[i]));
    const double step = probe / model.comm().max(length);
    for (int i = 0; i < n; ++i) displacement[i] = origin[static_cast<std::size_t>(i)] + step * direction[i];
    evaluate();
    for (int i = 0; i < n; ++i)
      image[i] = isFree(i) ? (forceAtOrigin[static_cast<std::size_t>(i)] - force[i]) /
                                 (step * density[static_cast<std::size_t>(i / 3)])
                           : 0.0;
  };
  std::vector<double> start = randomPointValues(model.discretization().globalIds, model.nOwned(), 3);
  for (int i = 0; i < n; ++i)
    if (!isFree(i)) start[static_cast<std::size_t>(i)] = 0.0;
  const LargestEigenvalue result = largestEigenvalue(op, std::move(start), relativeTolerance, maximumIterations);

  std::copy(origin.begin(), origin.end(), displacement);
  model.updateCoordinates();
  return result;
}

}  // namespace pd
