#include <algorithm>
#include <cmath>
#include <limits>

#include "convex_geometry.hpp"
#include "discontinuities.hpp"

namespace pd::decomposition {

namespace stdx = kernels::stdx;
using kernels::allLanes;
using kernels::choose;
using kernels::greaterBits;
using kernels::Vector;
using kernels::wherePositive;

namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

/// An ellipsoid in the coordinates in which it is the unit ball.
class UnitBall {
 public:
  explicit UnitBall(const Ellipsoid& shape) : shape_(shape), box_{shape.center, shape.center} {
    for (std::size_t k = 0; k < shape.halfAxes.size(); ++k)
      rows_[k] = plus({}, shape.halfAxes[k], 1.0 / dot(shape.halfAxes[k], shape.halfAxes[k]));
    for (std::size_t d = 0; d < 3; ++d) {
      Place axis{};
      axis[d] = 1.0;
      box_.low[d] -= reach(axis);
      box_.high[d] += reach(axis);
    }
  }
  Place mapped(const Place& difference) const {
    return {dot(difference, rows_[0]), dot(difference, rows_[1]), dot(difference, rows_[2])};
  }
  Places mapped(const Places& differences) const {
    return {dot(rows_[0], differences), dot(rows_[1], differences), dot(rows_[2], differences)};
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
  /// Where lines that are not along an axis of infinite length are within it.
  PD_INLINES RangePerLane meet(const LinePerLane& lines) const {
    const Places x = mapped(minus(lines.start, shape_.center)), d = mapped(lines.step);
    const Vector square = dot(d, d), along = dot(x, d), within = along * along + square * (1.0 - dot(x, x));
    const unsigned char isMet = greaterBits(within, 0.0);
    const Vector root = kernels::squareRoot(choose(within, 0.0, isMet)), perSquare = 1.0 / square;
    return {choose((-along - root) * perSquare, beyondAll, isMet),
            choose((-along + root) * perSquare, -beyondAll, isMet)};
  }
  Range heights(const Place& axis) const {
    const double middle = dot(shape_.center, axis), reach = this->reach(axis);
    return {middle - reach, middle + reach};
  }
  const Box& box() const { return box_; }
  /// m
  double shortestHalfAxis() const {
    double shortest = everywhere;
    for (const Place& half : shape_.halfAxes) shortest = std::min(shortest, lengthOf(half));
    return shortest;
  }
  const Place& center() const { return shape_.center; }
  /// Whether it is a circle or an ellipse in the plane across an axis of infinite length, or of the plane itself.
  bool isPlane() const { return shape_.halfAxes.size() == 2; }
  const Place& row(std::size_t k) const { return rows_[k]; }

 private:
  Ellipsoid shape_;
  std::array<Place, 3> rows_{};
  Box box_;
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

  /// Behind the unit circle is, seen from p with |p| > 1, what lies beyond the chord between the points of touch,
  /// x . p <= 1, and between the tangents, x . t <= p^2 with t = p +- sqrt(p^2 - 1) (-p_2, p_1).
  bool addShadow(const Places& places, const Place& origin, std::vector<HalfSpace>& shadow) const override {
    if (!ball_.isPlane()) return false;
    const Place &first = ball_.row(0), &second = ball_.row(1), atOrigin = ball_.mappedPlace(origin);
    const Places offCenter = minus(places, ball_.center());
    const Vector x = dot(first, offCenter), y = dot(second, offCenter), square = x * x + y * y;
    const Vector isIn = 1.0 - square;  // > 0
    const Vector u = wherePositive(isIn, 0.0, x), v = wherePositive(isIn, 0.0, y);
    const Vector tangent = kernels::squareRoot(wherePositive(isIn, 0.0, square - 1.0));
    const auto add = [&](const Vector& s, const Vector& t, const Vector& limit) {
      Places normal;
      for (std::size_t d = 0; d < 3; ++d) normal[d] = s * first[d] + t * second[d];
      shadow.push_back({normal, limit - (s * atOrigin[0] + t * atOrigin[1])});
    };
    add(u, v, 1.0);
    add(u - tangent * v, v + tangent * u, square);
    add(u + tangent * v, v - tangent * u, square);
    return true;
  }

  /// The tangent cone and the plane of hide(), with the place in the lanes.
  bool hideFromEach(const Places& places, const Lines& lines, Vector* from, Vector* to) const override {
    if (ball_.isPlane()) return false;
    const Places p = ball_.mapped(minus(places, ball_.center()));
    const Place d = ball_.mapped(lines.step);
    const double d2 = dot(d, d);
    const Vector p2 = dot(p, p), beyond = p2 - 1.0, slope = dot(d, p), least = 1e-14 * d2 * p2;
    const Vector exact = slope * slope - d2 * beyond;
    const Vector square = choose(exact, -least, greaterBits(stdx::abs(exact), least));
    const Vector perSquare = 1.0 / square;
    const unsigned char isIn = greaterBits(0.0, beyond), isClosed = greaterBits(0.0, square),
                        isAhead = greaterBits(0.0, slope), isBack = greaterBits(slope, 0.0),
                        isAcross = static_cast<unsigned char>(allLanes & ~(isAhead | isBack)),
                        hasFirst = isClosed | isAhead, hasSecond = static_cast<unsigned char>(isClosed | ~isAhead);
    const Vector perSlope = 1.0 / choose(1.0, slope, isAcross);
    for (std::size_t r = 0; r < lines.size(); ++r) {
      const Place x = ball_.mappedPlace({lines.start[0][r], lines.start[1][r], lines.start[2][r]});
      const double x2 = dot(x, x), xd = dot(x, d);
      const Vector height = dot(x, p), away = height - p2;
      const Vector b = away * slope - (xd - slope) * beyond, c = away * away - (x2 - 2.0 * height + p2) * beyond;
      const Vector discriminant = b * b - square * c;
      const Vector root = kernels::squareRoot(stdx::max(discriminant, Vector(0.0)));
      Vector low = choose((root - b) * perSquare, 0.0, hasFirst),
             high = choose((-b - root) * perSquare, 1.0, hasSecond);
      const Vector touch = (1.0 - height) * perSlope;
      low = stdx::max(choose(stdx::max(low, touch), low, isAhead), Vector(0.0));
      high = stdx::min(choose(stdx::min(high, touch), high, isBack), Vector(1.0));
      const unsigned char isSeen = static_cast<unsigned char>((isAcross & greaterBits(height, 1.0)) |
                                                              (isClosed & ~greaterBits(discriminant, 0.0)));
      from[r] = choose(0.0, low, isIn);
      to[r] = choose(1.0, choose(-1.0, high, isSeen), isIn);
    }
    return true;
  }

  /// Steps towards the place of least norm of the corners' hull (Frank & Wolfe, with the best length of each step),
  /// until that is within the unit ball, or the plane across the way to it has all corners beyond the ball.
  bool isBetween(const Cell& a, const Cell& b) const override {
    Corners corners = cornersOf(a, b);
    for (std::size_t c = 0; c < corners.size(); ++c) corners[c] = ball_.mappedPlace(corners[c]);
    Place nearest = corners[0];
    constexpr int mostSteps = 12;
    for (int step = 0; step < mostSteps; ++step) {
      const double square = dot(nearest, nearest);
      if (square < 1.0) return true;
      const Place& lowest = *std::min_element(corners.begin(), corners.end(), [&](const Place& p, const Place& q) {
        return dot(p, nearest) < dot(q, nearest);
      });
      const double height = dot(lowest, nearest);
      if (height > 0.0 && height * height >= square) return false;
      const Place way = minus(lowest, nearest);
      nearest = plus(nearest, way, std::clamp(-dot(nearest, way) / dot(way, way), 0.0, 1.0));
    }
    return true;
  }
  Box box() const override { return ball_.box(); }
  PD_INLINES RangePerLane meet(const LinePerLane& lines) const override { return ball_.meet(lines); }
  Range heights(const Place& axis) const override { return ball_.heights(axis); }

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
  PD_INLINES void addWithinEach(const LinePerLane& lines, std::vector<RangePerLane>& ranges) const override {
    ranges.push_back(ball_.meet(lines));
  }
  Box box() const override { return ball_.box(); }
  double inradius() const override { return ball_.shortestHalfAxis(); }
  std::vector<double> heights(const Place& axis) const override {
    const Range range = ball_.heights(axis);
    return {range.low, range.high};
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
  PD_INLINES void addWithinEach(const LinePerLane& lines, std::vector<RangePerLane>& ranges) const override {
    static thread_local std::vector<Vector> crossings;  // in order
    crossings.clear();
    const Vector square = dot(lines.step, lines.step);
    const auto heightOf = [&](const Places& away)
                              PD_INLINED { return away[1] * lines.step[0] - away[0] * lines.step[1]; };
    Places a = minus(corners_.back(), lines.start);
    Vector heightA = heightOf(a);
    for (const Place& corner : corners_) {
      const Places b = minus(corner, lines.start);
      const Vector heightB = heightOf(b);
      const auto isCrossed = static_cast<unsigned char>(greaterBits(heightA, 0.0) ^ greaterBits(heightB, 0.0));
      if (isCrossed != 0) {
        const Vector part = heightA / choose(heightA - heightB, 1.0, isCrossed);
        const Vector alongA = dot(a, lines.step), alongB = dot(b, lines.step);
        Vector latest = choose((alongA + part * (alongB - alongA)) / square, beyondAll, isCrossed);
        for (Vector& other : crossings) {
          const Vector first = stdx::min(other, latest);
          latest = stdx::max(other, latest);
          other = first;
        }
        crossings.push_back(latest);
      }
      a = b;
      heightA = heightB;
    }
    if (crossings.size() % 2 == 1) crossings.push_back(beyondAll);
    for (std::size_t k = 0; k < crossings.size(); k += 2) ranges.push_back({crossings[k], crossings[k + 1]});
  }
  Box box() const override { return boxOf(corners_); }
  double inradius() const override {
    double twiceArea = 0.0, circumference = 0.0;
    forEachEdge([&](const Place& a, const Place& b) {
      twiceArea += crossed(minus(a, corners_[0]), minus(b, corners_[0]))[2];
      circumference += lengthOf(minus(b, a));
    });
    return std::abs(twiceArea) / circumference;
  }
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

std::unique_ptr<Screen> ellipsoidScreen(const Ellipsoid& shape) { return std::make_unique<EllipsoidScreen>(shape); }
std::unique_ptr<Void> ellipsoidVoid(const Ellipsoid& shape) { return std::make_unique<EllipsoidVoid>(shape); }
std::unique_ptr<Void> polygonVoid(const std::vector<Place>& corners) { return std::make_unique<PolygonVoid>(corners); }

}  // namespace pd::decomposition
