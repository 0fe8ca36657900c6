#include "element_trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace pd {

namespace {

// Of the ranges at which growth is compared: their ratio, how far above the threshold and above yield they reach.
constexpr double rangeStep = 1.3, aboveThreshold = 1.1, aboveYield = 20.0;
// Part of a deviation that is made up for at a time, since neighbouring ranges see it, too; when there is enough of it.
constexpr double correctedPart = 0.5, closeEnough = 0.03;
constexpr int mostPassesInAStrip = 8, passesInALargeBody = 6;
constexpr double firstFactor = 2.5;  ///< what B and its fall with M come to for 3 spacings a horizon

/// g.
double wantedLoss(const ElementTrialCase& wanted, double range) {
  const double elementStrain = range * std::max(1.0, range);
  return std::pow(std::max(elementStrain - wanted.limit, 0.0), wanted.trial.exponent);
}

/// d ln g / d ln x, from below.
double slope(const ElementTrialCase& wanted, double range) {
  const double elementStrain = range * std::max(1.0, range);
  return (range > 1.0 ? 2.0 : 1.0) * wanted.trial.exponent * elementStrain / (elementStrain - wanted.limit);
}

/// Growth at a range over what is wanted there.
double growthRatio(const ElementTrialCase& wanted, const ElementTrialResult& law, double range, TrialBody body) {
  const auto lossRate = [&](double strain) {
    const double read = strain * range / law.reading;
    return law.factor(read) * wantedLoss(wanted, read);
  };
  return trialGrowth(wanted.trial, lossRate, body) / wantedLoss(wanted, range);
}

/// Corrects each factor as if the others were right, and so that bonds lose more at larger ranges. Returns the largest
/// deviation before, a logarithm.
double improve(const ElementTrialCase& wanted, ElementTrialResult& law, TrialBody body) {
  std::vector<double> change;
  double largest = 0.0;
  for (const double range : law.ranges) {
    constexpr double most = 1.0;  // also where the crack stands that should grow
    const double deviation = std::log(std::max(growthRatio(wanted, law, range, body), std::exp(-most)));
    largest = std::max(largest, std::abs(deviation));
    change.push_back(std::exp(-correctedPart * std::min(deviation, most)));
  }
  for (std::size_t k = 0; k < change.size(); ++k) {
    law.factors[k] *= change[k];
    if (k > 0)
      law.factors[k] =
          std::max(law.factors[k], law.factors[k - 1] * std::pow(rangeStep, -slope(wanted, law.ranges[k])));
  }
  return largest;
}

/// The best of some laws.
ElementTrialResult improved(const ElementTrialCase& wanted, ElementTrialResult law) {
  for (int pass = 0; pass < mostPassesInAStrip; ++pass)
    if (improve(wanted, law, TrialBody::Strip) < closeEnough) break;
  ElementTrialResult best = law;
  double least = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < passesInALargeBody; ++pass) {
    const ElementTrialResult before = law;
    const double deviation = improve(wanted, law, TrialBody::Large);
    if (deviation < least) best = before;
    least = std::min(least, deviation);
  }
  return best;
}

ElementTrialResult findLaw(const ElementTrialCase& wanted) {
  ElementTrialResult law;
  law.reading = standingStrain(wanted.trial);
  const double lowest = std::max(aboveThreshold * wanted.limit, 1.0 / aboveYield);
  double range = 1.0;
  while (range / rangeStep > lowest) range /= rangeStep;
  for (; range < aboveYield; range *= rangeStep) law.ranges.push_back(range);
  law.factors.assign(law.ranges.size(), firstFactor);
  law = improved(wanted, std::move(law));
  for (const double lower : law.ranges) {
    const double between = lower * std::sqrt(rangeStep);
    double& largest = between < 1.0 ? law.deviationBelowYield : law.deviationAboveYield;
    largest = std::max(largest, std::abs(growthRatio(wanted, law, between, TrialBody::Large) - 1.0));
  }
  return law;
}

}  // namespace

double ElementTrialResult::factor(double range) const {
  const auto next = std::upper_bound(ranges.begin(), ranges.end(), range);
  if (next == ranges.begin()) return factors.front();
  if (next == ranges.end()) return factors.back();
  const auto k = static_cast<std::size_t>(next - ranges.begin());
  const double part = std::log(range / ranges[k - 1]) / std::log(ranges[k] / ranges[k - 1]);
  return factors[k - 1] * std::pow(factors[k] / factors[k - 1], part);
}

const ElementTrialResult& elementTrial(const ElementTrialCase& wanted) {
  static std::map<std::vector<double>, ElementTrialResult> known;
  std::vector<double> key = keyOf(wanted.trial);
  key.push_back(wanted.limit);
  const auto found = known.find(key);
  return found != known.end() ? found->second : known.emplace(std::move(key), findLaw(wanted)).first->second;
}

}  // namespace pd
