#include "step_record.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "Peridigm_Field.hpp"

namespace pd {

using namespace PeridigmNS;

std::vector<StepRecord::GrowingField> StepRecord::growingFields(Block& block) {
  std::vector<GrowingField> found;
  const auto neighborhood = block.getNeighborhoodData();
  const auto data = block.getDataManager();
  for (const int id : data->getFieldIds()) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    if (spec.relation != PeridigmField::BOND || spec.temporal != PeridigmField::TWO_STEP) continue;
    const auto now = data->getData(id, PeridigmField::STEP_NP1);
    if (now != data->getData(id, PeridigmField::STEP_N)) continue;
    GrowingField field;
    now->ExtractView(&field.values);
    field.isBondDamage = spec.label == "Bond_Damage";
    const int n = neighborhood->NumOwnedPoints();
    field.points.assign(neighborhood->OwnedIDs(), neighborhood->OwnedIDs() + n);
    field.isFull.assign(static_cast<std::size_t>(n), 0);
    field.firstBond.push_back(0);
    const int* entry = neighborhood->NeighborhoodList();
    for (int p = 0; p < n; ++p, entry += *entry + 1)
      field.firstBond.push_back(field.firstBond.back() + static_cast<std::size_t>(*entry));
    found.push_back(std::move(field));
  }
  return found;
}

void StepRecord::copyBonds(GrowingField& field, const double* damage) {
  field.whole.clear();
  field.damaged.clear();
  field.copies.clear();
  for (std::size_t p = 0; p < field.points.size(); ++p) {
    if (field.isFull[p] != 0) continue;
    const double *first = field.values + field.firstBond[p], *last = field.values + field.firstBond[p + 1];
    const bool isWhole = field.isBondDamage && damage != nullptr
                             ? damage[field.points[p]] == 0.0
                             : std::all_of(first, last, [](double value) { return value == 0.0; });
    if (isWhole) {
      field.whole.push_back(p);
    } else if (std::all_of(first, last, [](double value) { return value >= 1.0; })) {
      field.isFull[p] = 1;
    } else {
      field.damaged.push_back(p);
      field.copies.insert(field.copies.end(), first, last);
    }
  }
}

void StepRecord::begin(const std::vector<PointField>& fields, Teuchos::RCP<std::vector<Block>> blocks, int nOwned,
                       const double* damage) {
  if (blocks_ != blocks) {
    blocks_ = blocks;
    growing_.clear();
    for (Block& block : *blocks)
      for (GrowingField& field : growingFields(block)) growing_.push_back(std::move(field));
  }
  nOwned_ = nOwned;
  fields_ = fields;
  copies_.resize(fields.size());
  for (auto& copy : copies_) copy.clear();
  points_.clear();
  if (growing_.empty()) return;
  touchAll();
  for (GrowingField& field : growing_) copyBonds(field, damage);
}

void StepRecord::touch(const std::vector<int>& points) {
  const bool hasAll = !growing_.empty() && !points_.empty();
  if (hasAll) return;
  points_.insert(points_.end(), points.begin(), points.end());
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    const auto& [label, values, width] = fields_[f];
    for (const int i : points) copies_[f].insert(copies_[f].end(), values + width * i, values + width * (i + 1));
  }
}

void StepRecord::touchAll() {
  if (!growing_.empty() && !points_.empty()) return;  // begin() has
  points_.resize(static_cast<std::size_t>(nOwned_));
  std::iota(points_.begin(), points_.end(), 0);
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    const auto& [label, values, width] = fields_[f];
    copies_[f].assign(values, values + static_cast<std::ptrdiff_t>(width) * nOwned_);
  }
}

void StepRecord::takeBack() {
  for (std::size_t f = 0; f < fields_.size(); ++f) {
    const auto& [label, values, width] = fields_[f];
    const double* from = copies_[f].data();
    for (const int i : points_)
      for (int k = 0; k < width; ++k) values[width * i + k] = *from++;
  }
  for (const GrowingField& field : growing_) {
    for (const std::size_t p : field.whole)
      std::fill(field.values + field.firstBond[p], field.values + field.firstBond[p + 1], 0.0);
    auto from = field.copies.begin();
    for (const std::size_t p : field.damaged) {
      const std::size_t count = field.firstBond[p + 1] - field.firstBond[p];
      std::copy_n(from, count, field.values + field.firstBond[p]);
      std::advance(from, count);
    }
  }
  for (Block& block : *blocks_) block.getDataManager()->restoreBondState();
}

}  // namespace pd
