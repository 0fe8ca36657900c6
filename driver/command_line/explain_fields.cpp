#include "explain_fields.hpp"

#include <algorithm>

namespace pd {

namespace {

namespace Field = PeridigmNS::PeridigmField;

std::string useText(const FieldUse& use) {
  switch (use.access) {
    case FieldAccess::Reads:
      return use.isOptional ? "reads, where it is there," : "reads";
    case FieldAccess::Writes:
      return use.isOptional ? "writes, where it is asked for," : "writes";
    case FieldAccess::Adds:
      return "adds to";
    case FieldAccess::Worsens:
      return "raises";
  }
  return "";
}

std::string meaningText(const FieldDescription& field) {
  if (field.relation == Field::BOND) return "Of bonds: " + field.meaning;
  if (field.relation == Field::GLOBAL) return "Of the whole body: " + field.meaning;
  return field.meaning;
}

}  // namespace

std::vector<ExplainedField> explainedFields(const FieldTable& fields) {
  std::vector<FieldUse> uses = fields.uses();
  std::stable_partition(uses.begin(), uses.end(), [](const FieldUse& use) { return use.access == FieldAccess::Reads; });
  std::vector<ExplainedField> rows;
  for (const FieldUse& use : uses)
    rows.push_back(
        {use.field.label, useText(use), use.field.unit == "1" ? "" : use.field.unit, meaningText(use.field)});
  return rows;
}

std::vector<std::string> fieldLines(const FieldTable& fields) {
  std::vector<std::string> lines;
  for (const ExplainedField& field : explainedFields(fields))
    lines.push_back(field.use + " " + field.label + (field.unit.empty() ? "" : " (" + field.unit + ")") + ": " +
                    field.meaning);
  return lines;
}

}  // namespace pd
