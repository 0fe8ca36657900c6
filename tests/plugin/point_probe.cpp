#include "point_probe.hpp"

#include <algorithm>
#include <numeric>

namespace pdtest {

using namespace PeridigmNS;
using PeridigmField::STEP_NONE;
using PeridigmField::STEP_NP1;

std::vector<int> neighborsOf(SmallBody& body, int localId) {
  const int* list = body.block().getNeighborhoodData()->NeighborhoodList();
  for (int i = 0; i < localId; ++i) list += 1 + *list;
  return std::vector<int>(list + 1, list + 1 + *list);
}

PointProbe::PointProbe(const MaterialRun& run, int nNeighbors)
    : fieldIds_(run.fieldIds()), ownedIds_{0}, list_(static_cast<std::size_t>(nNeighbors) + 1) {
  std::iota(list_.begin(), list_.end(), 0);
  list_[0] = nNeighbors;
  std::vector<int> ids(list_.size());
  std::iota(ids.begin(), ids.end(), 0);
  data_.setMaps(Teuchos::rcp(new PointMap({0})), Teuchos::rcp(new PointMap(ids)), nNeighbors);
  data_.allocateData(fieldIds_);
}

void PointProbe::load(MaterialRun& run, int localId) {
  SmallBody& body = run.body();
  std::vector<int> locals = neighborsOf(body, localId);
  locals.insert(locals.begin(), localId);
  std::vector<int> globals;
  for (const int id : locals) globals.push_back(body.globalId(id));
  data_.setMaps(Teuchos::rcp(new PointMap({globals[0]})), Teuchos::rcp(new PointMap(globals)), list_[0]);
  for (const int id : fieldIds_) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    if (spec.relation == PeridigmField::GLOBAL || spec.relation == PeridigmField::BOND) continue;
    const auto width = static_cast<std::size_t>(PeridigmField::variableDimension(spec.length));
    double* values = nullptr;
    data_.getData(id, data_.hasData(id, STEP_NONE) ? STEP_NONE : STEP_NP1)->ExtractView(&values);
    for (std::size_t k = 0; k < locals.size(); ++k)
      std::copy_n(body.field(spec.label) + width * static_cast<std::size_t>(locals[k]), width, values + width * k);
  }
}

Results PointProbe::evaluate(const Material& material) {
  material.precompute(0.1, 1, ownedIds_.data(), list_.data(), data_);
  material.computeForce(0.1, 1, ownedIds_.data(), list_.data(), data_);
  material.computeFluxDivergence(0.1, 1, ownedIds_.data(), list_.data(), data_);
  Results results;
  for (const int id : fieldIds_) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    if (spec.temporal != PeridigmField::TWO_STEP || spec.relation == PeridigmField::BOND) continue;
    double* values = nullptr;
    const auto data = data_.getData(id, STEP_NP1);
    data->ExtractView(&values);
    // Of element fields, those of neighbours are what load() brought; forces at neighbours are sums of this call.
    const bool isOfOwner = spec.relation == PeridigmField::ELEMENT;
    results[spec.label].assign(values, values + (isOfOwner ? 1 : data->MyLength()));
  }
  return results;
}

}  // namespace pdtest
