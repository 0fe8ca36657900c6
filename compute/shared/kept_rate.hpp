// How fast a result grows, for computes that keep what they are compared with in a field.
#ifndef PD_KEPT_RATE_HPP
#define PD_KEPT_RATE_HPP

#include <optional>
#include <stdexcept>
#include <string>

namespace pd {

/// Growth of `value` per second since the evaluation that `kept` [3] is of: its value, its time, s, and 1 where there
/// was one; 0 at the first evaluation, and nothing where one is repeated. Keeps this one, unless `keepsFirst` and there
/// is one. Throws std::runtime_error with `complaint` where the value has changed, but not the time.
inline std::optional<double> keptRate(double* kept, double value, double time, bool keepsFirst,
                                      const std::string& complaint) {
  const bool isFirst = kept[2] == 0.0;
  if (!isFirst && time == kept[1]) {
    if (value == kept[0]) return std::nullopt;
    throw std::runtime_error(complaint);
  }
  const double rate = isFirst ? 0.0 : (value - kept[0]) / (time - kept[1]);
  if (!isFirst && keepsFirst) return rate;
  kept[0] = value;
  kept[1] = time;
  kept[2] = 1.0;
  return rate;
}

}  // namespace pd

#endif
