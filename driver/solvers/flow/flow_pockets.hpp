// Parts of the fluid that no bond connects.
#ifndef PD_FLOW_POCKETS_HPP
#define PD_FLOW_POCKETS_HPP

#include <string>
#include <vector>

#include "../../model/model.hpp"
#include "flow_rows.hpp"

namespace pd {

/// In a pocket without an outflow the pressure is known but for a constant.
struct FlowPockets {
  struct Pocket {
    int firstPoint = -1;    ///< local id of its point of the smallest global id, if this rank owns it; else -1
    bool isOpen = false;    ///< it has an outflow
    double volume = 0.0;    ///< m3, all ranks
    long long nPoints = 0;  ///< all ranks
  };
  std::vector<Pocket> pockets;
  std::vector<int> pocketOf;  ///< [owned points] -1: not fluid
};

/// Points are connected where one has a part in the gradient of the other's pressure. Collective.
FlowPockets findFlowPockets(Model& model, const FlowGeometry& geometry, const FlowRows& rows);

/// What flows into or out of a pocket, the most of all, over `velocity` and the width of the pocket. `flows`: by
/// pocket, the mean divergence times the spacing, m/s.
double largestNetFlow(const FlowPockets& pockets, const std::vector<double>& flows, double velocity,
                      std::size_t dimension);

/// Throws RunError, which begins with `where`, if walls and inlets contradict each other by that flow; `why`: an end of
/// a sentence that says what stands against it.
void requireNoNetFlow(double netFlow, const std::string& where, const std::string& why);

}  // namespace pd

#endif
