#include "damage_watch.hpp"

#include <numeric>

#include "Peridigm_Field.hpp"
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

double totalBondDamage(Model& model) {
  using namespace PeridigmNS;
  auto& fields = FieldManager::self();
  const int id = fields.hasField("Bond_Damage") ? fields.getFieldId("Bond_Damage") : -1;
  // Most points have lost nothing: their bonds need not be read.
  const double* ofPoint = model.hasField("Damage") ? model.field("Damage") : nullptr;
  const auto& starts = model.discretization().neighborhoodStart;
  double sum = 0.0;
  for (Block& block : *model.blocks()) {
    if (id < 0 || !block.hasData(id, PeridigmField::STEP_NP1)) continue;
    double* damage = nullptr;
    block.getData(id, PeridigmField::STEP_NP1)->ExtractView(&damage);
    const auto list = block.getNeighborhoodData();
    for (int p = 0; p < list->NumOwnedPoints(); ++p) {
      const auto point = static_cast<std::size_t>(list->OwnedIDs()[p]);
      const auto count = static_cast<int>(starts[point + 1] - starts[point]) - 1;
      if (ofPoint == nullptr || ofPoint[point] != 0.0) sum += sumOf(damage, count);
      damage += count;
    }
  }
  return model.comm().sum(sum);
}

}  // namespace pd
