// Mean_Depth: mean depth to which a surface has dissolved, m.
#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

class MeanDepth : public SurfaceCompute {
 public:
  struct Fields : SurfaceCompute::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCompute::Fields(parameters, pd::fields::globalScalar, "m",
                                 "Mean depth to which the surface has dissolved.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Mean_Depth");
  }
  MeanDepth(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<MeanDepth>(params, "Mean_Depth"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, meanDepth(profile(blocks)));
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::MeanDepth;
PD_REGISTER_COMPUTE(MeanDepth, "Mean_Depth", "Mean depth to which a surface has dissolved, m.")
