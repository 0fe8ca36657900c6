// Boxes and half-spaces: what all forms of screens are made of.
#ifndef PD_DECOMPOSITION_HALF_SPACES_HPP
#define PD_DECOMPOSITION_HALF_SPACES_HPP

#include <algorithm>
#include <limits>
#include <vector>

#include "discontinuities.hpp"

namespace pd::decomposition {

constexpr double everywhere = std::numeric_limits<double>::infinity();

inline Box boxOf(const std::vector<Place>& places) {
  Box box{places.front(), places.front()};
  for (const Place& place : places)
    for (std::size_t d = 0; d < 3; ++d) {
      box.low[d] = std::min(box.low[d], place[d]);
      box.high[d] = std::max(box.high[d], place[d]);
    }
  return box;
}

/// The corners of two cells, between which all their connections are.
inline std::vector<Place> cornersOf(const Cell& a, const Cell& b) {
  std::vector<Place> corners = a.corners();
  for (const Place& corner : b.corners()) corners.push_back(corner);
  return corners;
}

/// Are all places on one side of the plane through `origin`, to a tolerance in heights? `normal`: of length 1.
inline bool areOnOneSide(const std::vector<Place>& places, const Place& origin, const Place& normal) {
  const double tolerance = 1e-9 * lengthOf(minus(places.front(), places.back()));
  double low = everywhere, high = -everywhere;
  for (const Place& place : places) {
    const double height = dot(minus(place, origin), normal);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  return low > -tolerance || high < tolerance;
}

/// Keeps of each range what lies on the positive side of the plane through `apex`.
inline void keepPositive(const Place& normal, const Place& apex, const Lines& lines, double* from, double* to) {
  const std::size_t n = lines.size();
  const double *x = lines.start[0].data(), *y = lines.start[1].data(), *z = lines.start[2].data();
  const double atApex = dot(normal, apex), slope = dot(normal, lines.step);
  const double perSlope = slope == 0.0 ? 0.0 : -1.0 / slope;
  const auto height = [&](std::size_t r) { return normal[0] * x[r] + normal[1] * y[r] + normal[2] * z[r] - atApex; };
  if (slope > 0.0) {
    for (std::size_t r = 0; r < n; ++r) {
      const double s = height(r) * perSlope;
      from[r] = from[r] < s ? s : from[r];
    }
  } else if (slope < 0.0) {
    for (std::size_t r = 0; r < n; ++r) {
      const double s = height(r) * perSlope;
      to[r] = to[r] < s ? to[r] : s;
    }
  } else {
    for (std::size_t r = 0; r < n; ++r)
      if (height(r) < 0.0) to[r] = -everywhere;
  }
}

}  // namespace pd::decomposition

#endif
