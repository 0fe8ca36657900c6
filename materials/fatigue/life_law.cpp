#include "life_law.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

namespace pd::kernels {

double FactorTable::at(double argument) const {
  if (factors.empty()) return 1.0;
  const auto next = std::upper_bound(arguments.begin(), arguments.end(), argument);
  if (next == arguments.begin()) return factors.front();
  if (next == arguments.end()) return factors.back();
  const auto k = static_cast<std::size_t>(next - arguments.begin());
  const double part = std::log(argument / arguments[k - 1]) / std::log(arguments[k] / arguments[k - 1]);
  return factors[k - 1] * std::pow(factors[k] / factors[k - 1], part);
}

LifeLaw LifeLaw::power(double coefficient, double exponent, double limit, FactorTable factors) {
  LifeLaw law;
  law.coefficient_ = coefficient;
  law.exponent_ = exponent;
  law.limit_ = limit;
  law.factors_ = std::move(factors);
  return law;
}

LifeLaw LifeLaw::table(const std::vector<double>& lives, const std::vector<double>& strainRanges, double limit) {
  const bool isRising = std::adjacent_find(lives.begin(), lives.end(), std::greater_equal<>()) == lives.end();
  const bool isFalling =
      std::adjacent_find(strainRanges.begin(), strainRanges.end(), std::less_equal<>()) == strainRanges.end();
  if (lives.size() != strainRanges.size() || lives.size() < 2 || !isRising || !isFalling || !(lives.front() > 0.0) ||
      !(strainRanges.back() > 0.0))
    throw std::invalid_argument(
        "a strain-life table needs as many lives (rising, in cycles) as strain ranges (falling), two or more, all "
        "above "
        "0");
  LifeLaw law;
  law.limit_ = limit;
  for (std::size_t k = lives.size() - 1; k > 0; --k) {
    const double exponent = std::log(lives[k] / lives[k - 1]) / std::log(strainRanges[k - 1] / strainRanges[k]);
    law.segments_.push_back({strainRanges[k], -std::log(lives[k]) - exponent * std::log(strainRanges[k]), exponent});
  }
  return law;
}

double LifeLaw::rate(double strainRange) const {
  if (!(strainRange > limit_)) return 0.0;
  if (segments_.empty()) {
    const double power = coefficient_ * std::pow(strainRange - limit_, exponent_);
    return factors_.factors.empty() ? power : factors_.at(strainRange / limit_) * power;
  }
  std::size_t k = segments_.size() - 1;
  while (k > 0 && strainRange < segments_[k].from) --k;
  return std::exp(segments_[k].logRate + segments_[k].exponent * std::log(strainRange));
}

}  // namespace pd::kernels
