#include "triangle_surface.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "convex_geometry.hpp"
#include "triangle_geometry.hpp"

namespace pd::decomposition {

using kernels::Vector;
using kernels::wherePositive;

namespace {

/// A triangle of a surface that is not convex.
class TriangleScreen : public Screen {
 public:
  TriangleScreen(const Place& a, const Place& b, const Place& c)
      : corners_{a, b, c},
        ball_(corners_),
        normal_(normalized(crossed(minus(b, a), minus(c, a)))),
        box_(boxOf(corners_)),
        tolerance_(1e-12 * ball_.radius) {}

  void hide(const Place& place, const Lines& lines, double* from, double* to) const override {
    hideEverything(lines, from, to);
    std::vector<HalfSpace> shadow;
    addShadow(inAllLanes(place), place, shadow);
    for (const HalfSpace& half : shadow)
      keepBelow({half.normal[0][0], half.normal[1][0], half.normal[2][0]}, place, half.offset[0], lines, from, to);
  }

  bool addShadow(const Places& places, const Place& origin, std::vector<HalfSpace>& shadow) const override {
    const Vector height = dot(normal_, minus(places, corners_[0])), isInFront = height + tolerance_;
    // Places on the triangle are in front of it.
    const Vector lift = wherePositive(tolerance_ - height, 2.0 * tolerance_ - height, 0.0);
    const Vector faced = wherePositive(isInFront, 1.0, 0.0);  // nothing has 0 . x <= -1
    const Vector depth = dot(normal_, minus(corners_[0], origin));
    shadow.push_back({times(faced, inAllLanes(normal_)), wherePositive(isInFront, depth, -1.0)});
    Places apices;
    for (std::size_t d = 0; d < 3; ++d) apices[d] = places[d] + lift * normal_[d];
    const Places from = minus(apices, origin);
    for (std::size_t k = 0; k < 3; ++k) {  // against the clock as seen from the places
      const Places normal = crossed(minus(corners_[k], apices), minus(corners_[(k + 1) % 3], apices));
      shadow.push_back({normal, dot(normal, from)});
    }
    return true;
  }

  bool isBetween(const Cell& a, const Cell& b) const override {
    return !areParted(corners_, ball_, a, b) && !areOnOneSide(cornersOf(a, b), corners_[0], normal_);
  }
  /// Places behind it see it not: others of the surface are before it.
  bool mayHideFrom(const Cell& cell) const override {
    const Corners corners = cell.corners();
    return std::any_of(corners.begin(), corners.end(), [&](const Place& corner) {
      return dot(minus(corner, corners_[0]), normal_) > -2.0 * tolerance_;
    });
  }
  Box box() const override { return box_; }

 private:
  std::vector<Place> corners_;
  Ball ball_;
  Place normal_;
  Box box_;
  double tolerance_;
};

/// Each edge once.
std::vector<Edge> edgesOf(const TriangleSurface& surface) {
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> owner;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) owner[{surface.triangles[t][k], surface.triangles[t][(k + 1) % 3]}] = t;
  std::vector<Edge> edges;
  for (const auto& [ends, left] : owner)
    if (ends.first < ends.second) edges.push_back({ends.first, ends.second, left, owner.at({ends.second, ends.first})});
  return edges;
}

/// To the rounding of coordinates in single precision, as files of triangles have them. Where no edge is bent inwards
/// the whole is convex.
bool isConvex(const TriangleSurface& surface, const std::vector<Edge>& edges) {
  const double tolerance = 1e-6 * Ball(surface.vertices).radius;
  return std::all_of(edges.begin(), edges.end(), [&](const Edge& edge) {
    const Triangle& other = surface.triangles[edge.right];
    const Place normal = normalized(normalOf(surface, surface.triangles[edge.left]));
    return std::all_of(other.begin(), other.end(), [&](std::size_t vertex) {
      return dot(minus(surface.vertices[vertex], surface.vertices[edge.from]), normal) <= tolerance;
    });
  });
}

/// Triangles by where they are as seen along an axis.
class TriangleBins {
 public:
  TriangleBins(const TriangleSurface& surface, std::size_t axis) : e_((axis + 1) % 3), f_((axis + 2) % 3) {
    const Box box = boxOf(surface.vertices);
    n_ = std::clamp(static_cast<int>(std::sqrt(0.5 * static_cast<double>(surface.triangles.size()))), 1, 128);
    for (std::size_t d = 0; d < 3; ++d) {
      low_[d] = box.low[d];
      perEdge_[d] = n_ / (box.high[d] - box.low[d]);
    }
    bins_.resize(static_cast<std::size_t>(n_) * static_cast<std::size_t>(n_));
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
      const Triangle& c = surface.triangles[t];
      const Box around = boxOf({surface.vertices[c[0]], surface.vertices[c[1]], surface.vertices[c[2]]});
      for (int k = bin(around.low, e_); k <= bin(around.high, e_); ++k)
        for (int l = bin(around.low, f_); l <= bin(around.high, f_); ++l) bins_[index(k, l)].push_back(t);
    }
  }
  const std::vector<std::size_t>& along(const Place& place) const {
    return bins_[index(bin(place, e_), bin(place, f_))];
  }

 private:
  int bin(const Place& place, std::size_t d) const {
    return static_cast<int>(std::clamp((place[d] - low_[d]) * perEdge_[d], 0.0, n_ - 1.0));
  }
  std::size_t index(int k, int l) const { return static_cast<std::size_t>(k * n_ + l); }

  std::size_t e_, f_;
  int n_;
  Place low_{}, perEdge_{};
  std::vector<std::vector<std::size_t>> bins_;
};

class SurfaceVoid : public Void {
 public:
  explicit SurfaceVoid(const TriangleSurface& surface) : surface_(surface), box_(boxOf(surface.vertices)) {
    for (std::size_t axis = 0; axis < 3; ++axis) bins_.emplace_back(surface, axis);
    for (const Triangle& triangle : surface.triangles) normals_.push_back(normalOf(surface, triangle));
    all_.resize(surface.triangles.size());
    for (std::size_t t = 0; t < all_.size(); ++t) all_[t] = t;
  }

  bool contains(const Place& place) const override {
    for (std::size_t d = 0; d < 3; ++d)
      if (place[d] < box_.low[d] || place[d] > box_.high[d]) return false;
    bool isInside = false;
    forEachCrossing(place, {1.0, 0.0, 0.0}, [&](double s) { isInside = isInside != (s > 0.0); });
    return isInside;
  }

  void addWithin(const Place& start, const Place& step, std::vector<Range>& ranges) const override {
    static thread_local std::vector<double> crossings;
    crossings.clear();
    forEachCrossing(start, step, [&](double s) { crossings.push_back(s); });
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const Range range{std::max(0.0, crossings[k]), std::min(1.0, crossings[k + 1])};
      if (range.low < range.high) ranges.push_back(range);
    }
  }
  Box box() const override { return box_; }
  double inradius() const override {
    double volume = 0.0, area = 0.0;  // 6 and 2 of them
    for (std::size_t t = 0; t < normals_.size(); ++t) {
      volume += dot(normals_[t], minus(surface_.vertices[surface_.triangles[t][0]], surface_.vertices[0]));
      area += lengthOf(normals_[t]);
    }
    return std::abs(volume) / area;
  }
  /// Where it begins and ends: corners are too many to integrate from one to the next.
  std::vector<double> heights(const Place& axis) const override {
    for (std::size_t d = 0; d < 3; ++d)
      if (axis[(d + 1) % 3] == 0.0 && axis[(d + 2) % 3] == 0.0)
        return {std::min(box_.low[d] * axis[d], box_.high[d] * axis[d]),
                std::max(box_.low[d] * axis[d], box_.high[d] * axis[d])};
    double low = farthest, high = -farthest;
    for (const Place& vertex : surface_.vertices) {
      low = std::min(low, dot(vertex, axis));
      high = std::max(high, dot(vertex, axis));
    }
    return {low, high};
  }

 private:
  /// Calls visit(s) where the whole line start + s step passes through the surface, an even number of times: a line
  /// through an edge passes through one of its two triangles, or through both or none where they are on one side of it.
  template <class Visit>
  void forEachCrossing(const Place& start, const Place& step, Visit visit) const {
    std::size_t d = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::abs(step[k]) > std::abs(step[d])) d = k;
    const std::size_t e = (d + 1) % 3, f = (d + 2) % 3;
    const double slopeE = step[e] / step[d], slopeF = step[f] / step[d];
    for (const std::size_t t : slopeE == 0.0 && slopeF == 0.0 ? bins_[d].along(start) : all_) {
      std::array<std::array<double, 2>, 3> seen;  // corners as seen along the line, which is at (0, 0)
      for (std::size_t k = 0; k < 3; ++k) {
        const Place to = minus(surface_.vertices[surface_.triangles[t][k]], start);
        seen[k] = {to[e] - slopeE * to[d], to[f] - slopeF * to[d]};
      }
      if (!isAround(seen, surface_.triangles[t])) continue;
      const Place& normal = normals_[t];
      const double slope = dot(normal, step);
      if (slope != 0.0) visit(dot(normal, minus(surface_.vertices[surface_.triangles[t][0]], start)) / slope);
    }
  }

  /// Whether a triangle in a plane is around (0, 0). Which side of an edge that is, both of its triangles see alike.
  static bool isAround(const std::array<std::array<double, 2>, 3>& seen, const Triangle& triangle) {
    const double area =
        (seen[1][0] - seen[0][0]) * (seen[2][1] - seen[0][1]) - (seen[1][1] - seen[0][1]) * (seen[2][0] - seen[0][0]);
    if (area == 0.0) return false;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      const bool isForward = triangle[k] < triangle[next];
      const auto &low = isForward ? seen[k] : seen[next], &high = isForward ? seen[next] : seen[k];
      const bool isLeft = low[0] * high[1] - low[1] * high[0] >= 0.0;
      if (isLeft != ((area > 0.0) == isForward)) return false;
    }
    return true;
  }

  TriangleSurface surface_;
  Box box_;
  std::vector<TriangleBins> bins_;
  std::vector<Place> normals_;
  std::vector<std::size_t> all_;
};

}  // namespace

std::vector<std::unique_ptr<Screen>> surfaceScreens(const TriangleSurface& surface) {
  std::vector<std::unique_ptr<Screen>> screens;
  std::vector<Edge> edges = edgesOf(surface);
  if (isConvex(surface, edges)) {
    screens.push_back(convexScreen(surface, std::move(edges)));
    return screens;
  }
  for (const Triangle& triangle : surface.triangles)
    screens.push_back(std::make_unique<TriangleScreen>(surface.vertices[triangle[0]], surface.vertices[triangle[1]],
                                                       surface.vertices[triangle[2]]));
  return screens;
}

std::unique_ptr<Void> surfaceVoid(const TriangleSurface& surface) { return std::make_unique<SurfaceVoid>(surface); }

}  // namespace pd::decomposition
