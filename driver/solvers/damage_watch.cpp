#include "damage_watch.hpp"

#include <numeric>

#include "Peridigm_Field.hpp"
#include "fields.hpp"
#include "simd.hpp"

namespace pd {

void DamageMonitor::remember(Model& model) {
  const double* damage = model.field("Damage");
  damage_.assign(damage, damage + model.nOwned());
}

long long DamageMonitor::countChanged(Model& model) {
  const double* damage = model.field("Damage");
  long long nChanged = 0;
  for (std::size_t i = 0; i < damage_.size(); ++i) nChanged += damage[i] != damage_[i] ? 1 : 0;
  remember(model);
  return model.comm().sum(nChanged);
}

namespace {

double sumOf(const double* values, int n) {
  kernels::Vector sums = 0.0;
  int k = 0;
  for (; k + kernels::lanes <= n; k += kernels::lanes) sums += kernels::load(values + k);
  return std::accumulate(values + k, values + n, kernels::stdx::reduce(sums));
}

}  // namespace

double BondDamageSum::of(Model& model) {
  using namespace PeridigmNS;
  auto& known = FieldManager::self();
  const int id = known.hasField("Bond_Damage") ? known.getFieldId("Bond_Damage") : -1;
  const double* ofPoint = model.hasField("Damage") ? model.field("Damage") : nullptr;
  const auto& starts = model.discretization().neighborhoodStart;
  if (seen_.empty()) {
    seen_.assign(static_cast<std::size_t>(model.nOwned()), 0.0);
    sums_ = seen_;
  }
  double sum = 0.0;
  for (Block& block : *model.blocks()) {
    if (id < 0 || !block.hasData(id, PeridigmField::STEP_NP1)) continue;
    double* damage = nullptr;
    block.getData(id, PeridigmField::STEP_NP1)->ExtractView(&damage);
    const auto list = block.getNeighborhoodData();
    // A bond of which cracks and voids have left nothing breaks, and Damage does not tell.
    const bool tellsAll =
        ofPoint != nullptr && !block.hasData(fields::interactionShare().id(), PeridigmField::STEP_NONE);
    std::size_t bond = 0;
    for (int p = 0; p < list->NumOwnedPoints(); ++p) {
      const auto point = static_cast<std::size_t>(list->OwnedIDs()[p]);
      const auto count = static_cast<std::size_t>(starts[point + 1] - starts[point]) - 1;
      const double now = ofPoint == nullptr ? 0.0 : ofPoint[point];
      if (!tellsAll || now != seen_[point]) {
        sums_[point] = ofPoint == nullptr || now != 0.0 ? sumOf(damage + bond, static_cast<int>(count)) : 0.0;
        seen_[point] = now;
      }
      sum += sums_[point];
      bond += count;
    }
  }
  return model.comm().sum(sum);
}

}  // namespace pd
