// Bond_Field_Mean: mean, minimum or maximum of a field of bonds over the bonds of each point; 0 at points without
// bonds, and in blocks whose plug-ins do not keep the field.
#include <algorithm>
#include <stdexcept>

#include "compute_support.hpp"
#include "plugins.hpp"

namespace pd {

class BondFieldMean : public TabledCompute {
 public:
  struct Fields : FieldTable {
    FieldHandle bonds, points;
    explicit Fields(const Teuchos::ParameterList& parameters);
  };
  static void declareParameters(ParameterDeclarations& declarations) {
    declareCommonParameters(declarations, "Bond_Field_Mean");
    declarations.text("Variable", "Field of bonds, broken bonds included: Bond_Damage, or a history of a damage model.")
        .required();
    declarations.text("Calculation Type", "What to take over the bonds of a point, all alike.")
        .oneOf({"Mean", "Minimum", "Maximum"})
        .defaultTo("Mean");
  }
  BondFieldMean(ComputeParameters params, ComputeComm comm, ComputeParameters globalData)
      : TabledCompute(completeParameters<BondFieldMean>(params, "Bond_Field_Mean"), params, comm, globalData),
        fields_(parameters_),
        type_(parameters_.get<std::string>("Calculation Type")) {}

  const Fields& fields() const override { return fields_; }
  void initialize(Blocks blocks) override;
  int compute(Blocks blocks) const override;

 private:
  /// Of the values of a point's bonds, one at least.
  double reduced(const double* values, int count) const;

  Fields fields_;
  std::string type_;
};

BondFieldMean::Fields::Fields(const Teuchos::ParameterList& parameters) {
  FieldDescription variable = pd::fields::namedBy("Variable", pd::fields::unitOfDeck, "The field of bonds.");
  if (parameters.isParameter("Variable")) {
    const auto label = parameters.get<std::string>("Variable");
    variable = pd::fields::describe(label);
    if (variable.relation != PeridigmNS::PeridigmField::BOND || variable.length != PeridigmNS::PeridigmField::SCALAR)
      throw std::invalid_argument("\"Variable\" must be a field of bonds, which \"" + label + "\" is not");
  }
  bonds = readsIfThere(variable);
  points = writes(
      outputField(parameters, pd::fields::elementScalar, variable.unit, "Mean or extreme of the point's bonds."));
}

void BondFieldMean::initialize(Blocks blocks) {
  const bool isThere = std::any_of(blocks->begin(), blocks->end(), [&](PeridigmNS::Block& block) {
    return fields_.bonds.isIn(*block.getDataManager());
  });
  if (!isThere)
    throw std::invalid_argument("\"Variable\": no plug-in of this run uses the field \"" +
                                parameters_.get<std::string>("Variable") + "\"");
}

double BondFieldMean::reduced(const double* values, int count) const {
  if (type_ == "Minimum") return *std::min_element(values, values + count);
  if (type_ == "Maximum") return *std::max_element(values, values + count);
  double sum = 0.0;
  for (int k = 0; k < count; ++k) sum += values[k];
  return sum / count;
}

int BondFieldMean::compute(Blocks blocks) const {
  for (PeridigmNS::Block& block : *blocks) {
    const double* bonds = fields_.bonds.ifIn(*block.getDataManager());
    double* points = view(block, fields_.points);
    const auto neighborhood = block.getNeighborhoodData();
    const int* list = neighborhood->NeighborhoodList();
    for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
      const int n = *list;
      points[neighborhood->OwnedIDs()[i]] = bonds == nullptr || n == 0 ? 0.0 : reduced(bonds, n);
      if (bonds != nullptr) bonds += n;
      list += 1 + n;
    }
  }
  return 0;
}

}  // namespace pd

using pd::BondFieldMean;
PD_REGISTER_COMPUTE(BondFieldMean, "Bond_Field_Mean",
                    "Mean, minimum or maximum of a field of bonds over the bonds of each point.")
