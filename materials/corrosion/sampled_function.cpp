#include "sampled_function.hpp"

#include <algorithm>

namespace pd {

std::vector<double> SampledFunction::samples(double end, const std::function<double(double)>& f) {
  constexpr int intervals = 2000;
  std::vector<double> fine;
  for (int i = 0; i < 2 * intervals; ++i) fine.push_back(f(0.5 * end / intervals * i));
  fine.push_back(f(end));  // to the last bit: f may end there
  return fine;
}

SampledFunction::SampledFunction(double end, const std::vector<double>& fine) : end_(end) {
  const std::size_t last = fine.size() - 1;
  const double width = end / static_cast<double>(last / 2);
  for (std::size_t i = 0; i <= last; i += 2) {
    values_.push_back(fine[i]);
    // Second order, one-sided at the ends.
    const double slope = i == 0      ? -3.0 * fine[0] + 4.0 * fine[1] - fine[2]
                         : i == last ? 3.0 * fine[last] - 4.0 * fine[last - 1] + fine[last - 2]
                                     : fine[i + 1] - fine[i - 1];
    slopes_.push_back(slope / width);
  }
}

SampledFunction::Value SampledFunction::at(double place) const {
  const auto intervals = static_cast<double>(values_.size() - 1);
  const double width = end_ / intervals;
  const double x = std::clamp(place, 0.0, end_);
  const auto k = static_cast<std::size_t>(std::min(x / width, intervals - 1.0));
  const double t = std::min(x / width - static_cast<double>(k), 1.0), s = 1.0 - t;
  // Cubic Hermite polynomial.
  const double y0 = values_[k], y1 = values_[k + 1], m0 = slopes_[k] * width, m1 = slopes_[k + 1] * width;
  const double value = s * s * ((1.0 + 2.0 * t) * y0 + t * m0) + t * t * ((1.0 + 2.0 * s) * y1 - s * m1);
  const double slope = (6.0 * t * s * (y1 - y0) + s * (1.0 - 3.0 * t) * m0 + t * (3.0 * t - 2.0) * m1) / width;
  return {value, place >= 0.0 && place <= end_ ? slope : 0.0};
}

}  // namespace pd
