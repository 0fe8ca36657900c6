// The growth coefficient of bonds from Paris' law.
#ifndef PD_GROWTH_COEFFICIENT_HPP
#define PD_GROWTH_COEFFICIENT_HPP

#include <cmath>
#include <string>
#include <vector>

#include "bond_family.hpp"
#include "growth_trial.hpp"
#include "life_law.hpp"

namespace pd {

/// da/dN = C dK^M, or C (dK - dK_th)^M, with the lattice and the constants of the material.
class GrowthCoefficient {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// From a completed list with "Paris Coefficient". Throws std::invalid_argument, naming `owner`.
  GrowthCoefficient(const Teuchos::ParameterList& params, const std::string& owner);

  /// What a cycle takes of a bond near a crack tip.
  kernels::LifeLaw law() const;
  double spacing() const { return spacing_; }  ///< m, of the lattice of the trial
  const BondFamily& family() const { return family_; }
  /// What it has found, and the growth that it predicts.
  std::vector<std::string> notes() const;

 private:
  std::vector<LatticeBond> latticeBonds(const std::string& owner) const;
  double strainAt(double range) const { return range / (modulus_ * std::sqrt(family_.horizon)); }
  double predicted(double range) const;

  BondFamily family_;
  double spacing_, paris_;  ///< m; m/cycle at 1 MPa sqrt(m)
  GrowthTrialCase trial_;
  GrowthTrialResult result_;
  GrowthThreshold threshold_;
  double thresholdRange_ = 0.0;               ///< dK_th, Pa sqrt(m)
  double modulus_ = 0.0, coefficient_ = 0.0;  ///< E' of the lattice, Pa; A of d(lost life)/dN = A strain^M
  bool hasTangential_ = false;
};

}  // namespace pd

#endif
