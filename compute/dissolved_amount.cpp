// Dissolved_Amount: metal that has dissolved, mol: C_solid times its volume, wherever its ions are by now.
#include "metal_loss.hpp"
#include "plugins.hpp"

namespace pd {

class DissolvedAmount : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    MetalLoss::declareParameters(declarations, "Dissolved_Amount");
  }
  DissolvedAmount(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        loss_(completeParameters<DissolvedAmount>(params, "Dissolved_Amount"), globalData) {}

  std::vector<int> FieldIds() const override { return loss_.fieldIds(); }
  void initialize(Blocks blocks) override { loss_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    loss_.sum(blocks, *epetraComm, 1.0,
              [](const DissolvedMetal::View& metal, int id) { return metal.solidConcentration(id); });
    return 0;
  }

 private:
  MetalLoss loss_;
};

}  // namespace pd

using pd::DissolvedAmount;
PD_REGISTER_COMPUTE(DissolvedAmount, "Dissolved_Amount", "Metal that has dissolved, mol.")
