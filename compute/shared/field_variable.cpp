#include "field_variable.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "Peridigm_Field.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;
using PeridigmNS::FieldManager;

namespace {

/// Fields that may be registered after a compute that is about them.
const FieldDescription* usualField(const std::string& label) {
  static const FieldDescription usual[] = {fields::modelCoordinates(),
                                           fields::coordinates(),
                                           fields::displacement(),
                                           fields::velocity(),
                                           fields::forceDensity(),
                                           fields::volume(),
                                           fields::damage(),
                                           fields::diffusingScalar("Concentration"),
                                           fields::diffusingScalar("Temperature"),
                                           fields::storedEnergyDensity(),
                                           fields::elementScalar("Number_Of_Neighbors", "1", "Bonds of the point.")};
  const auto found = std::find_if(std::begin(usual), std::end(usual),
                                  [&](const FieldDescription& field) { return field.label == label; });
  return found == std::end(usual) ? nullptr : found;
}

FieldDescription descriptionOf(const std::string& label) {
  const FieldDescription* usual = usualField(label);
  return usual != nullptr && !FieldManager::self().hasField(label) ? *usual : fields::describe(label);
}

}  // namespace

FieldVariable::Fields::Fields(const std::string& label) : description(descriptionOf(label)) {
  if (description.relation != PeridigmField::NODE && description.relation != PeridigmField::ELEMENT)
    throw std::invalid_argument("\"Variable\" must be a field of points, which \"" + label + "\" is not");
  if (description.length != PeridigmField::SCALAR && description.length != PeridigmField::VECTOR)
    throw std::invalid_argument("\"Variable\" must be a scalar or a vector field, which \"" + label + "\" is not");
  const bool isBrought = FieldManager::self().hasField(label) && !pd::fields::isOptionalEverywhere(label);
  values = isBrought ? reads(description) : readsIfThere(description);
}

FieldVariable FieldVariable::of(const Teuchos::ParameterList& parameters) {
  return parameters.isParameter("Variable") ? FieldVariable(parameters.get<std::string>("Variable")) : FieldVariable();
}

void FieldVariable::initialize(const Blocks& blocks) const {
  for (PeridigmNS::Block& block : *blocks)
    if (!fields_.values.isIn(*block.getDataManager()))
      throw std::invalid_argument("\"Variable\": no plug-in of this run uses the field \"" + label() + "\"");
}

void ScalarVariable::declareParameters(ParameterDeclarations& declarations) {
  declarations.text("Variable", "Point field, a scalar or a vector.").required();
  declarations.text("Component", "Of a vector field: a component, or its length.")
      .oneOf({"X", "Y", "Z", "Magnitude"})
      .defaultTo("Magnitude");
}

ScalarVariable::ScalarVariable(const Teuchos::ParameterList& parameters) : variable_(FieldVariable::of(parameters)) {
  const std::string component = parameters.get<std::string>("Component");
  component_ = component == "Magnitude" ? 3 : component[0] - 'X';
}

double ScalarVariable::at(const double* values, int localId) const {
  if (variable_.width() == 1) return values[localId];
  const double* v = values + 3 * localId;
  return component_ < 3 ? v[component_] : std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

}  // namespace pd
