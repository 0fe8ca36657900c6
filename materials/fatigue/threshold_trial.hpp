// What bonds near a crack tip must lose so that the crack grows as C (dK - dK_th)^M.
#ifndef PD_THRESHOLD_TRIAL_HPP
#define PD_THRESHOLD_TRIAL_HPP

#include "bond_law_trial.hpp"

namespace pd {

struct ThresholdTrialResult {
  /// For g(x) = (x - 1)^M, x in parts of dK_th. The reading is that of the bond that a crack at its threshold stands
  /// at; far above it chi is what makes the power law of growthTrial().
  BondLaw law;
  double deviation = 0.0;  ///< largest of growth from g, half-way between ranges from 1.08 to 12; part of it
};

/// By some hundred and fifty trials in a body large beside the horizon, 0.5 s for 3 spacings a horizon. Once in a
/// process for each case. Throws as growthTrial() does.
const ThresholdTrialResult& thresholdTrial(const GrowthTrialCase& trial);

}  // namespace pd

#endif
