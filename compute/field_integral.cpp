// Field_Integral: integral of a field over the volume of chosen points.
#include "field_reduction.hpp"
#include "plugins.hpp"

namespace pd {

class FieldIntegral : public FieldReduction {
 public:
  struct Fields : FieldReduction::Fields {
    explicit Fields(const Teuchos::ParameterList& parameters)
        : FieldReduction::Fields(parameters, "Integral of the variable over volume.", true) {}
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    FieldReduction::declareParameters(declarations, "Field_Integral");
  }
  FieldIntegral(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : FieldReduction(completeParameters<FieldIntegral>(params, "Field_Integral"), params, comm, globalData),
        fields_(parameters_) {}

  const Fields& fields() const override { return fields_; }

  int compute(Blocks blocks) const override {
    double integral = 0.0;
    forEach(blocks, [&](double value, double volume) { integral += value * volume; });
    store(blocks, sumOverRanks(*epetraComm, integral));
    return 0;
  }

 private:
  Fields fields_;
};

}  // namespace pd

using pd::FieldIntegral;
PD_REGISTER_COMPUTE(FieldIntegral, "Field_Integral",
                    "Integral of a field over the volume of a block, a node set or the body.")
