#include "Peridigm_Field.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace PeridigmNS {

namespace {

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace

int PeridigmField::variableDimension(Length length) {
  if (length >= LENGTH_1 && length <= LENGTH_9) return length - LENGTH_1 + 1;
  switch (length) {
    case SCALAR:
      return 1;
    case VECTOR:
      return 3;
    case SYMMETRIC_TENSOR:
      return 6;
    case FULL_TENSOR:
      return 9;
    default:
      throw std::invalid_argument("a field of undefined length has no dimension");
  }
}

FieldManager& FieldManager::self() {
  static FieldManager manager;
  return manager;
}

int FieldManager::getFieldId(PeridigmField::Relation relation, PeridigmField::Length length,
                             PeridigmField::Temporal temporal, std::string label) {
  for (const FieldSpec& spec : specs) {
    if (spec.label == label) {
      if (spec.relation != relation || spec.length != length || spec.temporal != temporal)
        throw std::invalid_argument("field \"" + label + "\" is declared twice with different descriptions");
      return spec.id;
    }
    if (lowerCase(spec.label) == lowerCase(label))
      throw std::invalid_argument("field \"" + label + "\" differs from \"" + spec.label + "\" only by case");
  }
  const int id = static_cast<int>(specs.size());
  specs.emplace_back(relation, length, temporal, std::move(label), id);
  return id;
}

bool FieldManager::hasField(std::string label) {
  return std::any_of(specs.begin(), specs.end(), [&](const FieldSpec& spec) { return spec.label == label; });
}

int FieldManager::getFieldId(std::string label) {
  for (const FieldSpec& spec : specs)
    if (spec.label == label) return spec.id;
  std::string known;
  for (const FieldSpec& spec : specs) known += (known.empty() ? "" : ", ") + spec.label;
  throw std::invalid_argument("no field \"" + label + "\" in this run (fields: " + known + ")");
}

FieldSpec FieldManager::getFieldSpec(int fieldId) { return specs.at(static_cast<std::size_t>(fieldId)); }

FieldSpec FieldManager::getFieldSpec(std::string label) { return specs[static_cast<std::size_t>(getFieldId(label))]; }

std::vector<std::string> FieldManager::getFieldLabels() {
  std::vector<std::string> labels;
  for (const FieldSpec& spec : specs) labels.push_back(spec.label);
  return labels;
}

}  // namespace PeridigmNS
