// What bounds a flow: walls and inlets, whose velocity is given, and outflows, where the pressure is.
#ifndef PD_FLOW_BOUNDARY_HPP
#define PD_FLOW_BOUNDARY_HPP

#include <array>
#include <optional>

#include "../deck/function.hpp"

namespace pd {

/// Conditions derive from it; a solver of flows finds it by a cast. Its points are those beyond the boundary.
class FlowBoundary {
 public:
  virtual ~FlowBoundary() = default;
  virtual bool isOutflow() const = 0;
  /// Of a wall or an inlet, at a place x [3], m, on it; m/s. Throws DeckError where it is not finite.
  virtual std::array<double, 3> velocityAt(const double* x, double t) const = 0;
  /// Of an outflow; Pa. Throws DeckError where it is not finite.
  virtual double pressureAt(const double* x, double t) const = 0;

  /// Where the boundary is, if the deck says so: zero there, positive in the fluid, negative beyond.
  bool hasSurface() const { return surface_.has_value(); }
  double surfaceAt(const double* x) const { return (*surface_)(x[0], x[1], x[2], 0.0); }
  /// Gradient of the surface's function, 1/m of its unit, which points into the fluid; by differences over `step`, m.
  std::array<double, 3> surfaceGradient(const double* x, double step, int dimension) const;

 protected:
  /// Reads key Surface, if it is there. Throws DeckError.
  explicit FlowBoundary(const DeckNode& node);
  /// Throws DeckError that names the place of the function and x where its value is not finite.
  static double finiteValue(const Function& function, const DeckNode& node, const double* x, double t);

 private:
  std::optional<Function> surface_;
};

}  // namespace pd

#endif
