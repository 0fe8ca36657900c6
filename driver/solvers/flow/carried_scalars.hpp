// Where what a flow carries along goes.
#ifndef PD_CARRIED_SCALARS_HPP
#define PD_CARRIED_SCALARS_HPP

#include "flow_geometry.hpp"

namespace pd {

/// What bonds up to `reach` (m) carry must have a place to go to: scalars have prescribed values beyond outflows, where
/// nothing would take them up, and all blocks that the flow goes on into carry them. Throws DeckError for outflows,
/// RunError for blocks. Collective.
void requireWayOut(Simulation& simulation, const FlowGeometry& geometry, double reach);

}  // namespace pd

#endif
