// Size, dimension and spacing of a cloud of points.
#ifndef PD_MESH_GEOMETRY_HPP
#define PD_MESH_GEOMETRY_HPP

#include <array>
#include <vector>

#include "mesh_points.hpp"

namespace pd {

struct BoundingBox {
  std::array<double, 3> low{}, high{};
  double extent(int axis) const {
    const auto k = static_cast<std::size_t>(axis);
    return high[k] - low[k];
  }
  double diagonal() const;
  /// "[0, 0.2] x [-0.05, 0.05] x [0, 0]"
  std::string text() const;
};

/// Of all points; of one point at the origin where there are none.
BoundingBox boundingBox(const MeshPoints& points);

/// Length below which two coordinates count as equal where a user's geometry (a box, a crack plane) meets points that
/// lie on its border: 1e-10 of the mesh's diagonal, far above rounding and far below any spacing.
double geometricTolerance(const BoundingBox& box);

/// 1 (all points on a line along x), 2 (all in one z plane) or 3.
int meshDimension(const BoundingBox& box);

/// Spacing of points from their volumes, m: cbrt(V) in 3D, sqrt(V / thickness) in 2D, V / crossSectionArea in 1D.
std::vector<double> pointSpacings(const std::vector<double>& volume, int dimension, double thickness,
                                  double crossSectionArea);

}  // namespace pd

#endif
