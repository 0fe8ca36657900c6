// Coverage: hydrogen coverage of each point, its concentration as a share of saturation, held within 0 and 1.
#include <algorithm>

#include "field_variable.hpp"
#include "plugins.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;

class Coverage : public PeridigmNS::Compute {
 public:
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Coverage");
    declarations.text("Variable", "Scalar point field of the concentration.").defaultTo("Concentration");
    declarations.real("Saturation Concentration", "that of the variable", "Concentration at which coverage is 1.")
        .positive()
        .required();
  }
  Coverage(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : Coverage(completeParameters<Coverage>(params, "Coverage"), params, comm, globalData) {}

  std::vector<int> FieldIds() const override {
    std::vector<int> ids = concentration_.fieldIds();
    ids.push_back(outputField_);
    return ids;
  }
  void initialize(Blocks blocks) override { concentration_.initialize(blocks); }

  int compute(Blocks blocks) const override {
    for (PeridigmNS::Block& block : *blocks) {
      const auto neighborhood = block.getNeighborhoodData();
      const double* concentration = concentration_.values(block);
      double* coverage = view(block, outputField_, PeridigmField::STEP_NONE);
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int id = neighborhood->OwnedIDs()[i];
        coverage[id] = std::clamp(concentration[id] / saturation_, 0.0, 1.0);
      }
    }
    return 0;
  }

 private:
  Coverage(const Teuchos::ParameterList& parameters, ComputeParameters params, ComputeComm comm,
           ComputeParameters globalData)
      : Compute(params, comm, globalData),
        concentration_(parameters.get<std::string>("Variable")),
        saturation_(parameters.get<double>("Saturation Concentration")),
        outputField_(PeridigmNS::FieldManager::self().getFieldId(PeridigmField::NODE, PeridigmField::SCALAR,
                                                                 PeridigmField::CONSTANT,
                                                                 parameters.get<std::string>("Output Label"))) {
    if (concentration_.width() != 1) throw std::invalid_argument("Coverage: \"Variable\" must be a scalar field");
  }

  FieldVariable concentration_;
  double saturation_;
  int outputField_;
};

}  // namespace pd

using pd::Coverage;
PD_REGISTER_COMPUTE(Coverage, "Coverage", "Concentration of each point as a share of saturation, within 0 and 1.")
