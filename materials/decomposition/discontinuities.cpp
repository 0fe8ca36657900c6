#include "discontinuities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "convex_geometry.hpp"

namespace pd::decomposition {

Corners Cell::corners() const {
  Corners result;
  result.add(center);
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    const std::size_t n = result.size();
    for (std::size_t c = 0; c < n; ++c) {
      const Place middle = result[c];
      result[c] = plus(middle, edges[k], -0.5);
      result.add(plus(middle, edges[k], 0.5));
    }
  }
  return result;
}

Corners cornersOf(const Cell& a, const Cell& b) {
  Corners corners = a.corners();
  for (const Place& corner : b.corners()) corners.add(corner);
  return corners;
}

bool Box::meets(const Box& other) const {
  for (std::size_t d = 0; d < 3; ++d)
    if (low[d] > other.high[d] || high[d] < other.low[d]) return false;
  return true;
}

RangePerLane Screen::meet(const LinePerLane&) const {
  throw std::logic_error("a screen in space has no lines in a plane");
}
Range Screen::heights(const Place&) const { throw std::logic_error("a screen in space has no heights in a plane"); }
void Void::addWithinEach(const LinePerLane&, std::vector<RangePerLane>&) const {
  throw std::logic_error("a void in space has no lines in a plane");
}

namespace {

template <class List>
Box boxOfAll(const List& places) {
  Box box{places[0], places[0]};
  for (const Place& place : places)
    for (std::size_t d = 0; d < 3; ++d) {
      box.low[d] = std::min(box.low[d], place[d]);
      box.high[d] = std::max(box.high[d], place[d]);
    }
  return box;
}

}  // namespace

Box boxOf(const Corners& places) { return boxOfAll(places); }
Box boxOf(const std::vector<Place>& places) { return boxOfAll(places); }
std::string complaintOfCrack(const Box& box, int dimension, double spacing) {
  constexpr double most = 1e6;  // spacings
  double longest = 0.0;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
    longest = std::max(longest, box.high[d] - box.low[d]);
  if (longest <= most * spacing) return "";
  std::ostringstream text;
  text.precision(4);
  text << "is " << longest << " m long, more than " << most << " spacings of " << spacing
       << " m, so that its end would be off by rounding; let it end just outside of the body";
  return text.str();
}

std::string complaintOfVoid(const Void& v, double spacing) {
  constexpr double least = 1e-6;  // of the spacing
  if (v.inradius() >= least * spacing) return "";
  std::ostringstream text;
  text.precision(4);
  text << "is too small: half of its smallest width must be " << least << " of the spacing of " << spacing
       << " m or more; leave it out, or see its unit";
  return text.str();
}

Box boxAround(const Cell& a, const Cell& b) { return boxOf(cornersOf(a, b)); }

bool areOnOneSide(const Corners& places, const Place& origin, const Place& normal) {
  const double tolerance = 1e-9 * lengthOf(minus(places[0], places[places.size() - 1]));
  bool isBelow = true, isAbove = true;
  for (const Place& place : places) {
    const double height = dot(minus(place, origin), normal);
    isAbove = isAbove && height > -tolerance;
    isBelow = isBelow && height < tolerance;
  }
  return isAbove || isBelow;
}

void keepBelow(const Place& normal, const Place& origin, double offset, const Lines& lines, double* from, double* to) {
  const std::size_t n = lines.size();
  const double *x = lines.start[0].data(), *y = lines.start[1].data(), *z = lines.start[2].data();
  const double limit = offset + dot(normal, origin), slope = dot(normal, lines.step);
  const double perSlope = slope == 0.0 ? 0.0 : 1.0 / slope;
  const auto depth = [&](std::size_t r) { return limit - (normal[0] * x[r] + normal[1] * y[r] + normal[2] * z[r]); };
  if (slope < 0.0) {
    for (std::size_t r = 0; r < n; ++r) {
      const double s = depth(r) * perSlope;
      from[r] = from[r] < s ? s : from[r];
    }
  } else if (slope > 0.0) {
    for (std::size_t r = 0; r < n; ++r) {
      const double s = depth(r) * perSlope;
      to[r] = to[r] < s ? to[r] : s;
    }
  } else {
    for (std::size_t r = 0; r < n; ++r)
      if (depth(r) < 0.0) to[r] = -std::numeric_limits<double>::infinity();
  }
}

/// Where a s^2 + 2 b s + c >= 0, as far as it is within `range`. What is asked for is one interval.
Range nonNegative(double a, double b, double c, Range range) {
  const Range nothing{1.0, 0.0};
  const double discriminant = b * b - a * c;
  if (a == 0.0) {
    if (b == 0.0) return c >= 0.0 ? range : nothing;
    const double root = -0.5 * c / b;
    return b > 0.0 ? Range{std::max(range.low, root), range.high} : Range{range.low, std::min(range.high, root)};
  }
  if (discriminant <= 0.0) return a > 0.0 ? range : nothing;
  // Without differences of nearly equal numbers.
  const double q = -(b + std::copysign(std::sqrt(discriminant), b));
  double first = q / a, second = q == 0.0 ? 0.0 : c / q;
  if (first > second) std::swap(first, second);
  if (a < 0.0) return {std::max(range.low, first), std::min(range.high, second)};
  const Range before{range.low, std::min(range.high, first)}, after{std::max(range.low, second), range.high};
  return before.high - before.low > after.high - after.low ? before : after;
}

}  // namespace pd::decomposition
