// What the points of a half plane stand for in a body of revolution: rings.
#ifndef PD_RINGS_HPP
#define PD_RINGS_HPP

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace pd {

/// The key by which a plug-in of points in a plane learns that these are the half section of a body of revolution: "x"
/// or "y". Those that declare it work in such a body; the host gives it to them.
inline constexpr const char* axisOfRevolution = "Axis Of Revolution";

namespace kernels {

/// A point at the distance r from the axis with a cell of the section A is a ring of the volume 2 pi r A (Pappus), and
/// a bond of the plane is all bonds between two rings. With w(|xi|) the weight of the plane, whose sums are per area,
///   r_i dC_i/dt = sum_j g_ij w_ij A_j (C_j - C_i),   g_ij = g_ji:
/// what leaves one ring arrives at the other. With g the mean radius m = (r_i + r_j)/2 that is d/dr (r dC/dr)/r, but
/// between points n spacings apart r^2 passes 2 n m^2, and m^2 has, over the n such bonds across a cylinder of the
/// radius R, the mean R^2 + (n^2 - 1) h^2/12. Hence
///   g = m - (xi_r^2 - h^2)/(12 m)   where |xi_r| is above the spacing h,
/// by which each cylinder passes 2 R^2 a neighbour, exactly. Nothing passes through the axis: bonds to points beyond it
/// (images) have g = 0. Then the points nearest to the axis are right, too, where bonds are one or two spacings long,
/// and as a whole where they are longer.
class Rings {
 public:
  Rings() = default;
  explicit Rings(int axis) : radial_(1 - axis) {}  ///< 0: about x, y the radius; 1: about y
  /// "x" or "y"; empty: none.
  explicit Rings(const std::string& axis) : radial_(axis == "x" ? 1 : axis == "y" ? 0 : -1) {}

  bool areUsed() const { return radial_ >= 0; }
  std::size_t radial() const { return static_cast<std::size_t>(radial_); }  ///< which coordinate the radius is
  /// Distance of a point from the axis, m. x [3 n].
  double radius(const double* x, int point) const { return std::abs(coordinate(x, point)); }
  /// Volume of the cell in a plane 1 m thick, m3; without rings the volume itself.
  double planeVolume(const double* x, const double* volume, int point) const {
    return areUsed() ? volume[point] / (2.0 * M_PI * radius(x, point)) : volume[point];
  }
  std::vector<double> planeVolumes(const double* x, const double* volume, int nPoints) const {
    std::vector<double> result(static_cast<std::size_t>(nPoints));
    for (int i = 0; i < nPoints; ++i) result[static_cast<std::size_t>(i)] = planeVolume(x, volume, i);
    return result;
  }
  /// g/r_i of the bond from point i to j, as far as `part` of it; 1 without rings. `spacing`: of both cells, m.
  double share(const double* x, int i, int j, double spacing, double part = 1.0) const {
    if (!areUsed()) return 1.0;
    const double from = coordinate(x, i), along = part * (coordinate(x, j) - from);
    if (from * (from + along) <= 0.0) return 0.0;
    const double mean = std::abs(from + 0.5 * along), longer = along * along - spacing * spacing;
    return (longer > 0.0 ? mean - longer / (12.0 * mean) : mean) / std::abs(from);
  }

 private:
  double coordinate(const double* x, int point) const { return x[3 * static_cast<std::size_t>(point) + radial()]; }
  int radial_ = -1;
};

}  // namespace kernels
}  // namespace pd

#endif
