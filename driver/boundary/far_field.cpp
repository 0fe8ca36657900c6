#include "far_field.hpp"

#include <cmath>

namespace pd {

double exchangeRate(double diffusivity, double distance, double thickness) {
  const double share = thickness / (thickness + distance);
  // y tanh y is convex where it matters and rises, and y tanh y < y^2: Newton's method starts below the root and, past
  // its first step, comes down to it.
  double y = std::sqrt(share);
  for (int iteration = 0; iteration < 50; ++iteration) {
    const double t = std::tanh(y);
    const double change = (y * t - share) / (t + y * (1.0 - t * t));
    y -= change;
    if (std::abs(change) <= 1e-15 * y) break;
  }
  return diffusivity * (y / thickness) * (y / thickness);
}

}  // namespace pd
