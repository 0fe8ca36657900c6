// Node_Set_Data: minimum, maximum or sum of a field over a node set.
#include "plugins.hpp"
#include "set_reduction.hpp"

namespace pd {

class NodeSetData : public SetReduction {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declarations.text("Node Set", "Name of the node set.").required();
    SetReduction::declareParameters(declarations);
  }
  NodeSetData(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SetReduction(completeParameters<NodeSetData>(params, "Node_Set_Data"), params, comm, globalData) {}
};

}  // namespace pd

using pd::NodeSetData;
PD_REGISTER_COMPUTE(NodeSetData, "Node_Set_Data", "Minimum, maximum or sum of a field over a node set.")
