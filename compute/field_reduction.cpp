#include "field_reduction.hpp"

namespace pd {

void FieldReduction::declareParameters(ParameterDeclarations& declarations, const char* defaultLabel) {
  declareCommonParameters(declarations, defaultLabel);
  ScalarVariable::declareParameters(declarations);
  PointSelection::declareParameters(declarations);
  declarations.real("Ignore Below", "that of the variable",
                    "Leave out points whose value is below this (default: all points count).");
}

FieldReduction::FieldReduction(const Teuchos::ParameterList& parameters, const ComputeParameters& globalData)
    : points_(parameters, globalData),
      variable_(parameters),
      hasFloor_(parameters.isParameter("Ignore Below")),
      floor_(hasFloor_ ? parameters.get<double>("Ignore Below") : 0.0),
      volumeField_(volumeField()),
      outputField_(globalField(parameters.get<std::string>("Output Label"), PeridigmNS::PeridigmField::SCALAR)) {}

std::vector<int> FieldReduction::fieldIds() const {
  std::vector<int> ids = variable_.fieldIds();
  ids.insert(ids.end(), {volumeField_, outputField_});
  return ids;
}

void FieldReduction::initialize(const Blocks& blocks) {
  points_.initialize(blocks);
  variable_.initialize(blocks);
}

}  // namespace pd
