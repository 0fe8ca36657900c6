// Field_Integral: integral of a field over the volume of chosen points.
#include "field_reduction.hpp"
#include "plugins.hpp"

namespace pd {

class FieldIntegral : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    FieldReduction::declareParameters(declarations, "Field_Integral");
  }
  FieldIntegral(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Compute(params, comm, globalData),
        field_(completeParameters<FieldIntegral>(params, "Field_Integral"), globalData) {}

  std::vector<int> FieldIds() const override { return field_.fieldIds(); }
  void initialize(Blocks blocks) override { field_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    double integral = 0.0;
    field_.forEach(blocks, [&](double value, double volume) { integral += value * volume; });
    field_.store(blocks, sumOverRanks(*epetraComm, integral));
    return 0;
  }

 private:
  FieldReduction field_;
};

}  // namespace pd

using pd::FieldIntegral;
PD_REGISTER_COMPUTE(FieldIntegral, "Field_Integral",
                    "Integral of a field over the volume of a block, a node set or the body.")
