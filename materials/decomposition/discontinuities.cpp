#include "discontinuities.hpp"

#include <algorithm>
#include <cmath>

#include "half_spaces.hpp"
#include "segment_crossings.hpp"

namespace pd::decomposition {

namespace {

// ---- cracks ----

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
    double height = dot(minus(place, origin_), normal_);
    Place apex = place;
    if (std::abs(height) <= tolerance_) {
      apex = plus(place, normal_, tolerance_ - height);
      height = tolerance_;
    }
    keepPositive(plus({}, normal_, height > 0.0 ? -1.0 : 1.0), origin_, lines, from, to);
    keepCone(apex, height, lines, from, to);
  }

  bool isAbove(const Place& place) const override { return heightOf(place) >= -tolerance_; }
  bool divides(const Cell& a, const Cell& b) const override {
    const std::vector<Place> corners = cornersOf(a, b);
    std::vector<double> heights;
    for (const Place& corner : corners) heights.push_back(heightOf(corner));
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
  /// Keeps what lies in the cone from `apex`, at this height over the crack, over the outline.
  virtual void keepCone(const Place& apex, double height, const Lines& lines, double* from, double* to) const = 0;

  Place origin_, normal_;
  double tolerance_;
};

class SegmentScreen : public FlatScreen {
 public:
  SegmentScreen(const Place& a, const Place& b)
      : FlatScreen(a, {a[1] - b[1], b[0] - a[0], 0.0}, lengthOf(minus(b, a))), a_(a), b_(b) {}

  bool isBetween(const Cell& a, const Cell& b) const override {
    const std::vector<Place> corners = cornersOf(a, b);
    const Place along = minus(b_, a_);
    if (areOnOneSide(corners, origin_, normal_)) return false;
    const auto isBeyond = [&](const Place& end, const Place& outwards) {
      return std::all_of(corners.begin(), corners.end(),
                         [&](const Place& corner) { return dot(minus(corner, end), outwards) > 0.0; });
    };
    return !isBeyond(b_, along) && !isBeyond(a_, minus(a_, b_));
  }
  Box box() const override { return boxOf({a_, b_}); }
  std::optional<double> hiddenShare(const Cell& a, const Cell& b) const override {
    return shareAcrossSegment(a, b, a_, b_);
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
  void keepCone(const Place& apex, double height, const Lines& lines, double* from, double* to) const override {
    // The turn from the ray to a to the ray to b has the sign of the height.
    const double sign = height > 0.0 ? 1.0 : -1.0;
    const Place toA = minus(a_, apex), toB = minus(b_, apex);
    keepPositive({-sign * toA[1], sign * toA[0], 0.0}, apex, lines, from, to);
    keepPositive({sign * toB[1], -sign * toB[0], 0.0}, apex, lines, from, to);
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
  void keepCone(const Place& apex, double height, const Lines& lines, double* from, double* to) const override {
    // Seen from the side that the normal points to, corners follow each other against the clock.
    const double sign = height > 0.0 ? -1.0 : 1.0;
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Place& next = corners_[(k + 1) % corners_.size()];
      keepPositive(plus({}, crossed(minus(corners_[k], apex), minus(next, apex)), sign), apex, lines, from, to);
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

class DiskScreen : public FlatScreen {
 public:
  DiskScreen(const Place& center, const Place& normal, double radius)
      : FlatScreen(center, normal, radius), radius_(radius) {}

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
  /// The connection from p (height h) to q (height g) passes the plane at (g p - h q)/(g - h).
  void keepCone(const Place& apex, double height, const Lines& lines, double* from, double* to) const override {
    const Place p = plus(minus(apex, origin_), normal_, -height);
    const double slope = dot(lines.step, normal_);
    const Place step = plus(lines.step, normal_, -slope);
    const Place change = plus(plus({}, p, slope), step, -height);
    for (std::size_t r = 0; r < lines.size(); ++r) {
      if (from[r] >= to[r]) continue;
      const Place offset = minus({lines.start[0][r], lines.start[1][r], lines.start[2][r]}, origin_);
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

 private:
  double radius_;
};

// ---- voids ----

/// An ellipsoid in the coordinates in which it is the unit ball.
class UnitBall {
 public:
  explicit UnitBall(const Ellipsoid& shape) : shape_(shape) {
    for (std::size_t k = 0; k < shape.halfAxes.size(); ++k)
      rows_[k] = plus({}, shape.halfAxes[k], 1.0 / dot(shape.halfAxes[k], shape.halfAxes[k]));
  }
  Place mapped(const Place& difference) const {
    return {dot(difference, rows_[0]), dot(difference, rows_[1]), dot(difference, rows_[2])};
  }
  Place mappedPlace(const Place& place) const { return mapped(minus(place, shape_.center)); }
  /// How far it reaches along `axis` from its centre.
  double reach(const Place& axis) const {
    double sum = 0.0, seen = 0.0;
    for (const Place& half : shape_.halfAxes) {
      const double along = dot(half, axis);
      sum += along * along;
      seen += along * along / dot(half, half);
    }
    return seen < (1.0 - 1e-9) * dot(axis, axis) ? everywhere : std::sqrt(sum);
  }
  Box box() const {
    Box box{shape_.center, shape_.center};
    for (std::size_t d = 0; d < 3; ++d) {
      Place axis{};
      axis[d] = 1.0;
      box.low[d] -= reach(axis);
      box.high[d] += reach(axis);
    }
    return box;
  }
  const Place& center() const { return shape_.center; }

 private:
  Ellipsoid shape_;
  std::array<Place, 3> rows_{};
};

Range withinBall(const Place& start, const Place& step) {
  return nonNegative(-dot(step, step), -dot(start, step), 1.0 - dot(start, start), {0.0, 1.0});
}

class EllipsoidScreen : public Screen {
 public:
  explicit EllipsoidScreen(const Ellipsoid& shape) : ball_(shape) {}

  /// Behind the ball is what lies in the tangent cone and beyond the plane through the circle of its touch. Without
  /// branches in the loop, for the sake of the compiler.
  void hide(const Place& place, const Lines& lines, double* from, double* to) const override {
    const Place p = ball_.mappedPlace(place), d = ball_.mapped(lines.step);
    const double p2 = dot(p, p), d2 = dot(d, d), beyond = p2 - 1.0, slope = dot(p, d);
    std::fill(from, from + lines.size(), 0.0);
    std::fill(to, to + lines.size(), 1.0);
    if (beyond < 0.0) return;
    if (d2 == 0.0) return hideAlongAxis(p, beyond, lines, from, to);
    const double square =
        std::abs(slope * slope - d2 * beyond) > 1e-14 * d2 * p2 ? slope * slope - d2 * beyond : -1e-14 * d2 * p2;
    const bool isClosed = square < 0.0, isAhead = slope < 0.0;
    const double perSquare = 1.0 / square, perSlope = slope == 0.0 ? 0.0 : 1.0 / slope, perD2 = 1.0 / d2;
    for (std::size_t r = 0; r < lines.size(); ++r) {
      const Place x = ball_.mappedPlace({lines.start[0][r], lines.start[1][r], lines.start[2][r]});
      const double height = dot(p, x), away = height - p2, x2 = dot(x, x), xd = dot(x, d);
      const double ud = xd - slope, u2 = x2 - 2.0 * height + p2;
      // In the cone away + s slope < 0 and square s^2 + 2 b s + c >= 0.
      const double b = away * slope - ud * beyond, c = away * away - u2 * beyond;
      const double discriminant = b * b - square * c;
      const double root = std::sqrt(discriminant > 0.0 ? discriminant : 0.0);
      const double first = (-b + root) * perSquare, second = (-b - root) * perSquare;
      double low = isClosed || isAhead ? first : 0.0, high = isClosed || !isAhead ? second : 1.0;
      const double touch = (1.0 - height) * perSlope;
      low = slope < 0.0 && touch > low ? touch : low;
      high = slope > 0.0 && touch < high ? touch : high;
      high = (slope == 0.0 && height > 1.0) || (isClosed && discriminant <= 0.0) ? -1.0 : high;
      low = low > 0.0 ? low : 0.0;
      high = high < 1.0 ? high : 1.0;
      // The part within the ball.
      const double within = xd * xd - d2 * (x2 - 1.0);
      const double half = std::sqrt(within > 0.0 ? within : 0.0);
      double in = (-xd - half) * perD2, out = (-xd + half) * perD2;
      in = in > 0.0 ? in : 0.0;
      out = within > 0.0 && out < 1.0 ? out : (within > 0.0 ? 1.0 : -1.0);
      const bool isIn = in < out, isBehind = low < high;
      from[r] = isBehind && isIn ? (low < in ? low : in) : (isIn ? in : low);
      to[r] = isBehind && isIn ? (high > out ? high : out) : (isIn ? out : high);
    }
  }

  bool isBetween(const Cell& a, const Cell& b) const override {
    const Place start = ball_.mappedPlace(a.center), step = ball_.mapped(minus(b.center, a.center));
    const double step2 = dot(step, step);
    const double s = step2 == 0.0 ? 0.0 : std::clamp(-dot(start, step) / step2, 0.0, 1.0);
    double radius = 1.0;
    for (std::size_t k = 0; k < 3; ++k)
      radius += 0.5 * std::max(lengthOf(ball_.mapped(a.edges[k])), lengthOf(ball_.mapped(b.edges[k])));
    const Place nearest = plus(start, step, s);
    const double distance = lengthOf(nearest);
    if (distance > radius) return false;
    if (distance < 1.0) return true;  // the bond itself meets the ball
    // A plane between both: across the shortest way from the ball to the bond.
    const std::vector<Place> corners = cornersOf(a, b);
    return std::any_of(corners.begin(), corners.end(),
                       [&](const Place& corner) { return dot(ball_.mappedPlace(corner), nearest) < distance; });
  }
  Box box() const override { return ball_.box(); }

 private:
  /// Lines along an axis of infinite length: all of one or nothing.
  void hideAlongAxis(const Place& p, double beyond, const Lines& lines, double* from, double* to) const {
    for (std::size_t r = 0; r < lines.size(); ++r) {
      const Place x = ball_.mappedPlace({lines.start[0][r], lines.start[1][r], lines.start[2][r]});
      const Place u = minus(x, p);
      const double away = dot(p, u);
      const bool isBehind = away < 0.0 && dot(p, x) <= 1.0 && away * away >= dot(u, u) * beyond;
      to[r] = isBehind || dot(x, x) < 1.0 ? 1.0 : from[r];
    }
  }

  UnitBall ball_;
};

class EllipsoidVoid : public Void {
 public:
  explicit EllipsoidVoid(const Ellipsoid& shape) : ball_(shape) {}
  bool contains(const Place& place) const override {
    const Place p = ball_.mappedPlace(place);
    return dot(p, p) < 1.0;
  }
  void addWithin(const Place& start, const Place& step, std::vector<Range>& ranges) const override {
    const Range range = withinBall(ball_.mappedPlace(start), ball_.mapped(step));
    if (range.low < range.high) ranges.push_back(range);
  }
  Box box() const override { return ball_.box(); }
  std::vector<double> heights(const Place& axis) const override {
    const double middle = dot(ball_.center(), axis), reach = ball_.reach(axis);
    return {middle - reach, middle + reach};
  }

 private:
  UnitBall ball_;
};

class PolygonVoid : public Void {
 public:
  explicit PolygonVoid(const std::vector<Place>& corners) : corners_(corners) {}
  bool contains(const Place& place) const override {
    bool isInside = false;
    forEachEdge([&](const Place& a, const Place& b) {
      if ((a[1] > place[1]) != (b[1] > place[1]) && place[0] < a[0] + (place[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
        isInside = !isInside;
    });
    return isInside;
  }
  void addWithin(const Place& start, const Place& step, std::vector<Range>& ranges) const override {
    std::vector<double> crossings;
    const Place normal{-step[1], step[0], 0.0};
    forEachEdge([&](const Place& a, const Place& b) {
      const double heightA = dot(minus(a, start), normal), heightB = dot(minus(b, start), normal);
      if ((heightA > 0.0) == (heightB > 0.0)) return;
      const Place at = plus(a, minus(b, a), heightA / (heightA - heightB));
      crossings.push_back(dot(minus(at, start), step) / dot(step, step));
    });
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const Range range{std::max(0.0, crossings[k]), std::min(1.0, crossings[k + 1])};
      if (range.low < range.high) ranges.push_back(range);
    }
  }
  Box box() const override { return boxOf(corners_); }
  std::vector<double> heights(const Place& axis) const override {
    std::vector<double> result;
    for (const Place& corner : corners_) result.push_back(dot(corner, axis));
    return result;
  }

 private:
  template <class Visit>
  void forEachEdge(Visit visit) const {
    for (std::size_t k = 0; k < corners_.size(); ++k) visit(corners_[k], corners_[(k + 1) % corners_.size()]);
  }
  std::vector<Place> corners_;
};

}  // namespace

std::vector<Place> Cell::corners() const {
  std::vector<Place> result{center};
  for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k) {
    const std::size_t n = result.size();
    for (std::size_t c = 0; c < n; ++c) {
      const Place middle = result[c];
      result[c] = plus(middle, edges[k], -0.5);
      result.push_back(plus(middle, edges[k], 0.5));
    }
  }
  return result;
}

bool Box::meets(const Box& other) const {
  for (std::size_t d = 0; d < 3; ++d)
    if (low[d] > other.high[d] || high[d] < other.low[d]) return false;
  return true;
}

Box boxAround(const Cell& a, const Cell& b) { return boxOf(cornersOf(a, b)); }

std::unique_ptr<Screen> segmentScreen(const Place& a, const Place& b) { return std::make_unique<SegmentScreen>(a, b); }
std::unique_ptr<Screen> polygonScreen(const std::vector<Place>& corners) {
  return std::make_unique<PolygonScreen>(corners);
}
std::unique_ptr<Screen> diskScreen(const Place& center, const Place& normal, double radius) {
  return std::make_unique<DiskScreen>(center, normal, radius);
}
std::unique_ptr<Screen> ellipsoidScreen(const Ellipsoid& shape) { return std::make_unique<EllipsoidScreen>(shape); }
std::unique_ptr<Void> ellipsoidVoid(const Ellipsoid& shape) { return std::make_unique<EllipsoidVoid>(shape); }
std::unique_ptr<Void> polygonVoid(const std::vector<Place>& corners) { return std::make_unique<PolygonVoid>(corners); }

}  // namespace pd::decomposition
