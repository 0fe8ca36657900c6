// What cracks and voids need of planes, lines and boxes.
#ifndef PD_CONVEX_GEOMETRY_HPP
#define PD_CONVEX_GEOMETRY_HPP

#include "discontinuities.hpp"

namespace pd::decomposition {

PD_EACH_BOND kernels::Vector dot(const Place& a, const Places& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
PD_EACH_BOND kernels::Vector dot(const Places& a, const Places& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
PD_EACH_BOND Places minus(const Place& a, const Places& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
PD_EACH_BOND Places minus(const Places& a, const Place& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
PD_EACH_BOND Places times(const kernels::Vector& factor, const Places& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
PD_EACH_BOND Places crossed(const Places& a, const Places& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// The same place in all lanes.
inline Places inAllLanes(const Place& place) { return {place[0], place[1], place[2]}; }

/// Around all of `places`, one at least.
Box boxOf(const Corners& places);
Box boxOf(const std::vector<Place>& places);

/// By where they begin, by exchanges of neighbours.
inline void sortEach(std::vector<RangePerLane>& ranges) {
  for (std::size_t end = ranges.size(); end > 1; --end)
    for (std::size_t k = 0; k + 1 < end; ++k) {
      const RangePerLane one = ranges[k], two = ranges[k + 1];
      const unsigned char isTurned = kernels::greaterBits(one.low, two.low);
      ranges[k] = {kernels::choose(two.low, one.low, isTurned), kernels::choose(two.high, one.high, isTurned)};
      ranges[k + 1] = {kernels::choose(one.low, two.low, isTurned), kernels::choose(one.high, two.high, isTurned)};
    }
}

/// Are all places on one side of the plane through `origin`, to a tolerance in heights? `normal`: of length 1.
bool areOnOneSide(const Corners& places, const Place& origin, const Place& normal);

/// Keeps of each line's range from[r] to to[r] what lies in normal . (x - origin) <= offset.
void keepBelow(const Place& normal, const Place& origin, double offset, const Lines& lines, double* from, double* to);

/// Where a s^2 + 2 b s + c >= 0, as far as it is within `range`. What is asked for is one interval.
Range nonNegative(double a, double b, double c, Range range);

}  // namespace pd::decomposition

#endif
