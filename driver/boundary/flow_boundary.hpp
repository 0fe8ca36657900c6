// What bounds a flow: walls and inlets, whose velocity is given, and outflows, where the pressure is. Forces on it.
#ifndef PD_FLOW_BOUNDARY_HPP
#define PD_FLOW_BOUNDARY_HPP

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "../deck/function.hpp"
#include "../discretization/discretization.hpp"

namespace pd {

class BoundaryConditions;

/// Conditions derive from it; a solver of flows finds it by a cast. Its points are those beyond the boundary.
class FlowBoundary {
 public:
  virtual ~FlowBoundary() = default;
  virtual bool isOutflow() const = 0;
  /// Of its velocity or pressure.
  virtual bool dependsOnTime() const = 0;
  virtual bool dependsOnPlace() const = 0;
  /// Of a wall or an inlet, at a place x [3], m, on it; m/s. Throws DeckError where it is not finite.
  virtual std::array<double, 3> velocityAt(const double* x, double t) const = 0;
  /// Of an outflow; Pa. Throws DeckError where it is not finite.
  virtual double pressureAt(const double* x, double t) const = 0;

  /// Where the boundary is, if the deck says so: zero there, positive in the fluid, negative beyond.
  bool hasSurface() const { return surface_.has_value(); }
  double surfaceAt(const double* x) const { return (*surface_)(x[0], x[1], x[2], 0.0); }
  /// Whether both are walls (or inlets) or both outflows, for which the deck has the same functions, letter by letter.
  bool isGivenAs(const FlowBoundary& other) const {
    return isOutflow() == other.isOutflow() && given_.has_value() && given_ == other.given_;
  }
  /// Gradient of the surface's function, 1/m of its unit, which points into the fluid; by differences over `step`, m.
  std::array<double, 3> surfaceGradient(const double* x, double step, int dimension) const;

 protected:
  /// Reads key Surface, if it is there. Throws DeckError.
  explicit FlowBoundary(const DeckNode& node);
  /// Throws DeckError that names the place of the function and x where its value is not finite.
  static double finiteValue(const Function& function, const DeckNode& node, const double* x, double t);

 private:
  std::optional<Function> surface_;
  std::optional<std::vector<std::string>> given_;  ///< its Velocity and Pressure; nothing where they are tables
};

/// A force per volume on a flow. Conditions derive from it; solvers of flows find it by a cast.
class FlowForce {
 public:
  virtual ~FlowForce() = default;
  virtual bool dependsOnTime() const = 0;
  /// Adds to `force` [3 nOwned], N/m3, at time t of the run.
  virtual void addTo(const Discretization& mesh, double t, double* force) const = 0;
};

/// All of them in a run.
class FlowForces {
 public:
  explicit FlowForces(const BoundaryConditions& conditions);
  bool empty() const { return forces_.empty(); }
  bool dependOnTime() const;
  /// Their sum at the solver's time t, [3 nOwned], N/m3. Throws DeckError where one is not finite.
  std::vector<double> at(const Discretization& mesh, double t) const;

 private:
  const BoundaryConditions& conditions_;
  std::vector<const FlowForce*> forces_;
};

}  // namespace pd

#endif
