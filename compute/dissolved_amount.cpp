// Dissolved_Amount: metal that has dissolved, mol: C_solid times its volume, wherever its ions are by now.
#include "dissolved_metal_sum.hpp"
#include "plugins.hpp"

namespace pd {

class DissolvedAmount : public DissolvedMetalSum {
 public:
  struct Fields : DissolvedMetalSum::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : DissolvedMetalSum::Fields(parameters, "mol", "Metal that has dissolved.") {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    DissolvedMetalSum::declareParameters(declarations, "Dissolved_Amount");
  }
  DissolvedAmount(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : DissolvedMetalSum(completeParameters<DissolvedAmount>(params, "Dissolved_Amount"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    setGlobal(blocks, fields_.result, amounts(blocks).dissolved);
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::DissolvedAmount;
PD_REGISTER_COMPUTE(DissolvedAmount, "Dissolved_Amount", "Metal that has dissolved, mol.")
