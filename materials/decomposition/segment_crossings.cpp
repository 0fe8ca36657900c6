#include "segment_crossings.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pd::decomposition {

namespace {

constexpr double halfPi = 1.57079632679489661923;

/// Gauss's rule on [0, 1].
constexpr std::size_t nNodes = 8;
constexpr std::array<double, nNodes> nodes{0.019855071751231912, 0.10166676129318664, 0.2372337950418355,
                                           0.4082826787521751,   0.5917173212478248,  0.7627662049581645,
                                           0.8983332387068134,   0.9801449282487681};
constexpr std::array<double, nNodes> weights{0.050614268145188344, 0.11119051722668717, 0.15685332293894352,
                                             0.18134189168918088,  0.18134189168918088, 0.15685332293894352,
                                             0.11119051722668717,  0.050614268145188344};

/// A plane cell in the coordinates in which it is |s| <= 1/2, |t| <= 1/2.
class PlaneCell {
 public:
  explicit PlaneCell(const Cell& cell) : center_(cell.center) {
    const Place &u = cell.edges[0], &v = cell.edges[1];
    area_ = u[0] * v[1] - u[1] * v[0];
    inverse_ = {v[1] / area_, -v[0] / area_, -u[1] / area_, u[0] / area_};
    area_ = std::abs(area_);
  }
  double area() const { return area_; }
  /// The range of distances r >= 0 at which from + r along is in the cell; along has the length 1.
  Range chord(const Place& from, const Place& along) const {
    Range range{0.0, 1e300};
    const double x = from[0] - center_[0], y = from[1] - center_[1];
    for (std::size_t k = 0; k < 2; ++k) {
      const double at = inverse_[2 * k] * x + inverse_[2 * k + 1] * y;
      const double slope = inverse_[2 * k] * along[0] + inverse_[2 * k + 1] * along[1];
      if (slope == 0.0) {
        if (std::abs(at) > 0.5) return {1.0, 0.0};
        continue;
      }
      const double first = (-0.5 - at) / slope, second = (0.5 - at) / slope;
      range.low = std::max(range.low, std::min(first, second));
      range.high = std::min(range.high, std::max(first, second));
    }
    return range;
  }

 private:
  Place center_;
  double area_ = 0.0;
  std::array<double, 4> inverse_{};
};

/// Pairs that cross at c, per length of a line across the normal, over all directions on the way from a to b.
class CrossingsAt {
 public:
  CrossingsAt(const Cell& a, const Cell& b)
      : a_(a), b_(b), cornersOfA_(a.corners()), cornersOfB_(b.corners()), forward_(minus(b.center, a.center)) {
    forward_ = plus({}, forward_, 1.0 / lengthOf(forward_));
  }

  double operator()(const Place& c, const Place& normal) const {
    // Along the segment |u x dc| has a kink.
    std::array<double, 11> breaks{-halfPi, halfPi, std::atan(dot(forward_, normal) / crossed(normal, forward_)[2])};
    std::size_t n = 3;
    for (std::size_t k = 0; k < 4; ++k)
      for (const Place& way : {minus(cornersOfB_[k], c), minus(c, cornersOfA_[k])}) {
        const double angle = std::atan2(crossed(forward_, way)[2], dot(forward_, way));
        if (std::abs(angle) < halfPi) breaks[n++] = angle;
      }
    std::sort(breaks.begin(), breaks.begin() + static_cast<std::ptrdiff_t>(n));
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const double width = breaks[k + 1] - breaks[k];
      if (width < 1e-14 || pairs(c, normal, breaks[k] + 0.5 * width) == 0.0) continue;
      for (std::size_t g = 0; g < nNodes; ++g)
        sum += weights[g] * width * pairs(c, normal, breaks[k] + nodes[g] * width);
    }
    return sum;
  }

 private:
  double pairs(const Place& c, const Place& normal, double angle) const {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const Place u{cosine * forward_[0] - sine * forward_[1], sine * forward_[0] + cosine * forward_[1], 0.0};
    const Range r = a_.chord(c, plus({}, u, -1.0)), s = b_.chord(c, u);
    if (r.low >= r.high || s.low >= s.high) return 0.0;
    return std::abs(dot(u, normal)) * 0.5 * (r.high - r.low) * (s.high - s.low) * (r.high + r.low + s.high + s.low);
  }

  PlaneCell a_, b_;
  Corners cornersOfA_, cornersOfB_;
  Place forward_;
};

/// The part of start + s (end - start), 0 <= s <= 1, that is within the box.
Range partWithin(const Box& box, const Place& start, const Place& along) {
  Range part{0.0, 1.0};
  for (std::size_t d = 0; d < 2; ++d) {
    if (along[d] == 0.0) continue;
    const double first = (box.low[d] - start[d]) / along[d], second = (box.high[d] - start[d]) / along[d];
    part.low = std::max(part.low, std::min(first, second));
    part.high = std::min(part.high, std::max(first, second));
  }
  return part;
}

}  // namespace

double shareAcrossSegment(const Cell& a, const Cell& b, const Place& start, const Place& end) {
  const Place along = minus(end, start);
  const double length = lengthOf(along);
  const Range part = partWithin(boxAround(a, b), start, along);
  if (part.low >= part.high) return 0.0;
  const Place normal{-along[1] / length, along[0] / length, 0.0};
  // Where lines through corners of both cells cross the segment the integrand has kinks: pieces of half a cell.
  const double edge = std::sqrt(lengthOf(a.edges[0]) * lengthOf(a.edges[1]));
  const auto nPieces = static_cast<int>(std::ceil(2.0 * (part.high - part.low) * length / edge));
  const double piece = (part.high - part.low) / nPieces;
  const CrossingsAt crossings(a, b);
  double sum = 0.0;
  for (int k = 0; k < nPieces; ++k)
    for (std::size_t g = 0; g < nNodes; ++g) {
      const double s = part.low + piece * (k + nodes[g]);
      sum += weights[g] * piece * length * crossings(plus(start, along, s), normal);
    }
  return sum / (PlaneCell(a).area() * PlaneCell(b).area());
}

}  // namespace pd::decomposition
