// The blocks and points of fluid of a run.
#ifndef PD_FLOW_BLOCKS_HPP
#define PD_FLOW_BLOCKS_HPP

#include <string>
#include <vector>

#include "../../model/model.hpp"
#include "flow_geometry.hpp"
#include "flow_law.hpp"

namespace pd {

struct FlowBlocks {
  const FlowLaw* law = nullptr;
  std::vector<int> numbers;
};

/// Throws RunError, naming `solver`, where there is no fluid or there are different ones, and where the points or the
/// planes of symmetry of the mesh do not do for a flow.
FlowBlocks findFlowBlocks(Model& model, const std::string& solver);

/// Fluid becomes 1 at the points of the flow and 0 elsewhere, for computes, which may look at it before the first flow.
void markFluid(Model& model, const FlowGeometry& geometry);

}  // namespace pd

#endif
