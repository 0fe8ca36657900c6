#include "horizon_shape.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pd::kernels {

HorizonShape::HorizonShape(const std::vector<double>& halfAxes, const std::vector<double>& degrees, bool isBox)
    : isBall_(false), isBox_(isBox) {
  if (halfAxes.empty() || halfAxes.size() > 3)
    throw std::invalid_argument("\"Horizon Axes\" takes one to three half axes, along x, y and z");
  for (const double axis : halfAxes)
    if (!(axis > 0.0) || !std::isfinite(axis)) throw std::invalid_argument("\"Horizon Axes\" must be positive");
  if (!degrees.empty() && degrees.size() != 1 && degrees.size() != 3)
    throw std::invalid_argument("\"Horizon Rotation\" takes one angle, about z, or three, about x, y and z");
  radius_ = *std::max_element(halfAxes.begin(), halfAxes.end());
  for (std::size_t k = 0; k < halfAxes.size(); ++k) scale_[k] = radius_ / halfAxes[k];
  std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) { return scale_[a] < scale_[b]; });

  const auto turn = [&](std::size_t first, std::size_t second, double angle) {
    const double radians = angle * std::acos(-1.0) / 180.0, c = std::cos(radians), s = std::sin(radians);
    for (auto& axis : axes_) {
      const double a = axis[first], b = axis[second];
      axis[first] = c * a - s * b;
      axis[second] = s * a + c * b;
    }
  };
  if (degrees.size() == 3) {
    turn(1, 2, degrees[0]);
    turn(2, 0, degrees[1]);
  }
  if (!degrees.empty()) turn(0, 1, degrees.back());
}

}  // namespace pd::kernels
