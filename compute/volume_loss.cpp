// Volume_Loss: volume of the metal that has dissolved, m3.
#include "dissolved_metal_sum.hpp"
#include "plugins.hpp"

namespace pd {

class VolumeLoss : public DissolvedMetalSum {
 public:
  struct Fields : DissolvedMetalSum::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : DissolvedMetalSum::Fields(parameters, "m3", "Volume of metal that has dissolved.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    DissolvedMetalSum::declareParameters(declarations, "Volume_Loss");
  }
  VolumeLoss(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : DissolvedMetalSum(completeParameters<VolumeLoss>(params, "Volume_Loss"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, volumes(blocks).dissolved);
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::VolumeLoss;
PD_REGISTER_COMPUTE(VolumeLoss, "Volume_Loss", "Volume of the metal that has dissolved, m3.")
