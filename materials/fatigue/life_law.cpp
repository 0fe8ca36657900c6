#include "life_law.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace pd::kernels {

LifeLaw LifeLaw::power(double coefficient, double exponent, double limit, double sharpness) {
  LifeLaw law;
  law.coefficient_ = coefficient;
  law.exponent_ = exponent;
  law.limit_ = limit;
  law.sharpness_ = sharpness;
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
    const double excess =
        sharpness_ == 1.0 ? strainRange - limit_ : strainRange * (1.0 - std::pow(limit_ / strainRange, sharpness_));
    return coefficient_ * std::pow(excess, exponent_);
  }
  std::size_t k = segments_.size() - 1;
  while (k > 0 && strainRange < segments_[k].from) --k;
  return std::exp(segments_[k].logRate + segments_[k].exponent * std::log(strainRange));
}

}  // namespace pd::kernels
