#include "bond_law_trial.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pd {

double growthRatio(const GrowthTrialCase& trial, const GrowthLaw& wanted, const BondLaw& law, double range,
                   TrialBody body) {
  const auto lossRate = [&](double strain) {
    const double read = strain * range / law.reading;
    const double growth = wanted(read);
    return growth > 0.0 ? law.factor.at(read) * growth : 0.0;
  };
  return trialGrowth(trial, lossRate, body) / wanted(range);
}

double improve(const GrowthTrialCase& trial, const GrowthLaw& wanted, BondLaw& law, TrialBody body,
               double correctedPart) {
  const std::vector<double>& ranges = law.factor.arguments;
  std::vector<double>& factors = law.factor.factors;
  std::vector<double> change;
  double largest = 0.0;
  for (const double range : ranges) {
    constexpr double most = 1.0;  // also where the crack stands that should grow
    const double deviation = std::log(std::max(growthRatio(trial, wanted, law, range, body), std::exp(-most)));
    largest = std::max(largest, std::abs(deviation));
    change.push_back(std::exp(-correctedPart * std::min(deviation, most)));
  }
  for (std::size_t k = 0; k < factors.size(); ++k) {
    factors[k] *= change[k];
    if (k > 0) factors[k] = std::max(factors[k], factors[k - 1] * wanted(ranges[k - 1]) / wanted(ranges[k]));
  }
  return largest;
}

double improveBetween(const GrowthTrialCase& trial, const GrowthLaw& wanted, BondLaw& law, TrialBody body,
                      double correctedPart) {
  constexpr double most = 1.0;  // also where the crack stands that should grow
  const std::vector<double>& ranges = law.factor.arguments;
  std::vector<double> deviations;  // at the ranges and half-way between them, in turn
  const auto look = [&](double range) {
    const double ratio = std::max(growthRatio(trial, wanted, law, range, body), std::exp(-most));
    deviations.push_back(std::min(std::log(ratio), most));
  };
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    if (k > 0) look(std::sqrt(ranges[k - 1] * ranges[k]));
    look(ranges[k]);
  }
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const std::size_t at = 2 * k;
    const double before = deviations[at > 0 ? at - 1 : at], after = deviations[std::min(at + 1, deviations.size() - 1)];
    law.factor.factors[k] *= std::exp(-correctedPart * (4.0 * deviations[at] + before + after) / 6.0);
  }
  double largest = 0.0;
  for (const double deviation : deviations) largest = std::max(largest, std::abs(deviation));
  return largest;
}

}  // namespace pd
