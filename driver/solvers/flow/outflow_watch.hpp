// What enters through outflows, where fluid is only to leave.
#ifndef PD_OUTFLOW_WATCH_HPP
#define PD_OUTFLOW_WATCH_HPP

#include <set>
#include <string>
#include <vector>

#include "flow_geometry.hpp"

namespace pd {

/// Says of each outflow once that fluid comes in through it: how much, and where it is fastest.
class OutflowWatch {
 public:
  /// Lines to log about the velocities in the fields. Collective.
  std::vector<std::string> look(Model& model, const FlowGeometry& geometry);

 private:
  std::set<int> told_;  ///< outflows
};

}  // namespace pd

#endif
