// Volume_Loss: volume of the metal that has dissolved, m3.
#include "metal_loss.hpp"
#include "plugins.hpp"

namespace pd {

class VolumeLoss : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    MetalLoss::declareParameters(declarations, "Volume_Loss");
  }
  VolumeLoss(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData), loss_(completeParameters<VolumeLoss>(params, "Volume_Loss"), globalData) {}

  std::vector<int> FieldIds() const override { return loss_.fieldIds(); }
  void initialize(Blocks blocks) override { loss_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    loss_.sum(blocks, *epetraComm, 1.0, [](const DissolvedMetal::View&, int) { return 1.0; });
    return 0;
  }

 private:
  MetalLoss loss_;
};

}  // namespace pd

using pd::VolumeLoss;
PD_REGISTER_COMPUTE(VolumeLoss, "Volume_Loss", "Volume of the metal that has dissolved, m3.")
