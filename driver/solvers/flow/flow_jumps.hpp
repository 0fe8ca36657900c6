// Where the velocities of the walls of a flow jump.
#ifndef PD_FLOW_JUMPS_HPP
#define PD_FLOW_JUMPS_HPP

#include <vector>

#include "flow_geometry.hpp"

namespace pd {

/// Jumps are seen by fluid points whose bonds meet two walls near each other, as at the corners of a lid.
struct FlowJumps {
  std::vector<double> places;    ///< [3 n] of such points of all ranks, m
  double largestVelocity = 0.0;  ///< of walls and inlets where bonds meet them, all ranks, m/s

  /// Whether a jump is so near that no polynomial fits the velocity around the point.
  bool areNear(const FlowGeometry& geometry, int point) const;
};

/// In the solver's time t. Collective.
FlowJumps findFlowJumps(const FlowGeometry& geometry, const Communicator& comm, double t);

}  // namespace pd

#endif
