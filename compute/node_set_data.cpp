// Node_Set_Data: minimum, maximum or sum of a field over a node set.
#include "plugins.hpp"
#include "set_reduction.hpp"

namespace pd {

class NodeSetData : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declarations.text("Node Set", "Name of the node set.").required();
    SetReduction::declareParameters(declarations);
  }
  NodeSetData(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        reduction_(completeParameters<NodeSetData>(params, "Node_Set_Data"), globalData) {}

  std::vector<int> FieldIds() const override { return reduction_.fieldIds(); }
  void initialize(Blocks blocks) override { reduction_.initialize(blocks); }
  int compute(Blocks blocks) const override {
    reduction_.compute(blocks, *epetraComm);
    return 0;
  }

 private:
  SetReduction reduction_;
};

}  // namespace pd

using pd::NodeSetData;
PD_REGISTER_COMPUTE(NodeSetData, "Node_Set_Data", "Minimum, maximum or sum of a field over a node set.")
