// Whether triangles are the closed surfaces of bodies.
#ifndef PD_SURFACE_CHECK_HPP
#define PD_SURFACE_CHECK_HPP

#include <string>
#include <vector>

#include "triangle_surface.hpp"

namespace pd {

struct SurfaceFault {
  std::size_t triangle;
  std::string what;
};

/// What keeps triangles, in one part or several, from being closed surfaces with their outside outside; in the order in
/// which one is told before the next is looked for: triangles without an area; edges that do not belong to two
/// triangles with opposite directions; parts turned inside out; parts that pass through themselves (triangles that
/// touch, or lie on each other, are not found). Parts may overlap.
std::vector<SurfaceFault> faultsOf(const decomposition::TriangleSurface& surface);

/// Its parts, which have no edge in common. `surface`: without faults.
std::vector<decomposition::TriangleSurface> partsOf(const decomposition::TriangleSurface& surface);

}  // namespace pd

#endif
