#include "growth_specimen.hpp"

#include <algorithm>
#include <cmath>

namespace pd {

namespace {

HalfBody halfSpecimen(double horizon, double width, double growth) {
  // Of the standard, in W: length ahead of the line of load and height of a half, place and radius of the hole.
  constexpr double front = 0.25, height = 0.6, pinHeight = 0.275, pinRadius = 0.125;
  constexpr double middle = 0.5;
  const double w = width * horizon;
  const double rim = std::max(0.15, pinRadius + 1.2 / w);  // radius up to which the pin presses: a point at least
  HalfBody half;
  half.nRows = static_cast<int>(std::lround(height * w));
  half.nColumns = static_cast<int>(std::lround((1.0 + front) * w));
  half.firstColumn = static_cast<int>(std::lround((front + middle) * w - 0.75 * growth * horizon));
  for (int column = 0; column < half.nColumns; ++column)
    for (int row = 0; row < half.nRows; ++row) {
      const double x = column + 0.5 - front * w, y = row + 0.5 - pinHeight * w, distance = std::hypot(x, y) / w;
      half.isHole.push_back(distance <= pinRadius ? 1 : 0);
      if (distance > pinRadius && distance < rim && y > 1.5 * std::abs(x))
        half.pulled.push_back(half.point(column, row));
    }
  return half;
}

}  // namespace

GrowthSpecimen::GrowthSpecimen(const std::vector<LatticeBond>& bonds, double horizon, double width, double growth)
    : GrowthBody(bonds, horizon, halfSpecimen(horizon, width, growth), growth) {}

}  // namespace pd
