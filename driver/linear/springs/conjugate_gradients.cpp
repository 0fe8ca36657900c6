#include "conjugate_gradients.hpp"

#include <cmath>

namespace pd {

namespace {

// The recurrence drifts away from the true residual by what rounding leaves of a stiff body's forces. Down to this
// tolerance that is nothing.
constexpr double driftless = 1e-6;

class Vectors {
 public:
  Vectors(const Communicator& comm, int nOwned) : comm_(comm), n_(nOwned) {}

  double dot(const PointVector<double>& a, const PointVector<double>& b) const { return comm_.sum(pd::dot(a, b, n_)); }
  /// y = factor y + share x
  void combine(PointVector<double>& y, double factor, const PointVector<double>& x, double share) const {
    for (int c = 0; c < y.nComponents(); ++c) {
      double* to = y[c];
      const double* from = x[c];
      for (int i = 0; i < n_; ++i) to[i] = factor * to[i] + share * from[i];
    }
  }

 private:
  const Communicator& comm_;
  int n_;
};

}  // namespace

ConjugateGradientsResult conjugateGradients(const Communicator& comm, int nOwned, const PointMap& product,
                                            const PointMap& precondition, const PointVector<double>& b,
                                            PointVector<double>& x, double tolerance, int maximumIterations) {
  const Vectors v(comm, nOwned);
  ConjugateGradientsResult result;
  const double normOfB = std::sqrt(v.dot(b, b));
  x.zero();
  if (normOfB == 0.0) {
    result.relativeResidual = 0.0;
    return result;
  }
  PointVector<double> r = b, z = b, direction(b.nPoints(), b.nComponents()), image = direction;
  const auto trueResidual = [&] {
    product(x, image);
    r = b;
    v.combine(r, 1.0, image, -1.0);
    return std::sqrt(v.dot(r, r)) / normOfB;
  };
  double before = HUGE_VAL;
  while (true) {
    // Where the recurrence has drifted away from the true residual, it starts again from what it has.
    double curvature = 0.0, residual = std::sqrt(v.dot(r, r)) / normOfB;
    for (bool isFirst = true; residual > tolerance && result.iterations < maximumIterations; isFirst = false) {
      precondition(r, z);
      v.combine(direction, isFirst ? 0.0 : -v.dot(z, image) / curvature, z, 1.0);
      product(direction, image);
      curvature = v.dot(direction, image);
      const double gain = v.dot(direction, r);
      if (!(gain > 0.0) || !(curvature > 0.0) || !std::isfinite(gain) || !std::isfinite(curvature)) {
        result.hasBrokenDown = true;
        return result;
      }
      v.combine(x, 1.0, direction, gain / curvature);
      v.combine(r, 1.0, image, -gain / curvature);
      residual = std::sqrt(v.dot(r, r)) / normOfB;
      ++result.iterations;
    }
    result.relativeResidual = residual;
    if (tolerance >= driftless) return result;
    result.relativeResidual = trueResidual();
    if (result.relativeResidual <= tolerance || result.iterations >= maximumIterations ||
        !(result.relativeResidual < 0.5 * before))
      return result;
    before = result.relativeResidual;
  }
}

}  // namespace pd
