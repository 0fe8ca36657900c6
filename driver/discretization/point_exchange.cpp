#include "point_exchange.hpp"

#include <array>

namespace pd {

PointExchange::PointExchange(const Communicator& comm, const Discretization& discretization)
    : points_(discretization),
      ghosts_(comm, {discretization.globalIds.begin(), discretization.globalIds.begin() + discretization.firstImage()},
              discretization.nOwned) {}

void PointExchange::import(double* values, int width, std::optional<Reflection> rule) const {
  ghosts_.import(values, width);
  fillImages(values, width, rule);
}

void PointExchange::fillImages(double* values, int width, std::optional<Reflection> rule) const {
  if (!rule) return;
  for (int image = points_.firstImage(); image < points_.nPoints; ++image)
    points_.symmetry.reflect(points_.copyOf(image), *rule, width,
                             values + static_cast<long long>(width) * points_.sourceOf(image),
                             values + static_cast<long long>(width) * image);
}

void PointExchange::exportAdd(double* values, int width, std::optional<Reflection> rule) const {
  std::array<double, 9> mirrored{};  // no field is wider
  for (int image = points_.firstImage(); rule && image < points_.nPoints; ++image) {
    points_.symmetry.reflect(points_.copyOf(image), *rule, width, values + static_cast<long long>(width) * image,
                             mirrored.data());
    double* source = values + static_cast<long long>(width) * points_.sourceOf(image);
    for (int k = 0; k < width; ++k) source[k] += mirrored[static_cast<std::size_t>(k)];
  }
  ghosts_.exportAdd(values, width);
}

}  // namespace pd
