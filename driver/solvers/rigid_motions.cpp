#include "rigid_motions.hpp"

namespace pd {

RigidMotions::Mode RigidMotions::at(const Point& place, int axis) const {
  Mode row{};
  row[static_cast<std::size_t>(axis)] = 1.0;
  std::size_t mode = static_cast<std::size_t>(dimension);
  for (int a = 0; a < dimension; ++a)
    for (int b = a + 1; b < dimension; ++b, ++mode) {
      if (axis == a) row[mode] = -(place[static_cast<std::size_t>(b)] - centre[static_cast<std::size_t>(b)]) / radius;
      if (axis == b) row[mode] = (place[static_cast<std::size_t>(a)] - centre[static_cast<std::size_t>(a)]) / radius;
    }
  return row;
}

RigidMotions::Mode RigidMotions::at(const Point& place, int axis, const Symmetry::Matrix& copy) const {
  Mode row{};
  for (int d = 0; d < dimension; ++d) {
    const double share = copy[static_cast<std::size_t>(3 * axis + d)];
    if (share == 0.0) continue;
    const Mode along = at(place, d);
    for (std::size_t mode = 0; mode < row.size(); ++mode) row[mode] += share * along[mode];
  }
  return row;
}

std::array<double, 3> RigidMotions::moment(const Mode& work) const {
  // The motions turn x to y, x to z and y to z.
  if (dimension == 2) return {0.0, 0.0, radius * work[2]};
  if (dimension == 3) return {radius * work[5], -radius * work[4], radius * work[3]};
  return {};
}

}  // namespace pd
