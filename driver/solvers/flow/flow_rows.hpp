// The nonlocal operators of a flow as rows over the points of this rank.
#ifndef PD_FLOW_ROWS_HPP
#define PD_FLOW_ROWS_HPP

#include "flow_geometry.hpp"
#include "flow_jumps.hpp"
#include "flow_operator.hpp"
#include "flow_sources.hpp"

namespace pd {

/// Values at the time of the boundaries. v, p: velocity and pressure of the points.
struct FlowRows {
  FlowOperator<9> viscous;           ///< lap v_a = sum w[3a + b] v_b + c[3a]
  FlowOperator<9> gradient;          ///< dv_a/dx_b = sum w[3a + b] v_a + c[3a + b]
  FlowOperator<3> divergence;        ///< div v = sum w[a] v_a + c[0]
  FlowOperator<3> pressureGradient;  ///< dp/dx_a = sum w[a] p + c[a]
  FlowOperator<1> smoothing;         ///< fourth differences of the pressure (flow_weights.hpp), 1/m2
  std::vector<FlowSource> sources;   ///< by which constants follow boundaries from time to time
  FlowJumps jumps;
  long long nAtJumps = 0;  ///< points whose divergence is a balance of mass, all ranks

  /// As of FlowOperator.
  void expect(std::size_t nRows) {
    viscous.expect(nRows);
    gradient.expect(nRows);
    divergence.expect(nRows);
    pressureGradient.expect(nRows);
    smoothing.expect(nRows);
  }
  void repeat(std::size_t row, int point) {
    viscous.repeat(row, point);
    gradient.repeat(row, point);
    divergence.repeat(row, point);
    pressureGradient.repeat(row, point);
    smoothing.repeat(row, point);
  }
  void takeStencils(FlowRows& earlier) {
    viscous.takeStencils(earlier.viscous);
    gradient.takeStencils(earlier.gradient);
    divergence.takeStencils(earlier.divergence);
    pressureGradient.takeStencils(earlier.pressureGradient);
    smoothing.takeStencils(earlier.smoothing);
  }
  void keep(const FlowRows& earlier, std::size_t row, int point) {
    viscous.keep(earlier.viscous, row, point);
    gradient.keep(earlier.gradient, row, point);
    divergence.keep(earlier.divergence, row, point);
    pressureGradient.keep(earlier.pressureGradient, row, point);
    smoothing.keep(earlier.smoothing, row, point);
  }
  void finish() {
    viscous.finish();
    gradient.finish();
    divergence.finish();
    pressureGradient.finish();
    smoothing.finish();
  }
};

/// In the solver's time t. Throws DeckError where a point has too few neighbours, with its place. Collective.
///
/// Velocities: of a bond that meets a wall what it has there; beyond an outflow that of the mirrored place. Pressures:
/// from ends in the fluid, and at outflows.
/// The divergence is that of the gradient, exact for quadratic fields. Where the velocity of walls jumps, as at the
/// corners of a lid, no polynomial is near, and that divergence leaks mass into the flow. There it is the negative
/// transpose of the pressure's gradient, by which mass is balanced from point to point, with the flux of each wall
/// through itself. In bodies of revolution both operators have the terms with 1/r.
FlowRows makeFlowRows(const FlowGeometry& geometry, const Communicator& comm, double t);

/// Rows of another geometry of the same mesh and boundaries, none of whose values follow time (no sources).
struct EarlierFlowRows {
  FlowRows rows;
  std::vector<int> fluid;         ///< that of its geometry
  std::vector<double> isChanged;  ///< [points] 1 where it is solid in one geometry alone; ghosts agree with owners
};

/// The same as makeFlowRows(); rows around which nothing has changed are the earlier ones. Collective.
FlowRows renewFlowRows(EarlierFlowRows earlier, const FlowGeometry& geometry, Model& model, double t);

}  // namespace pd

#endif
