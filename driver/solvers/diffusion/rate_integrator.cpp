#include "rate_integrator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd {

int equalSteps(double increment, double longestStep) {
  const double n = std::ceil(increment / longestStep * (1.0 - 1.0e-12));
  if (n > std::numeric_limits<int>::max())
    throw RunError(
        fmt::format("Diffusion: an increment of {:.6g} s takes {:.3g} steps of {:.6g} s, more than can be "
                    "counted; take longer steps or more increments",
                    increment, n, longestStep));
  return std::max(1, static_cast<int>(n));
}

}  // namespace pd
