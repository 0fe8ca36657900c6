#include "rates.hpp"

#include <algorithm>
#include <set>

#include "Peridigm_Field.hpp"
#include "fields.hpp"

namespace pd {

using namespace PeridigmNS;

namespace {

std::vector<std::string> labelsOf(const std::set<int>& ids) {
  std::vector<std::string> labels;
  for (const int id : ids) labels.push_back(FieldManager::self().getFieldSpec(id).label);
  return labels;
}

}  // namespace

std::vector<std::string> summedFields(std::vector<Block>& blocks) {
  std::set<int> ids;
  for (Block& block : blocks)
    for (const int id : fieldsIn(*block.getMaterialModel()).sums()) ids.insert(id);
  return labelsOf(ids);
}

std::vector<std::string> fieldsWithRates(std::vector<Block>& blocks) {
  std::set<int> ids;
  for (Block& block : blocks) {
    const FieldTable table = fieldsIn(*block.getMaterialModel());
    for (const FieldUse& use : table.uses())
      if (use.access == FieldAccess::Adds && !use.field.rateOf.empty())
        ids.insert(FieldManager::self().getFieldId(use.field.rateOf));
  }
  return labelsOf(ids);
}

bool computesForces(Block& block) {
  const std::vector<int> ids = block.getMaterialModel()->FieldIds();
  return std::find(ids.begin(), ids.end(), FieldManager::self().getFieldId("Force_Density")) != ids.end();
}

bool derivesFields(Block& block) {
  const FieldTable fields = fieldsIn(*block.getMaterialModel());
  return std::any_of(fields.uses().begin(), fields.uses().end(), [](const FieldUse& use) {
    return use.access == FieldAccess::Writes && use.ghosts != Ghosts::AfterInitialize;
  });
}

}  // namespace pd
