// The lattice of a block, as the trials see it that let a crack grow through it.
#ifndef PD_GROWTH_LATTICE_HPP
#define PD_GROWTH_LATTICE_HPP

#include <cmath>
#include <string>
#include <vector>

#include "bond_family.hpp"
#include "growth_trial.hpp"

namespace pd {

class GrowthLattice {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// The keys of declareParameters() without which there is no trial.
  static std::vector<std::string> neededKeys();
  /// From a completed list. Throws std::invalid_argument, naming `owner`; `otherwise`: what to do where there can be
  /// no trial, as in "give Growth Coefficient and Growth Exponent".
  GrowthLattice(const Teuchos::ParameterList& params, const std::string& owner, const std::string& otherwise);

  /// Of bonds that lose a power of their strain ranges.
  GrowthTrialCase trial(double exponent) const;
  double horizon() const { return family_.horizon; }  ///< m
  double modulus() const { return modulus_; }         ///< E', Pa: plane stress, or plane strain and in space
  /// dK / (E' sqrt(delta)), dK in Pa sqrt(m).
  double strainAt(double intensityRange) const { return intensityRange / (modulus_ * std::sqrt(family_.horizon)); }
  /// Throws std::invalid_argument where the shortest bond of the block is not as long as the lattice's.
  void requireSpacing(const Call& call, const double* modelCoordinates) const;
  /// "3 spacings a horizon, E' = 2.1e+11 Pa of the lattice".
  std::string text() const;

 private:
  std::vector<LatticeBond> latticeBonds() const;
  void setSpecimenWidth(double width);  ///< m

  std::string owner_, otherwise_;
  BondFamily family_;
  double spacing_;  ///< m
  GrowthTrialCase trial_;
  double modulus_ = 0.0;
  bool hasTangential_ = false;
};

}  // namespace pd

#endif
