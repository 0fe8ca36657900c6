#include "element_geometry.hpp"

namespace pd {

namespace {

using Point = std::array<double, 3>;

Point pointAt(const double* nodes, int node) { return {nodes[3 * node], nodes[3 * node + 1], nodes[3 * node + 2]}; }

Point meanOf(const double* nodes, const int* members, int count) {
  Point mean{};
  for (int k = 0; k < count; ++k)
    for (std::size_t d = 0; d < 3; ++d) mean[d] += nodes[3 * static_cast<std::size_t>(members[k]) + d];
  for (double& value : mean) value /= count;
  return mean;
}

ElementGeometry tetrahedronBetween(const Point& p0, const Point& p1, const Point& p2, const Point& p3) {
  Point a, b, c;
  ElementGeometry result;
  for (std::size_t d = 0; d < 3; ++d) {
    a[d] = p1[d] - p0[d];
    b[d] = p2[d] - p0[d];
    c[d] = p3[d] - p0[d];
    result.centroid[d] = 0.25 * (p0[d] + p1[d] + p2[d] + p3[d]);
  }
  result.volume =
      (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) /
      6.0;
  result.isInverted = !(result.volume >= 0.0);
  return result;
}

/// Nodes of the faces, counter-clockwise seen from within.
constexpr int hexahedronFaces[6][4] = {{1, 0, 4, 5}, {2, 1, 5, 6}, {3, 2, 6, 7},
                                       {0, 3, 7, 4}, {0, 1, 2, 3}, {5, 4, 7, 6}};

}  // namespace

ElementGeometry tetrahedron(const double* nodes) {
  return tetrahedronBetween(pointAt(nodes, 0), pointAt(nodes, 1), pointAt(nodes, 2), pointAt(nodes, 3));
}

ElementGeometry hexahedron(const double* nodes) {
  constexpr int all[8] = {0, 1, 2, 3, 4, 5, 6, 7};
  const Point center = meanOf(nodes, all, 8);
  ElementGeometry result;
  Point moment{};
  for (const auto& face : hexahedronFaces) {
    const Point faceCenter = meanOf(nodes, face, 4);
    for (int k = 0; k < 4; ++k) {
      const ElementGeometry part =
          tetrahedronBetween(pointAt(nodes, face[k]), pointAt(nodes, face[(k + 1) % 4]), faceCenter, center);
      result.volume += part.volume;
      result.isInverted = result.isInverted || part.isInverted;
      for (std::size_t d = 0; d < 3; ++d) moment[d] += part.volume * part.centroid[d];
    }
  }
  for (std::size_t d = 0; d < 3; ++d) result.centroid[d] = moment[d] / result.volume;
  return result;
}

}  // namespace pd
