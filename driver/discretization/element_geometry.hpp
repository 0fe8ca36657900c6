// Volume and centroid of finite elements, as Peridigm turns them into points.
#ifndef PD_ELEMENT_GEOMETRY_HPP
#define PD_ELEMENT_GEOMETRY_HPP

#include <array>

namespace pd {

struct ElementGeometry {
  std::array<double, 3> centroid{};
  double volume = 0.0;
  bool isInverted = false;  ///< some part of it has a negative volume
};

/// `nodes` [3 * 4]: a positive volume where nodes 1, 2, 3 turn counter-clockwise seen from node 4.
ElementGeometry tetrahedron(const double* nodes);

/// `nodes` [3 * 8] in the order of Exodus: the bottom, counter-clockwise seen from the top, then the top. Faces that
/// are not plane count as the four triangles from their edges to the mean of their nodes; the tetrahedra from these
/// triangles to the mean of all nodes make up the volume, and the centroid is that of the volume. (Peridigm's rule.)
ElementGeometry hexahedron(const double* nodes);

}  // namespace pd

#endif
