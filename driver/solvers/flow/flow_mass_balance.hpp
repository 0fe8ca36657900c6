// The divergence of a flow as a balance of mass.
#ifndef PD_FLOW_MASS_BALANCE_HPP
#define PD_FLOW_MASS_BALANCE_HPP

#include <map>
#include <vector>

#include "flow_end_velocities.hpp"
#include "flow_operator.hpp"
#include "flow_pressure_fits.hpp"

namespace pd {

/// -sum_j V_j/V_i G_ji v_j at a point i, with G the gradient of the pressure, and the flux through walls and inlets.
/// That through outflows is in the first term, since pressures are known there.
class MassBalance {
 public:
  MassBalance(const FlowGeometry& geometry, PressureFits& fits, EndVelocities& velocities)
      : geometry_(geometry), fits_(fits), velocities_(velocities), n_(static_cast<std::size_t>(geometry.dimension())) {}

  /// Adds the row of a point, and closes it. `candidates`: its neighbours, and itself.
  void addRow(int point, const std::vector<int>& candidates, FlowOperator<3>& divergence);

 private:
  using Vector = std::array<double, 3>;
  /// What is said of a boundary by the bonds that meet it around a point.
  struct Facet {
    Vector normal{}, velocity{};
    SourceWeights<double> sources{};  ///< of the sum of velocities
    double count = 0.0;
    double area = 0.0;  ///< over the volume of the point, 1/m
  };
  using Facets = std::map<int, Facet>;  ///< by boundary

  Vector addPoints(int point, const std::vector<int>& candidates, FlowOperator<3>& divergence, Facets& facets);
  void addFacets(int point, const std::vector<int>& candidates, Facets& facets);
  void splitArea(const Vector& area, Facets& facets) const;

  const FlowGeometry& geometry_;
  PressureFits& fits_;
  EndVelocities& velocities_;
  const std::size_t n_;
};

}  // namespace pd

#endif
