// Closed surfaces of flat triangles around voids: pores as they are drawn or measured.
#ifndef PD_DECOMPOSITION_TRIANGLE_SURFACE_HPP
#define PD_DECOMPOSITION_TRIANGLE_SURFACE_HPP

#include <array>
#include <memory>
#include <vector>

#include "discontinuities.hpp"

namespace pd::decomposition {

/// In one part, without holes: each edge belongs to two triangles, which have it in opposite directions. Corners follow
/// each other against the clock as seen from outside.
struct TriangleSurface {
  std::vector<Place> vertices;                        ///< m
  std::vector<std::array<std::size_t, 3>> triangles;  ///< numbers of their vertices
};

/// What hides places behind it: of a convex surface one screen, of another one its triangles, which takes some ten
/// times as long. A triangle hides from places in front of it alone: what is hidden by one from behind, one in front
/// hides, too.
std::vector<std::unique_ptr<Screen>> surfaceScreens(const TriangleSurface& surface);
/// What is inside.
std::unique_ptr<Void> surfaceVoid(const TriangleSurface& surface);

}  // namespace pd::decomposition

#endif
