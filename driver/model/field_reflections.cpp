#include "field_reflections.hpp"

#include "field_names.hpp"

namespace pd {

void FieldReflections::include(const FieldUse& use) { declared_.emplace(use.id, use.field.reflection); }

std::optional<Reflection> FieldReflections::of(const PeridigmNS::FieldSpec& field) const {
  // Every image has its own.
  if (field.label == "Element_Id" || field.label == imageShiftField) return std::nullopt;
  for (const FieldDescription& own : {fields::coordinates(), fields::modelCoordinates()})
    if (field.label == own.label) return own.reflection;
  const auto found = declared_.find(field.id);
  const bool isVector = field.length == PeridigmNS::PeridigmField::VECTOR;
  if (!isVector && field.length != PeridigmNS::PeridigmField::SCALAR) return std::nullopt;
  if (found != declared_.end()) return found->second;
  return isVector ? Reflection::Vector : Reflection::Even;
}

}  // namespace pd
