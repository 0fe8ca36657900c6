// Growth of a crack from a strain-life relation alone: one element of material after another fails at its tip.
#ifndef PD_FATIGUE_ELEMENT_HPP
#define PD_FATIGUE_ELEMENT_HPP

#include <string>
#include <vector>

#include "element_trial.hpp"
#include "growth_lattice.hpp"
#include "strain_life.hpp"

namespace pd {

/// The element has the length r, far below the spacing of points. Its strain range is that of the elastic field at the
/// distance r, d_sigma = dK / sqrt(2 pi r), by the rule of Neuber, and
///   da/dN = r / N(strain range of the element).
/// A bond near the tip with the strain range e reads a range of K from it, and loses r/delta of what an element loses
/// at that range, times a factor that trials on the lattice find (element_trial.hpp): then the crack grows as wanted.
class FatigueElement {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// From a completed list with "Element Length". Throws std::invalid_argument, naming `owner`.
  FatigueElement(const Teuchos::ParameterList& params, const kernels::StrainLife& life, const std::string& owner);

  const GrowthLattice& lattice() const { return lattice_; }
  /// Of the life of a bond of this strain range near a crack tip.
  double lossRate(double bondStrainRange, const kernels::StrainLife& life) const;
  /// da/dN, m, at a range of K in Pa sqrt(m).
  double growth(double intensityRange, const kernels::StrainLife& life) const;
  /// The same as a trial on the lattice finds it.
  double trialGrowth(double intensityRange, const kernels::StrainLife& life) const;
  std::string note(const kernels::StrainLife& life) const;

 private:
  double rangeOfWings(const kernels::StrainLife& life) const;  ///< Pa sqrt(m)

  GrowthLattice lattice_;
  double length_, yieldStrain_;  ///< r, m; sigma_y / E
  double elasticStrain_;         ///< dK / (E sqrt(2 pi r)) at 1 Pa sqrt(m)
  ElementTrialResult bonds_;
};

}  // namespace pd

#endif
