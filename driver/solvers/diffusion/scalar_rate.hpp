// The rate of a scalar field as explicit integrators need it: prescribed points are held, the others follow the flux
// divergence.
#ifndef PD_SCALAR_RATE_HPP
#define PD_SCALAR_RATE_HPP

#include <string>
#include <vector>

#include "../../model/simulation.hpp"
#include "../lanczos.hpp"

namespace pd {

/// A view of one field and its flux divergence for the length of one increment: which points are held is read when it
/// is made.
class ScalarRate {
 public:
  /// Sets the held points to their values at time t. Collective.
  ScalarRate(Simulation& simulation, const std::string& field, double t);

  const std::string& field() const { return field_; }
  int nOwned() const { return nOwned_; }
  double* values() { return values_; }              ///< [points] owned first
  const double* rate() const { return rate_; }      ///< [points] of the last evaluation; complete at owned points
  long long nFreePoints() const { return nFree_; }  ///< over all ranks
  /// Owned points whose value is prescribed, ascending: no integrator's error is made there.
  const std::vector<int>& heldPoints() const { return heldPoints_; }
  double largestValue() const;      ///< max |value| over all ranks
  double largestHeldValue() const;  ///< the same over prescribed points, which no method can spoil
  const Communicator& comm() const { return simulation_.model.comm(); }

  /// Sets the held points to their values at time t and imports ghosts: owned values are new from here on.
  void hold(double t);
  /// rate() at the present values; zero at held points.
  void evaluate(double dt);

  /// Bound of the largest eigenvalue (1/s) of the rate, linearised about the present values, over the free points: the
  /// Ritz value of a Lanczos iteration plus its residual, which is at most `relativeTolerance` of it. Self-adjoint in
  /// the inner product weighted with volumes, as every pairwise conservative flux is. Leaves the values as they were.
  /// Collective.
  double largestEigenvalueBound(double dt, double relativeTolerance, int maximumIterations);

 private:
  Simulation& simulation_;
  std::string field_, fluxField_;
  int nOwned_;
  double *values_, *rate_;
  std::vector<int> heldPoints_;
  std::vector<double> heldValues_;
  bool dependsOnTime_;
  long long nFree_;
};

}  // namespace pd

#endif
