#include "state_fields.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include "fields.hpp"

namespace pd {

namespace {

bool isRate(const std::string& label) {
  const FieldDescription* field = fields::find(label);
  return field != nullptr && !field->rateOf.empty();
}

/// Evaluates the rate, at prescribed points too; what materials write beside it stays as it was.
void makeRate(Model& model, const std::string& label) {
  std::map<std::string, std::vector<double>> before;
  for (PeridigmNS::Block& block : *model.blocks()) {
    const FieldTable fields = fieldsIn(*block.getMaterialModel());
    for (const FieldUse& use : fields.uses())
      if (use.access == FieldAccess::Writes && model.hasField(use.field.label)) before[use.field.label];
  }
  for (auto& [name, values] : before) {
    const std::size_t n = static_cast<std::size_t>(model.nPoints()) * static_cast<std::size_t>(model.fieldWidth(name));
    values.assign(model.field(name), model.field(name) + n);
  }
  model.evaluateFluxDivergence(0.0, label);
  for (const auto& [name, values] : before) std::copy(values.begin(), values.end(), model.field(name));
}

}  // namespace

bool isMadeOfState(const std::string& label) { return label == fields::storedEnergyDensity().label || isRate(label); }

void makeOfState(Model& model, const std::set<std::string>& labels) {
  for (const std::string& label : labels)
    if (isRate(label))
      makeRate(model, label);
    else
      model.evaluateStoredEnergy(0.0);
}

}  // namespace pd
