// Maximum_Depth: largest depth to which a surface has dissolved, m.
#include "plugins.hpp"
#include "surface_compute.hpp"

namespace pd {

class MaximumDepth : public SurfaceCompute {
 public:
  struct Fields : SurfaceCompute::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : SurfaceCompute::Fields(parameters, pd::fields::globalScalar, "m",
                                 "Largest depth to which the surface has dissolved.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    SurfaceCompute::declareParameters(declarations, "Maximum_Depth");
  }
  MaximumDepth(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : SurfaceCompute(completeParameters<MaximumDepth>(params, "Maximum_Depth"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }
  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, maximumDepth(profile(blocks)));
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::MaximumDepth;
PD_REGISTER_COMPUTE(MaximumDepth, "Maximum_Depth", "Largest depth to which a surface has dissolved (that of a pit), m.")
