#include "threshold_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "long_work.hpp"

namespace pd {

namespace {

/// In parts of dK_th: where chi is found. It changes most where growth sets in.
const std::vector<double> thresholdRanges{1.08, 1.13, 1.18, 1.23, 1.29, 1.35, 1.42, 1.5, 1.63,
                                          1.8,  2.05, 2.4,  3.0,  4.0,  5.5,  8.0,  12.0};
constexpr double farAboveThreshold = 60.0;  ///< where chi is that of a power law, to 1 %
constexpr double thresholdMet = 0.02;       ///< to this part of growth at all of them: enough
constexpr int mostThresholdPasses = 6;

/// The best of some laws.
BondLaw bestThresholdLaw(const GrowthTrialCase& trial, const GrowthLaw& wanted) {
  BondLaw law, best;
  law.reading = standingStrain(trial, TrialBody::Large);
  // Of a power: growth B (dK / (E' sqrt(delta)))^M of bonds that lose (their strain)^M.
  const double factorOfPower = std::pow(law.reading, trial.exponent) / growthTrial(trial).factor;
  law.factor.arguments = thresholdRanges;
  for (const double range : thresholdRanges) law.factor.factors.push_back(factorOfPower * (1.0 + 1.0 / range));
  double least = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < mostThresholdPasses && least > thresholdMet; ++pass) {
    LongWork::tell("trials for Paris Threshold, pass " + std::to_string(pass + 1) + " of at most " +
                   std::to_string(mostThresholdPasses));
    const BondLaw before = law;
    const double deviation = improve(trial, wanted, law, TrialBody::Large, 1.0);
    if (deviation < least) best = before;
    least = std::min(least, deviation);
  }
  best.factor.arguments.push_back(farAboveThreshold);
  best.factor.factors.push_back(factorOfPower);
  return best;
}

ThresholdTrialResult findThresholdLaw(const GrowthTrialCase& trial) {
  const GrowthLaw wanted = [&](double range) { return range > 1.0 ? std::pow(range - 1.0, trial.exponent) : 0.0; };
  ThresholdTrialResult result;
  result.law = bestThresholdLaw(trial, wanted);
  for (std::size_t k = 1; k < thresholdRanges.size(); ++k) {
    const double between = std::sqrt(thresholdRanges[k - 1] * thresholdRanges[k]);
    const double ratio = growthRatio(trial, wanted, result.law, between, TrialBody::Large);
    result.deviation = std::max(result.deviation, std::abs(ratio - 1.0));
  }
  return result;
}

}  // namespace

const ThresholdTrialResult& thresholdTrial(const GrowthTrialCase& trial) {
  static std::map<std::vector<double>, ThresholdTrialResult> known;
  const std::vector<double> key = keyOf(trial);
  const auto found = known.find(key);
  return found != known.end() ? found->second : known.emplace(key, findThresholdLaw(trial)).first->second;
}

}  // namespace pd
