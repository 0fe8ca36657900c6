// Horizons that are not balls: ellipsoids and boxes, turned or not.
#ifndef PD_HORIZON_SHAPE_HPP
#define PD_HORIZON_SHAPE_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pd::kernels {

/// A linear map under which the horizon is a ball, or a cube, of the radius of its longest half axis. Grids whose
/// spacings have the ratio of the axes are square or cubic under it.
/// (Horizons of any shape: Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512, section 4.)
class HorizonShape {
 public:
  HorizonShape() = default;  ///< a ball, of any radius
  /// `halfAxes`: 1 to 3, in m, along x, y, z; axes that are not given are as long as the longest. `degrees`: none; one:
  /// turned about z; three: about x, then y, then z. `isBox`: half edges of a box.
  /// Throws std::invalid_argument where an axis is not positive or the counts are others.
  HorizonShape(const std::vector<double>& halfAxes, const std::vector<double>& degrees, bool isBox);

  bool isBall() const { return isBall_; }
  bool isBox() const { return isBox_; }
  double radius() const { return radius_; }  ///< of the ball or cube, m; 0 for the ball of any radius
  double halfAxis(std::size_t axis) const { return radius_ / scale_[axis]; }
  /// Axes, the longest first.
  const std::array<std::size_t, 3>& longestFirst() const { return order_; }

  /// Components of `vector` along the axes of the shape, m.
  std::array<double, 3> along(const double* vector) const {
    std::array<double, 3> result{};
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = axes_[k][0] * vector[0] + axes_[k][1] * vector[1] + axes_[k][2] * vector[2];
    return result;
  }
  /// Those in the mapped space.
  std::array<double, 3> mapped(const std::array<double, 3>& along) const {
    return {along[0] * scale_[0], along[1] * scale_[1], along[2] * scale_[2]};
  }
  /// The distance that the horizon limits: in mapped space, Euclidean or largest component.
  double length(const std::array<double, 3>& mapped) const {
    if (isBox_) return std::max({std::abs(mapped[0]), std::abs(mapped[1]), std::abs(mapped[2])});
    return std::sqrt(mapped[0] * mapped[0] + mapped[1] * mapped[1] + mapped[2] * mapped[2]);
  }
  /// Mapped volume of a unit of volume.
  double volumeFactor() const { return scale_[0] * scale_[1] * scale_[2]; }

 private:
  bool isBall_ = true, isBox_ = false;
  double radius_ = 0.0;
  std::array<double, 3> scale_{1.0, 1.0, 1.0};
  std::array<std::array<double, 3>, 3> axes_{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};  ///< unit vectors
  std::array<std::size_t, 3> order_{0, 1, 2};
};

}  // namespace pd::kernels

#endif
