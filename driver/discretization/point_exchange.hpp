// Values of ghosts and images, from the points that they stand for and back.
#ifndef PD_POINT_EXCHANGE_HPP
#define PD_POINT_EXCHANGE_HPP

#include <optional>

#include "../parallel/ghost_exchange.hpp"
#include "discretization.hpp"

namespace pd {

/// Arrays are over all local points (owned, ghosts, images), `width` values a point, point after point. `rule`: what a
/// plane of symmetry makes of them; without a rule images are left alone. On one rank without images all calls do
/// nothing.
class PointExchange {
 public:
  /// Refers to both. Collective.
  PointExchange(const Communicator& comm, const Discretization& discretization);

  /// Overwrites ghosts with their owners' values, and images with the mirrored values of their sources. Collective.
  void import(double* values, int width, std::optional<Reflection> rule) const;
  /// Images alone, from what this rank has. Ghosts must be up to date.
  void fillImages(double* values, int width, std::optional<Reflection> rule) const;
  /// Adds what images hold, mirrored back, to their sources, and then ghosts' values to their owners'. Images are left
  /// as they were; ghosts hold what their images have added. Collective.
  void exportAdd(double* values, int width, std::optional<Reflection> rule) const;

 private:
  const Discretization& points_;
  GhostExchange ghosts_;
};

}  // namespace pd

#endif
