// Block_Data: minimum, maximum or sum of a field over a block.
#include "plugins.hpp"
#include "set_reduction.hpp"

namespace pd {

class BlockData : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declarations.text("Block", "Name of the block.").required();
    SetReduction::declareParameters(declarations);
  }
  BlockData(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        reduction_(completeParameters<BlockData>(params, "Block_Data"), globalData) {}

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

using pd::BlockData;
PD_REGISTER_COMPUTE(BlockData, "Block_Data", "Minimum, maximum or sum of a field over a block.")
