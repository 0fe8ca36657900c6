// What screens made of triangles have in common.
#ifndef PD_TRIANGLE_GEOMETRY_HPP
#define PD_TRIANGLE_GEOMETRY_HPP

#include <algorithm>
#include <limits>
#include <vector>

#include "discontinuities.hpp"
#include "triangle_surface.hpp"

namespace pd::decomposition {

using Triangle = std::array<std::size_t, 3>;

constexpr double farthest = std::numeric_limits<double>::infinity();

/// Twice the area long, outwards.
inline Place normalOf(const TriangleSurface& surface, const Triangle& triangle) {
  const Place& origin = surface.vertices[triangle[0]];
  return crossed(minus(surface.vertices[triangle[1]], origin), minus(surface.vertices[triangle[2]], origin));
}

inline Place normalized(const Place& direction) {
  return plus({}, direction, 1.0 / decomposition::lengthOf(direction));
}

/// A ball around places.
struct Ball {
  Place center{};
  double radius = 0.0;
  explicit Ball(const std::vector<Place>& places) {
    for (const Place& place : places) center = plus(center, place, 1.0 / static_cast<double>(places.size()));
    for (const Place& place : places) radius = std::max(radius, decomposition::lengthOf(minus(place, center)));
  }
};

/// Whether a plane across the shortest way from the middle of a convex body to the bond parts the body from all
/// connections of the two cells.
inline bool areParted(const std::vector<Place>& body, const Ball& ball, const Cell& a, const Cell& b) {
  const Place bond = minus(b.center, a.center), from = minus(ball.center, a.center);
  const double length2 = dot(bond, bond);
  const double s = length2 == 0.0 ? 0.0 : std::clamp(dot(from, bond) / length2, 0.0, 1.0);
  const Place way = minus(plus(a.center, bond, s), ball.center);
  double reach = 0.0;
  for (const Cell* cell : {&a, &b})
    reach = std::max(reach, 0.5 * (decomposition::lengthOf(cell->edges[0]) + decomposition::lengthOf(cell->edges[1]) +
                                   decomposition::lengthOf(cell->edges[2])));
  if (decomposition::lengthOf(way) > ball.radius + reach) return true;
  double ofBody = -farthest, ofCells = farthest;
  for (const Place& place : body) ofBody = std::max(ofBody, dot(place, way));
  for (const Place& corner : cornersOf(a, b)) ofCells = std::min(ofCells, dot(corner, way));
  return ofBody < ofCells;
}

inline void hideNothing(const Lines& lines, double* from, double* to) {
  std::fill(from, from + lines.size(), 1.0);
  std::fill(to, to + lines.size(), 0.0);
}

inline void hideEverything(const Lines& lines, double* from, double* to) {
  std::fill(from, from + lines.size(), 0.0);
  std::fill(to, to + lines.size(), 1.0);
}

struct Edge {
  std::size_t from, to, left, right;  ///< vertices; triangles, of which the left one has it in this direction
};

/// Of a surface that is convex; `edges`: each once.
std::unique_ptr<Screen> convexScreen(const TriangleSurface& surface, std::vector<Edge> edges);

}  // namespace pd::decomposition

#endif
