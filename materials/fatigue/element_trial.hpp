// What bonds near a crack tip must lose so that the crack grows as elements of material at its tip fail.
#ifndef PD_ELEMENT_TRIAL_HPP
#define PD_ELEMENT_TRIAL_HPP

#include "bond_law_trial.hpp"

namespace pd {

/// Ranges x of K are in parts of that at which the element yields, strain ranges z in parts of its strain range there:
/// z = x up to 1, x^2 above (Neuber). The crack is to grow as g(x) = (z - limit)^m. A bond of the strain range e reads
/// x = e E' sqrt(delta) / k, with k such that the last bond which holds a crack at its threshold reads it right, and
/// loses chi(x) g(x).
struct ElementTrialCase {
  GrowthTrialCase trial;  ///< of the exponent m
  double limit = 0.0;     ///< below 1
};

struct ElementTrialResult {
  BondLaw law;
  /// Largest of growth from g, half-way between these ranges below and above yield; parts of it.
  double deviationBelowYield = 0.0, deviationAboveYield = 0.0;
};

/// k by standingStrain(), chi by trials that are repeated until growth is right at all ranges, or nearly so: bonds
/// break in another order with each law. Once in a process for each case. Throws as growthTrial() does.
const ElementTrialResult& elementTrial(const ElementTrialCase& wanted);

}  // namespace pd

#endif
