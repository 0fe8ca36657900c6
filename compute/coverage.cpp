// Coverage: hydrogen coverage of each point, its concentration as a share of saturation, held within 0 and 1.
#include <algorithm>

#include "field_variable.hpp"
#include "plugins.hpp"

namespace pd {

class Coverage : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldVariable concentration;
    FieldHandle coverage;
    explicit Fields(const Teuchos::ParameterList& parameters)
        : concentration(FieldVariable::of(parameters)),
          coverage(writes(outputField(parameters, pd::fields::pointScalar, "1", "Concentration over saturation."))) {
      include(concentration.fields());
    }
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Coverage");
    declarations.text("Variable", "Scalar point field of the concentration.").defaultTo("Concentration");
    declarations.real("Saturation Concentration", "that of the variable", "Concentration at which coverage is 1.")
        .positive()
        .required();
  }
  Coverage(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<Coverage>(params, "Coverage"), params, comm, globalData),
        saturation_(parameters_.get<double>("Saturation Concentration")),
        fields_(parameters_) {
    if (fields_.concentration.width() != 1)
      throw std::invalid_argument("Coverage: \"Variable\" must be a scalar field");
  }

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override { fields_.concentration.initialize(blocks); }

  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const auto neighborhood = block.getNeighborhoodData();
      const double* concentration = fields_.concentration.values(block);
      double* coverage = view(block, fields_.coverage);
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        coverage[id] = std::clamp(concentration[id] / saturation_, 0.0, 1.0);
      }
    }
    return 0;
  }

 private:
  double saturation_;
  Fields fields_;
};

}  // namespace pd

using pd::Coverage;
PD_REGISTER_COMPUTE(Coverage, "Coverage", "Concentration of each point as a share of saturation, within 0 and 1.")
