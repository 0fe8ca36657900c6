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
constexpr double wellBetween = 0.1;         ///< half-way between them: else further passes see to those, too
constexpr int mostThresholdPasses = 6;

/// The best of the laws that passes make of `law`.
template <class Improve>
BondLaw bestOf(BondLaw law, const Improve& improveOnce) {
  BondLaw best = law;
  double least = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < mostThresholdPasses && least > thresholdMet; ++pass) {
    LongWork::tell("trials for Paris Threshold, pass " + std::to_string(pass + 1) + " of at most " +
                   std::to_string(mostThresholdPasses));
    const BondLaw before = law;
    const double deviation = improveOnce(law);
    if (deviation < least) best = before;
    least = std::min(least, deviation);
  }
  return best;
}

ThresholdTrialResult findThresholdLaw(const GrowthTrialCase& trial) {
  const GrowthLaw wanted = [&](double range) { return range > 1.0 ? std::pow(range - 1.0, trial.exponent) : 0.0; };
  BondLaw first;
  first.reading = standingStrain(trial, TrialBody::Large);
  // Of a power: growth B (dK / (E' sqrt(delta)))^M of bonds that lose (their strain)^M.
  const double factorOfPower = std::pow(first.reading, trial.exponent) / growthTrial(trial).factor;
  first.factor.arguments = thresholdRanges;
  for (const double range : thresholdRanges) first.factor.factors.push_back(factorOfPower * (1.0 + 1.0 / range));

  ThresholdTrialResult result;
  const auto finish = [&](const BondLaw& law) {
    result.law = law;
    result.law.factor.arguments.push_back(farAboveThreshold);
    result.law.factor.factors.push_back(factorOfPower);
    result.deviation = 0.0;
    for (std::size_t k = 1; k < thresholdRanges.size(); ++k) {
      const double between = std::sqrt(thresholdRanges[k - 1] * thresholdRanges[k]);
      const double ratio = growthRatio(trial, wanted, result.law, between, TrialBody::Large);
      result.deviation = std::max(result.deviation, std::abs(ratio - 1.0));
    }
  };
  const BondLaw law = bestOf(first, [&](BondLaw& now) { return improve(trial, wanted, now, TrialBody::Large, 1.0); });
  finish(law);
  if (result.deviation > wellBetween) {
    const ThresholdTrialResult before = result;
    finish(bestOf(law, [&](BondLaw& now) { return improveBetween(trial, wanted, now, TrialBody::Large, 1.0); }));
    if (before.deviation < result.deviation) return before;
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
