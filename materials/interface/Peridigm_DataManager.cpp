#include "Peridigm_DataManager.hpp"

#include <algorithm>
#include <stdexcept>

namespace PeridigmNS {

PointMap::PointMap(std::vector<int> globalIds) : globalIds_(std::move(globalIds)) {
  byGlobalId_.reserve(globalIds_.size());
  for (std::size_t i = 0; i < globalIds_.size(); ++i) byGlobalId_.emplace_back(globalIds_[i], static_cast<int>(i));
  std::sort(byGlobalId_.begin(), byGlobalId_.end());
}

int PointMap::LID(int globalId) const {
  const auto it = std::lower_bound(byGlobalId_.begin(), byGlobalId_.end(), std::make_pair(globalId, 0));
  return it != byGlobalId_.end() && it->first == globalId ? it->second : -1;
}

void DataManager::setMaps(Teuchos::RCP<const PointMap> ownedPoints, Teuchos::RCP<const PointMap> overlapPoints,
                          int numBonds) {
  ownedPoints_ = ownedPoints;
  overlapPoints_ = overlapPoints;
  numBonds_ = numBonds;
}

DataManager::Slot DataManager::makeSlot(int fieldId) const {
  Slot slot;
  slot.spec = FieldManager::self().getFieldSpec(fieldId);
  const bool isBond = slot.spec.relation == PeridigmField::BOND;
  std::size_t count = 1;
  if (isBond)
    count = static_cast<std::size_t>(numBonds_);
  else if (slot.spec.relation != PeridigmField::GLOBAL)
    count = static_cast<std::size_t>(overlapPoints_->NumMyElements());
  const std::size_t length = count * static_cast<std::size_t>(PeridigmField::variableDimension(slot.spec.length));
  const auto vector = Teuchos::rcp(new FieldVector(length, 0.0));
  if (slot.spec.temporal == PeridigmField::CONSTANT) {
    slot.none = vector;
  } else {
    slot.np1 = vector;
    const bool isShared =
        !swapsBondSteps_ && std::find(sharedSteps_.begin(), sharedSteps_.end(), fieldId) != sharedSteps_.end();
    if (isBond) slot.n = isShared ? vector : Teuchos::rcp(new FieldVector(*vector));
  }
  return slot;
}

void DataManager::allocateData(const std::vector<int>& fieldIds) {
  for (const int id : fieldIds) {
    if (find(id) != nullptr) continue;
    const Slot slot = makeSlot(id);
    (slot.spec.relation == PeridigmField::BOND ? ownData_ : *pointData_)[id] = slot;
  }
}

void DataManager::allocatePrivateData(int fieldId) { ownData_[fieldId] = makeSlot(fieldId); }

void DataManager::sharePointData(const DataManager& other) { pointData_ = other.pointData_; }

const DataManager::Slot* DataManager::find(int fieldId) const {
  const auto own = ownData_.find(fieldId);
  if (own != ownData_.end()) return &own->second;
  const auto point = pointData_->find(fieldId);
  return point != pointData_->end() ? &point->second : nullptr;
}

bool DataManager::hasData(int fieldId, PeridigmField::Step step) {
  const Slot* slot = find(fieldId);
  if (slot == nullptr) return false;
  return step == PeridigmField::STEP_NONE ? !slot->none.is_null() : !slot->np1.is_null();
}

Teuchos::RCP<FieldVector> DataManager::getData(int fieldId, PeridigmField::Step step) {
  if (!hasData(fieldId, step))
    throw std::logic_error("field \"" + FieldManager::self().getFieldSpec(fieldId).label +
                           "\" is used but was not declared by FieldIds(), or is asked for at a step that it lacks");
  Slot* slot = const_cast<Slot*>(find(fieldId));
  switch (step) {
    case PeridigmField::STEP_NONE:
      return slot->none;
    case PeridigmField::STEP_N:
      if (slot->n.is_null()) slot->n = Teuchos::rcp(new FieldVector(*slot->np1));
      return slot->n;
    default:
      return slot->np1;
  }
}

std::vector<int> DataManager::getFieldIds() {
  std::vector<int> ids;
  for (const auto& entry : *pointData_) ids.push_back(entry.first);
  for (const auto& entry : ownData_)
    if (pointData_->count(entry.first) == 0) ids.push_back(entry.first);
  return ids;
}

void DataManager::updateState() {
  updatePointState();
  updateBondState();
}

void DataManager::updatePointState() {
  for (auto& entry : *pointData_)
    if (!entry.second.n.is_null()) *entry.second.n = *entry.second.np1;
}

void DataManager::updateBondState() {
  for (auto& entry : ownData_) {
    Slot& slot = entry.second;
    if (slot.spec.relation != PeridigmField::BOND || slot.n == slot.np1) continue;
    if (swapsBondSteps_)
      std::swap(slot.n, slot.np1);
    else
      *slot.n = *slot.np1;
  }
}

void DataManager::restoreBondState() {
  for (auto& entry : ownData_) {
    Slot& slot = entry.second;
    if (slot.spec.relation == PeridigmField::BOND && slot.n != slot.np1) *slot.np1 = *slot.n;
  }
}

void DataManager::restorePointState(int fieldId) {
  const Slot* slot = find(fieldId);
  if (slot != nullptr && !slot->n.is_null()) *slot->np1 = *slot->n;
}

std::size_t DataManager::bondBytes() const {
  std::size_t doubles = 0;
  for (const auto& entry : ownData_) {
    const Slot& slot = entry.second;
    if (slot.spec.relation != PeridigmField::BOND) continue;
    const auto length = static_cast<std::size_t>((slot.none.is_null() ? slot.np1 : slot.none)->MyLength());
    doubles += slot.none.is_null() && slot.n != slot.np1 ? 2 * length : length;
  }
  return doubles * sizeof(double);
}

}  // namespace PeridigmNS
