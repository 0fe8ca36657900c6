#include "field_variable.hpp"

#include <cmath>
#include <stdexcept>

#include "Peridigm_Field.hpp"

namespace pd {

namespace PeridigmField = PeridigmNS::PeridigmField;
using PeridigmNS::FieldManager;

namespace {

struct UsualField {
  const char* label;
  PeridigmField::Length length;
  PeridigmField::Temporal temporal;
};

constexpr UsualField usualFields[] = {
    {"Model_Coordinates", PeridigmField::VECTOR, PeridigmField::CONSTANT},
    {"Coordinates", PeridigmField::VECTOR, PeridigmField::TWO_STEP},
    {"Displacement", PeridigmField::VECTOR, PeridigmField::TWO_STEP},
    {"Velocity", PeridigmField::VECTOR, PeridigmField::TWO_STEP},
    {"Force_Density", PeridigmField::VECTOR, PeridigmField::TWO_STEP},
    {"Volume", PeridigmField::SCALAR, PeridigmField::CONSTANT},
    {"Damage", PeridigmField::SCALAR, PeridigmField::TWO_STEP},
    {"Concentration", PeridigmField::SCALAR, PeridigmField::TWO_STEP},
    {"Temperature", PeridigmField::SCALAR, PeridigmField::TWO_STEP},
    {"Stored_Elastic_Energy_Density", PeridigmField::SCALAR, PeridigmField::CONSTANT},
    {"Number_Of_Neighbors", PeridigmField::SCALAR, PeridigmField::CONSTANT},
};

}  // namespace

FieldVariable::FieldVariable(const std::string& label) : label_(label) {
  PeridigmField::Length length = PeridigmField::UNDEFINED_LENGTH;
  PeridigmField::Temporal temporal = PeridigmField::UNDEFINED_TEMPORAL;
  if (FieldManager::self().hasField(label)) {
    const PeridigmNS::FieldSpec spec = FieldManager::self().getFieldSpec(label);
    if (spec.getRelation() != PeridigmField::NODE && spec.getRelation() != PeridigmField::ELEMENT)
      throw std::invalid_argument("\"Variable\" must be a field of points, which \"" + label + "\" is not");
    length = spec.getLength();
    temporal = spec.getTemporal();
  } else {
    for (const UsualField& field : usualFields) {
      if (label != field.label) continue;
      length = field.length;
      temporal = field.temporal;
    }
    // Throws, and lists the fields that there are.
    if (length == PeridigmField::UNDEFINED_LENGTH) FieldManager::self().getFieldId(label);
  }
  if (length != PeridigmField::SCALAR && length != PeridigmField::VECTOR)
    throw std::invalid_argument("\"Variable\" must be a scalar or a vector field, which \"" + label + "\" is not");
  width_ = length == PeridigmField::VECTOR ? 3 : 1;
  step_ = temporal == PeridigmField::TWO_STEP ? PeridigmField::STEP_NP1 : PeridigmField::STEP_NONE;
}

PeridigmField::Length FieldVariable::length() const {
  return width_ == 3 ? PeridigmField::VECTOR : PeridigmField::SCALAR;
}

std::vector<int> FieldVariable::fieldIds() const {
  FieldManager& fields = FieldManager::self();
  if (!fields.hasField(label_)) return {};
  return {fields.getFieldId(label_)};
}

void FieldVariable::initialize(const Blocks& blocks) {
  id_ = FieldManager::self().getFieldId(label_);
  for (PeridigmNS::Block& block : *blocks)
    if (!block.hasData(id_, step_))
      throw std::invalid_argument("\"Variable\": no plug-in of this run uses the field \"" + label_ + "\"");
}

const double* FieldVariable::values(PeridigmNS::Block& block) const { return view(block, id_, step_); }

void ScalarVariable::declareParameters(ParameterDeclarations& declarations) {
  declarations.text("Variable", "Point field, a scalar or a vector.").required();
  declarations.text("Component", "Of a vector field: a component, or its length.")
      .oneOf({"X", "Y", "Z", "Magnitude"})
      .defaultTo("Magnitude");
}

ScalarVariable::ScalarVariable(const Teuchos::ParameterList& parameters)
    : variable_(parameters.get<std::string>("Variable")) {
  const std::string component = parameters.get<std::string>("Component");
  component_ = component == "Magnitude" ? 3 : component[0] - 'X';
}

double ScalarVariable::at(const double* values, int localId) const {
  if (variable_.width() == 1) return values[localId];
  const double* v = values + 3 * localId;
  return component_ < 3 ? v[component_] : std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

}  // namespace pd
