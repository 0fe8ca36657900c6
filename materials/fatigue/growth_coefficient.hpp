// The growth coefficient of bonds from Paris' law.
#ifndef PD_GROWTH_COEFFICIENT_HPP
#define PD_GROWTH_COEFFICIENT_HPP

#include <string>
#include <vector>

#include "growth_lattice.hpp"
#include "life_law.hpp"
#include "threshold_trial.hpp"

namespace pd {

/// da/dN = C dK^M, or C (dK - dK_th)^M, with the lattice and the constants of the material.
class GrowthCoefficient {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// From a completed list with "Paris Coefficient". Throws std::invalid_argument, naming `owner`.
  GrowthCoefficient(const Teuchos::ParameterList& params, const std::string& owner);

  /// What a cycle takes of a bond near a crack tip.
  kernels::LifeLaw law() const;
  const GrowthLattice& lattice() const { return lattice_; }
  /// What it has found, and the growth that it predicts.
  std::vector<std::string> notes() const;

 private:
  void requireThresholdIsMet(const std::string& owner) const;
  double predicted(double range) const;
  double limit() const;  ///< of strain ranges

  GrowthLattice lattice_;
  double paris_, exponent_;  ///< m/cycle at 1 MPa sqrt(m); M
  GrowthTrialResult result_;
  ThresholdTrialResult threshold_;
  double thresholdRange_ = 0.0;  ///< dK_th, Pa sqrt(m)
  double coefficient_;           ///< A of d(lost life)/dN = A strain^M
};

}  // namespace pd

#endif
