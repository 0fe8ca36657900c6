// Mass_Loss: mass of the metal that has dissolved, kg.
#include "dissolved_metal_sum.hpp"
#include "plugins.hpp"

namespace pd {

class MassLoss : public DissolvedMetalSum {
 public:
  struct Fields : DissolvedMetalSum::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : DissolvedMetalSum::Fields(parameters, "kg", "Mass of metal that has dissolved.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    DissolvedMetalSum::declareParameters(declarations, "Mass_Loss");
    declarations.real("Molar Mass", "kg/mol", "Of the metal: 0.05585 for iron.").positive().required();
  }
  MassLoss(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : DissolvedMetalSum(completeParameters<MassLoss>(params, "Mass_Loss"), params, comm, globalData),
        molarMass_(parameters_.get<double>("Molar Mass")),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, molarMass_ * amounts(blocks).dissolved);
    return 0;
  }

 private:
  double molarMass_;
  Fields fields_;
};

}  // namespace pd

using pd::MassLoss;
PD_REGISTER_COMPUTE(MassLoss, "Mass_Loss", "Mass of the metal that has dissolved, kg.")
