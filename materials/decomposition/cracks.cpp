#include <algorithm>
#include <cmath>

#include "convex_geometry.hpp"
#include "discontinuities.hpp"

namespace pd::decomposition {

namespace stdx = kernels::stdx;
using kernels::choose;
using kernels::greaterBits;
using kernels::Vector;
using kernels::wherePositive;

namespace {

/// Of the length of a side: what is so near to a rim is on it.
constexpr double rimTolerance = 1e-9;

/// A flat crack: hidden is what lies behind it, within the cone over its outline.
class FlatScreen : public Screen {
 public:
  FlatScreen(const Place& origin, const Place& normal, double size)
      : origin_(origin), normal_(plus({}, normal, 1.0 / lengthOf(normal))), tolerance_(1e-12 * size) {}

  void hide(const Place& place, const Lines& lines, double* from, double* to) const override {
    std::fill(from, from + lines.size(), 0.0);
    std::fill(to, to + lines.size(), 1.0);
    std::vector<HalfSpace> shadow;
    addShadow(inAllLanes(place), place, shadow);
    for (const HalfSpace& half : shadow)
      keepBelow({half.normal[0][0], half.normal[1][0], half.normal[2][0]}, place, half.offset[0], lines, from, to);
  }
  bool addShadow(const Places& places, const Place& origin, std::vector<HalfSpace>& shadow) const override {
    const Vector height = dot(normal_, minus(places, origin_)), tolerance(tolerance_);
    // Those on the crack are moved to the side that its normal points to.
    const Vector lift = wherePositive(tolerance - stdx::abs(height), tolerance - height, 0.0);
    const Vector sign = wherePositive(height + lift, 1.0, -1.0);
    shadow.push_back({times(sign, inAllLanes(normal_)), sign * dot(normal_, minus(origin_, origin))});
    Places apices;
    for (std::size_t d = 0; d < 3; ++d) apices[d] = places[d] + lift * normal_[d];
    addCone(apices, sign, origin, shadow);
    return true;
  }

  bool isAbove(const Place& place) const override { return heightOf(place) >= -tolerance_; }
  bool divides(const Cell& a, const Cell& b) const override {
    const Corners corners = cornersOf(a, b);
    std::array<double, 16> heights;
    for (std::size_t k = 0; k < corners.size(); ++k) heights[k] = heightOf(corners[k]);
    for (std::size_t k = 0; k < corners.size(); ++k)
      for (std::size_t l = 0; l < k; ++l) {
        if ((heights[k] > 0.0) == (heights[l] > 0.0)) continue;
        const double s = heights[k] / (heights[k] - heights[l]);
        if (!covers(plus(corners[k], minus(corners[l], corners[k]), s))) return false;
      }
    return true;
  }

 protected:
  double heightOf(const Place& place) const { return dot(minus(place, origin_), normal_); }
  /// Whether a place in its plane is on the crack, or on its rim: cracks begin at the faces of bodies.
  virtual bool covers(const Place& place) const = 0;
  /// Adds the half-spaces of the cones from `apices` over the outline; sign: 1 above the crack, -1 below.
  virtual void addCone(const Places&, const Vector& /*sign*/, const Place& /*origin*/, std::vector<HalfSpace>&) const {}

  Place origin_, normal_;
  double tolerance_;
};

class SegmentScreen : public FlatScreen {
 public:
  SegmentScreen(const Place& a, const Place& b)
      : FlatScreen(a, {a[1] - b[1], b[0] - a[0], 0.0}, lengthOf(minus(b, a))), a_(a), b_(b) {}

  bool isBetween(const Cell& a, const Cell& b) const override {
    const Corners corners = cornersOf(a, b);
    const Place along = minus(b_, a_);
    if (areOnOneSide(corners, origin_, normal_)) return false;
    const auto isBeyond = [&](const Place& end, const Place& outwards) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Place& corner) { return dot(minus(corner, end), outwards) > 0.0; });
    };
    return !isBeyond(b_, along) && !isBeyond(a_, minus(a_, b_));
  }
  Box box() const override {
    Corners ends;
    ends.add(a_);
    ends.add(b_);
    return boxOf(ends);
  }
  PD_INLINES RangePerLane meet(const LinePerLane& lines) const override {
    const Vector slope = dot(normal_, lines.step), height = dot(normal_, minus(lines.start, origin_));
    const unsigned char isAcross = greaterBits(stdx::abs(slope), 1e-300);
    const Vector s = -height / choose(slope, 1.0, isAcross);
    const Place along = minus(b_, a_);
    const double length2 = dot(along, along);
    const Vector foot = dot(along, minus(lines.start, a_)) + s * dot(along, lines.step);
    const auto isMet = static_cast<unsigned char>(isAcross & greaterBits(foot, -rimTolerance * length2) &
                                                  greaterBits((1.0 + rimTolerance) * length2, foot));
    return {choose(s, beyondAll, isMet), choose(s, -beyondAll, isMet)};
  }
  Range heights(const Place& axis) const override {
    const double a = dot(a_, axis), b = dot(b_, axis);
    return {std::min(a, b), std::max(a, b)};
  }
  std::optional<bool> cuts(const Place& p, const Place& q, TipRule rule) const override {
    const double heightP = dot(minus(p, origin_), normal_), heightQ = dot(minus(q, origin_), normal_);
    if ((heightP >= 0.0) == (heightQ >= 0.0)) return false;
    const Place along = minus(b_, a_);
    const auto isBeside = [&](const Place& place) {
      const double foot = dot(minus(place, a_), along);
      return foot >= 0.0 && foot <= dot(along, along);
    };
    return rule == TipRule::Both ? isBeside(p) && isBeside(q) : isBeside(p) || isBeside(q);
  }

 protected:
  bool covers(const Place& place) const override {
    const Place along = minus(b_, a_);
    const double foot = dot(minus(place, a_), along);
    const double length2 = dot(along, along);
    return foot >= -rimTolerance * length2 && foot <= (1.0 + rimTolerance) * length2;
  }
  void addCone(const Places& apices, const Vector& sign, const Place& origin,
               std::vector<HalfSpace>& shadow) const override {
    // The turn from the ray to a to the ray to b has the sign of the height.
    const Places toA = minus(a_, apices), toB = minus(b_, apices), from = minus(apices, origin);
    for (const Places& normal :
         {Places{sign * toA[1], -sign * toA[0], 0.0}, Places{-sign * toB[1], sign * toB[0], 0.0}})
      shadow.push_back({normal, dot(normal, from)});
  }

 private:
  Place a_, b_;
};

class PolygonScreen : public FlatScreen {
 public:
  explicit PolygonScreen(const std::vector<Place>& corners)
      : FlatScreen(corners[0], normalOf(corners), lengthOf(minus(corners[1], corners[0]))), corners_(corners) {}

  bool isBetween(const Cell& a, const Cell& b) const override {
    return !areOnOneSide(cornersOf(a, b), origin_, normal_);
  }
  Box box() const override { return boxOf(corners_); }

 protected:
  bool covers(const Place& place) const override {
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Place& next = corners_[(k + 1) % corners_.size()];
      const Place side = minus(next, corners_[k]);
      if (dot(crossed(side, minus(place, corners_[k])), normal_) < -rimTolerance * dot(side, side)) return false;
    }
    return true;
  }
  void addCone(const Places& apices, const Vector& sign, const Place& origin,
               std::vector<HalfSpace>& shadow) const override {
    // Seen from the side that the normal points to, corners follow each other against the clock.
    const Places from = minus(apices, origin);
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Place& next = corners_[(k + 1) % corners_.size()];
      const Places normal = times(sign, crossed(minus(corners_[k], apices), minus(next, apices)));
      shadow.push_back({normal, dot(normal, from)});
    }
  }

 private:
  /// Newell's; |normal| is twice the area.
  static Place normalOf(const std::vector<Place>& corners) {
    Place normal{};
    for (std::size_t k = 0; k < corners.size(); ++k)
      normal =
          plus(normal, crossed(minus(corners[k], corners[0]), minus(corners[(k + 1) % corners.size()], corners[0])));
    return normal;
  }

  std::vector<Place> corners_;
};

class DiskScreen : public FlatScreen {
 public:
  DiskScreen(const Place& center, const Place& normal, double radius)
      : FlatScreen(center, normal, radius), radius_(radius) {}

  void hide(const Place& place, const Lines& lines, double* from, double* to) const override {
    std::fill(from, from + lines.size(), 0.0);
    std::fill(to, to + lines.size(), 1.0);
    double height = heightOf(place);
    const double lift = std::abs(height) <= tolerance_ ? tolerance_ - height : 0.0;
    height += lift;
    keepBelow(plus({}, normal_, height > 0.0 ? 1.0 : -1.0), origin_, 0.0, lines, from, to);
    keepCone(plus(place, normal_, lift), height, lines, from, to);
  }
  bool addShadow(const Places&, const Place&, std::vector<HalfSpace>&) const override { return false; }
  bool isBetween(const Cell& a, const Cell& b) const override {
    return !areOnOneSide(cornersOf(a, b), origin_, normal_);
  }
  Box box() const override {
    Box box{origin_, origin_};
    for (std::size_t d = 0; d < 3; ++d) {
      const double reach = radius_ * std::sqrt(std::max(0.0, 1.0 - normal_[d] * normal_[d]));
      box.low[d] -= reach;
      box.high[d] += reach;
    }
    return box;
  }

 protected:
  bool covers(const Place& place) const override { return lengthOf(minus(place, origin_)) < radius_; }

 private:
  /// Keeps what lies in the cone from `apex`, at this height over the crack. The connection from p (height h) to q
  /// (height g) passes the plane at (g p - h q)/(g - h).
  void keepCone(const Place& apex, double height, const Lines& lines, double* from, double* to) const {
    const Place p = plus(minus(apex, origin_), normal_, -height);
    const double slope = dot(lines.step, normal_);
    const Place step = plus(lines.step, normal_, -slope);
    const Place change = plus(plus({}, p, slope), step, -height);
    for (std::size_t r = 0; r < lines.size(); ++r) {
      if (from[r] >= to[r]) continue;
      const Place offset = minus(Place{lines.start[0][r], lines.start[1][r], lines.start[2][r]}, origin_);
      const double g = dot(offset, normal_);
      const Place there = plus(plus({}, p, g), plus(offset, normal_, -g), -height);
      const double reach = radius_ * (g - height), reachSlope = radius_ * slope;
      const Range range =
          nonNegative(reachSlope * reachSlope - dot(change, change), reach * reachSlope - dot(there, change),
                      reach * reach - dot(there, there), {from[r], to[r]});
      from[r] = range.low;
      to[r] = range.high;
    }
  }

  double radius_;
};

}  // namespace

std::unique_ptr<Screen> segmentScreen(const Place& a, const Place& b) { return std::make_unique<SegmentScreen>(a, b); }
std::unique_ptr<Screen> polygonScreen(const std::vector<Place>& corners) {
  return std::make_unique<PolygonScreen>(corners);
}
std::unique_ptr<Screen> diskScreen(const Place& center, const Place& normal, double radius) {
  return std::make_unique<DiskScreen>(center, normal, radius);
}

}  // namespace pd::decomposition
