// Mass_Loss: mass of the metal that has dissolved, kg.
#include "metal_loss.hpp"
#include "plugins.hpp"

namespace pd {

class MassLoss : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    MetalLoss::declareParameters(declarations, "Mass_Loss");
    declarations.real("Molar Mass", "kg/mol", "Of the metal: 0.05585 for iron.").positive().required();
  }
  MassLoss(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : MassLoss(completeParameters<MassLoss>(params, "Mass_Loss"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override { return loss_.fieldIds(); }
  void initialize(Blocks blocks) override { loss_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    loss_.sum(blocks, *epetraComm, molarMass_,
              [](const DissolvedMetal::View& metal, int id) { return metal.solidConcentration(id); });
    return 0;
  }

 private:
  MassLoss(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
           ComputeParameters globalData)
      : Compute(params, comm, globalData),
        loss_(parameters, globalData),
        molarMass_(parameters.get<double>("Molar Mass")) {}

  MetalLoss loss_;
  double molarMass_;
};

}  // namespace pd

using pd::MassLoss;
PD_REGISTER_COMPUTE(MassLoss, "Mass_Loss", "Mass of the metal that has dissolved, kg.")
