// Block_Data: minimum, maximum or sum of a field over a block.
#include "plugins.hpp"
#include "set_reduction.hpp"

namespace pd {

class BlockData : public SetReduction {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declarations.text("Block", "Name of the block.").required();
    SetReduction::declareParameters(declarations);
  }
  BlockData(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SetReduction(completeParameters<BlockData>(params, "Block_Data"), params, comm, globalData) {}
};

}  // namespace pd

using pd::BlockData;
PD_REGISTER_COMPUTE(BlockData, "Block_Data", "Minimum, maximum or sum of a field over a block.")
