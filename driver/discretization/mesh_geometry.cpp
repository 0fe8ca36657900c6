#include "mesh_geometry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pd {

double BoundingBox::diagonal() const { return std::hypot(extent(0), extent(1), extent(2)); }

std::string BoundingBox::text() const {
  return fmt::format("[{:.6g}, {:.6g}] x [{:.6g}, {:.6g}] x [{:.6g}, {:.6g}]", low[0], high[0], low[1], high[1], low[2],
                     high[2]);
}

BoundingBox boundingBox(const MeshPoints& points) {
  BoundingBox box;
  for (int i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = points.at(i)[k];
      box.low[k] = i == 0 ? value : std::min(box.low[k], value);
      box.high[k] = i == 0 ? value : std::max(box.high[k], value);
    }
  return box;
}

double geometricTolerance(const BoundingBox& box) { return 1e-10 * box.diagonal(); }

int meshDimension(const BoundingBox& box) {
  const double tolerance = geometricTolerance(box);
  if (box.extent(2) > tolerance) return 3;
  return box.extent(1) > tolerance ? 2 : 1;
}

std::vector<double> pointSpacings(const std::vector<double>& volume, int dimension, double thickness,
                                  double crossSectionArea) {
  std::vector<double> spacing(volume.size());
  std::transform(volume.begin(), volume.end(), spacing.begin(), [&](double v) {
    if (dimension == 1) return v / crossSectionArea;
    return dimension == 2 ? std::sqrt(v / thickness) : std::cbrt(v);
  });
  return spacing;
}

}  // namespace pd
