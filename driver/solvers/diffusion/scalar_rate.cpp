#include "scalar_rate.hpp"

#include <algorithm>
#include <cmath>

#include "field_names.hpp"
#include "flow_fields.hpp"

namespace pd {

ScalarRate::ScalarRate(Simulation& simulation, const std::string& field, double t)
    : simulation_(simulation),
      field_(field),
      fluxField_(fluxDivergenceField(field)),
      nOwned_(simulation.model.nOwned()),
      values_(simulation.model.field(field)),
      rate_(simulation.model.field(fluxField_)),
      dependsOnTime_(simulation.conditions.prescribedValueDependsOnTime(field)) {
  simulation.conditions.applyPrescribedValue(field, t);
  simulation.model.importGhosts(field);
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed(field);
  for (int i = 0; i < nOwned_; ++i)
    if (isHeld[static_cast<std::size_t>(i)]) {
      heldPoints_.push_back(i);
      heldValues_.push_back(values_[i]);
    }
  nFree_ = comm().sum(static_cast<long long>(nOwned_) - static_cast<long long>(heldPoints_.size()));
}

double ScalarRate::largestValue() const {
  double largest = 0.0;
  for (int i = 0; i < nOwned_; ++i) largest = std::max(largest, std::abs(values_[i]));
  return comm().max(largest);
}

double ScalarRate::largestHeldValue() const {
  double largest = 0.0;
  for (const int point : heldPoints_) largest = std::max(largest, std::abs(values_[point]));
  return comm().max(largest);
}

void ScalarRate::hold(double t) {
  if (dependsOnTime_)
    simulation_.conditions.applyPrescribedValue(field_, t);
  else
    for (std::size_t k = 0; k < heldPoints_.size(); ++k) values_[heldPoints_[k]] = heldValues_[k];
  simulation_.model.importGhosts(field_);
}

void ScalarRate::evaluate(double dt) {
  Model& model = simulation_.model;
  // Slopes of what a flow carries, which another solver of the run may have held elsewhere.
  if (const std::string limitedAt = fields::limitedAt(field_).label; model.hasField(limitedAt))
    std::copy_n(values_, model.nPoints(), model.field(limitedAt));
  model.evaluateFluxDivergence(dt, fluxField_);
  for (const int point : heldPoints_) rate_[point] = 0.0;
}

double ScalarRate::largestEigenvalueBound(double dt, double relativeTolerance, int maximumIterations) {
  Model& model = simulation_.model;
  const std::vector<double> origin(values_, values_ + nOwned_);
  evaluate(dt);
  const std::vector<double> rateAtOrigin(rate_, rate_ + nOwned_);
  const double* volume = model.field("Volume");
  // The operators of this library are linear in the field, where any probe is exact; this one is small beside the
  // field for those that are not.
  const double largest = largestValue();
  const double probe = 1.0e-4 * (largest > 0.0 ? largest : 1.0);

  SelfAdjointOperator op;
  op.dot = [&](const double* a, const double* b) {
    double sum = 0.0;
    for (int i = 0; i < nOwned_; ++i) sum += volume[i] * a[i] * b[i];
    return comm().sum(sum);
  };
  op.apply = [&](const double* direction, double* image) {
    double length = 0.0;
    for (int i = 0; i < nOwned_; ++i) length = std::max(length, std::abs(direction[i]));
    const double step = probe / comm().max(length);
    for (int i = 0; i < nOwned_; ++i) values_[i] = origin[static_cast<std::size_t>(i)] + step * direction[i];
    model.importGhosts(field_);
    evaluate(dt);
    for (int i = 0; i < nOwned_; ++i) image[i] = (rateAtOrigin[static_cast<std::size_t>(i)] - rate_[i]) / step;
  };
  std::vector<double> start = randomPointValues(model.discretization().globalIds, nOwned_, 1);
  for (const int point : heldPoints_) start[static_cast<std::size_t>(point)] = 0.0;
  const LargestEigenvalue result = largestEigenvalue(op, std::move(start), relativeTolerance, maximumIterations);

  std::copy(origin.begin(), origin.end(), values_);
  model.importGhosts(field_);
  return std::max(0.0, result.upperBound);
}

}  // namespace pd
