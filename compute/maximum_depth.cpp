// Maximum_Depth: largest depth to which a surface has dissolved, m.
#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

class MaximumDepth : public SurfaceCompute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Maximum_Depth");
  }
  MaximumDepth(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<MaximumDepth>(params, "Maximum_Depth"), params, comm, globalData,
                       scalarResult) {}

  int compute(Blocks blocks) const override {
    setGlobal(blocks, outputField_, maximumDepth(profile(blocks)));
    return 0;
  }
};

}  // namespace pd

using pd::MaximumDepth;
PD_REGISTER_COMPUTE(MaximumDepth, "Maximum_Depth", "Largest depth to which a surface has dissolved (that of a pit), m.")
