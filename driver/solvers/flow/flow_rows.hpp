// The nonlocal operators of a flow as rows over the points of this rank.
#ifndef PD_FLOW_ROWS_HPP
#define PD_FLOW_ROWS_HPP

#include <array>
#include <vector>

#include "flow_geometry.hpp"

namespace pd {

/// A velocity (or in its first component a pressure) of a boundary that changes with time, at a place on it.
struct FlowSource {
  int boundary;
  bool isPressure;
  std::array<double, 3> place, value;  ///< value: at the time of the rows
};

/// A row for each owned fluid point: N weights of each point that has a part in it, and a constant from the boundaries.
template <std::size_t N>
struct FlowOperator {
  struct Term {
    int point;  ///< local id of a fluid point, owned or ghost
    std::array<double, N> weights;
  };
  /// What a source has in the constant of a row. Its weights are those that a point of this velocity would have.
  struct Share {
    std::size_t row, source;
    std::array<double, N> weights;
  };
  std::vector<std::size_t> start{0};
  std::vector<Term> terms;
  std::vector<std::array<double, N>> constants;
  std::vector<Share> shares;

  const Term* begin(std::size_t row) const { return terms.data() + start[row]; }
  const Term* end(std::size_t row) const { return terms.data() + start[row + 1]; }
  /// Of the row that is not yet closed.
  void addShare(std::size_t source, const std::array<double, N>& weights) {
    shares.push_back({constants.size(), source, weights});
  }
  /// Ends a row.
  void close(const std::array<double, N>& constant) {
    start.push_back(terms.size());
    constants.push_back(constant);
  }
};

/// Values at the time of the boundaries. v, p: velocity and pressure of the points.
struct FlowRows {
  FlowOperator<9> viscous;           ///< lap v_a = sum w[3a + b] v_b + c[3a]
  FlowOperator<9> gradient;          ///< dv_a/dx_b = sum w[3a + b] v_a + c[3a + b]
  FlowOperator<3> divergence;        ///< div v = sum w[a] v_a + c[0]
  FlowOperator<3> pressureGradient;  ///< dp/dx_a = sum w[a] p + c[a]
  FlowOperator<1> smoothing;         ///< fourth differences of the pressure (flow_weights.hpp), 1/m2
  std::vector<FlowSource> sources;   ///< by which constants follow boundaries from time to time
  double largestVelocity = 0.0;      ///< of walls and inlets where bonds meet them, all ranks, m/s
  long long nAtJumps = 0;            ///< points whose divergence is a balance of mass, all ranks
};

/// In the solver's time t. Throws DeckError where a point has too few neighbours, with its place. Collective.
///
/// Velocities: of a bond that meets a wall what it has there; beyond an outflow that of the mirrored place. Pressures:
/// from ends in the fluid, and at outflows.
/// The divergence is that of the gradient, exact for quadratic fields. Where the velocity of walls jumps, as at the
/// corners of a lid, no polynomial is near, and that divergence leaks mass into the flow. There it is the negative
/// transpose of the pressure's gradient, by which mass is balanced from point to point, with the flux of each wall
/// through itself.
FlowRows makeFlowRows(const FlowGeometry& geometry, const Communicator& comm, double t);

}  // namespace pd

#endif
