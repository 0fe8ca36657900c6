// The steps of a Model: what is remembered, taken back and accepted.
#include <algorithm>
#include <set>

#include "for_each_plugin.hpp"
#include "model.hpp"
#include "partial_writer.hpp"
#include "step_listener.hpp"

namespace pd {

using namespace PeridigmNS;

namespace {

template <class Plugin>
void tellAccepted(const Plugin& plugin, Block& block, double time, double dt) {
  const auto points = block.getNeighborhoodData();
  if (points->NumOwnedPoints() == 0) return;
  tellStepAccepted(plugin, {points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList()},
                   *block.getDataManager(), time, dt);
}

/// DataManager::updateBondState(), but for bonds that have not been written.
void acceptBonds(const PartialWriter& writer, DataManager& data) {
  const auto written = writer.bondsWritten(data);
  for (const int id : data.getFieldIds()) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    if (spec.relation != PeridigmField::BOND || spec.temporal != PeridigmField::TWO_STEP) continue;
    const auto before = data.getData(id, PeridigmField::STEP_N), now = data.getData(id, PeridigmField::STEP_NP1);
    const auto parts = written.find(id);
    if (before == now) continue;
    if (parts == written.end()) {
      *before = *now;
      continue;
    }
    double *to = nullptr, *from = nullptr;
    before->ExtractView(&to);
    now->ExtractView(&from);
    for (const BondRange& bonds : parts->second) std::copy(from + bonds.first, from + bonds.last, to + bonds.first);
  }
}

void tellTakenBack(Block& block) {
  forEachPlugin(block, [](const auto& plugin) { tellStepTakenBack(plugin); });
}

}  // namespace

/// Stepped point fields but for sums that are made anew, and one-step fields that some plug-in calls state.
std::vector<StepRecord::PointField> Model::recordedFields() {
  std::set<int> state, results;
  for (Block& block : *blocks_)
    forEachFieldUse(block, [&](const FieldUse& use) {
      if (use.field.isState) state.insert(use.id);
      if (use.access == FieldAccess::Adds || !use.field.rateOf.empty()) results.insert(use.id);
    });
  std::vector<StepRecord::PointField> fields;
  for (const int id : shared_->getFieldIds()) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    const bool isStepped = spec.temporal == PeridigmField::TWO_STEP && results.count(id) == 0;
    if (isOfPoints(spec.relation) && (isStepped || state.count(id) > 0))
      fields.push_back({spec.label, field(spec.label), fieldWidth(spec.label)});
  }
  return fields;
}

void Model::beginStep(const std::vector<int>& points) {
  record_.begin(recordedFields(), blocks_, nOwned(), hasField("Damage") ? field("Damage") : nullptr);
  record_.touch(points);
}

void Model::beginStep() {
  beginStep({});
  record_.touchAll();
}

void Model::takeBackStep() {
  record_.takeBack();
  for (const StepRecord::PointField& field : record_.fields()) importGhosts(field.label);
  for (Block& block : *blocks_) tellTakenBack(block);
}

void Model::acceptStep(double time, double dt) {
  shared_->updatePointState();
  for (Block& block : *blocks_) {
    const auto* writer = dynamic_cast<const PartialWriter*>(block.getDamageModel().get());
    writer == nullptr ? block.getDataManager()->updateBondState() : acceptBonds(*writer, *block.getDataManager());
  }
  for (Block& block : *blocks_) {
    if (hasCalledMaterials_) tellAccepted(*block.getMaterialModel(), block, time, dt);
    if (hasCalledDamage_ && !block.getDamageModel().is_null()) tellAccepted(*block.getDamageModel(), block, time, dt);
  }
  hasCalledMaterials_ = hasCalledDamage_ = false;
}

void Model::adoptState() {
  shared_->updatePointState();
  for (Block& block : *blocks_) {
    block.getDataManager()->updateBondState();
    tellTakenBack(block);
  }
  record_.forget();
  hasCalledMaterials_ = hasCalledDamage_ = false;
}

/// An evaluation before the first step is no step: of what plug-ins alone write, NP1 becomes N.
void Model::restoreHistories() {
  for (Block& block : *blocks_) {
    block.getDataManager()->restoreBondState();
    forEachFieldUse(block, [&](const FieldUse& use) {
      if (use.access == FieldAccess::Writes) shared_->restorePointState(use.id);
    });
  }
  hasCalledMaterials_ = hasCalledDamage_ = false;
}

}  // namespace pd
