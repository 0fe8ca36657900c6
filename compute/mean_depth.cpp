// Mean_Depth: mean depth to which a surface has dissolved, m.
#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

class MeanDepth : public SurfaceCompute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Mean_Depth");
  }
  MeanDepth(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<MeanDepth>(params, "Mean_Depth"), params, comm, globalData, scalarResult) {}

  int compute(Blocks blocks) const override {
    setGlobal(blocks, outputField_, meanDepth(profile(blocks)));
    return 0;
  }
};

}  // namespace pd

using pd::MeanDepth;
PD_REGISTER_COMPUTE(MeanDepth, "Mean_Depth", "Mean depth to which a surface has dissolved, m.")
