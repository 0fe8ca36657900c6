#include "element_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "long_work.hpp"

namespace pd {

namespace {

// Of the ranges at which growth is compared: their ratio, how far above the threshold and above yield they reach.
constexpr double rangeStep = 1.3, aboveThreshold = 1.1, aboveYield = 20.0;
constexpr double closeEnough = 0.05;  ///< of growth at all ranges
constexpr int mostPassesInAStrip = 8, mostPasses = 20;
constexpr double firstFactor = 2.5;  ///< what B and its fall with M come to for 3 spacings a horizon

/// g.
double wantedLoss(const ElementTrialCase& wanted, double range) {
  const double elementStrain = range * std::max(1.0, range);
  return std::pow(std::max(elementStrain - wanted.limit, 0.0), wanted.trial.exponent);
}

/// The best of some laws. Neighbouring ranges see what is corrected, too: part of it at a time, less in time.
BondLaw improved(const GrowthTrialCase& trial, const GrowthLaw& wanted, BondLaw law) {
  constexpr double firstPart = 0.8, lessEachTime = 0.95;
  if (trial.specimenWidth == 0.0)
    for (int pass = 0; pass < mostPassesInAStrip; ++pass)
      improveBetween(trial, wanted, law, TrialBody::Strip, firstPart);
  BondLaw best = law;
  double least = std::numeric_limits<double>::infinity(), part = firstPart;
  for (int pass = 0; pass < mostPasses && least > closeEnough; ++pass, part *= lessEachTime) {
    LongWork::tell("trials for Element Length, pass " + std::to_string(pass + 1) + " of at most " +
                   std::to_string(mostPasses));
    const BondLaw before = law;
    const double deviation = improveBetween(trial, wanted, law, TrialBody::Large, part);
    if (deviation < least) best = before;
    least = std::min(least, deviation);
  }
  return best;
}

ElementTrialResult findLaw(const ElementTrialCase& wanted) {
  const GrowthLaw growth = [&](double range) { return wantedLoss(wanted, range); };
  BondLaw law;
  law.reading = standingStrain(wanted.trial, TrialBody::Strip);
  std::vector<double>& ranges = law.factor.arguments;
  const double lowest = std::max(aboveThreshold * wanted.limit, 1.0 / aboveYield);
  double range = 1.0;
  while (range / rangeStep > lowest) range /= rangeStep;
  for (; range < aboveYield; range *= rangeStep) ranges.push_back(range);
  law.factor.factors.assign(ranges.size(), firstFactor);
  ElementTrialResult result{improved(wanted.trial, growth, law)};
  for (const double lower : ranges) {
    const double between = lower * std::sqrt(rangeStep);
    double& largest = between < 1.0 ? result.deviationBelowYield : result.deviationAboveYield;
    const double ratio = growthRatio(wanted.trial, growth, result.law, between, TrialBody::Large);
    largest = std::max(largest, std::abs(ratio - 1.0));
  }
  return result;
}

}  // namespace

const ElementTrialResult& elementTrial(const ElementTrialCase& wanted) {
  static std::map<std::vector<double>, ElementTrialResult> known;
  std::vector<double> key = keyOf(wanted.trial);
  key.push_back(wanted.limit);
  const auto found = known.find(key);
  return found != known.end() ? found->second : known.emplace(std::move(key), findLaw(wanted)).first->second;
}

}  // namespace pd
