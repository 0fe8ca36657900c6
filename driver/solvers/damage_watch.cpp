#include "damage_watch.hpp"

#include <array>
#include <numeric>

#include "Peridigm_Field.hpp"

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

/// In several sums at once, which wait for each other no more.
double sumOf(const double* values, int n) {
  std::array<double, 8> sums{};
  int k = 0;
  for (; k + 8 <= n; k += 8)
    for (std::size_t lane = 0; lane < 8; ++lane) sums[lane] += values[k + static_cast<int>(lane)];
  return std::accumulate(values + k, values + n, std::accumulate(sums.begin(), sums.end(), 0.0));
}

}  // namespace

double totalBondDamage(Model& model) {
  using namespace PeridigmNS;
  auto& fields = FieldManager::self();
  const int id = fields.hasField("Bond_Damage") ? fields.getFieldId("Bond_Damage") : -1;
  // Most points have lost nothing: their bonds need not be read.
  const double* ofPoint = model.hasField("Damage") ? model.field("Damage") : nullptr;
  double sum = 0.0;
  for (Block& block : *model.blocks()) {
    if (id < 0 || !block.hasData(id, PeridigmField::STEP_NP1)) continue;
    double* damage = nullptr;
    block.getData(id, PeridigmField::STEP_NP1)->ExtractView(&damage);
    const auto list = block.getNeighborhoodData();
    const int* count = list->NeighborhoodList();
    for (int p = 0; p < list->NumOwnedPoints(); ++p, damage += *count, count += *count + 1)
      if (ofPoint == nullptr || ofPoint[list->OwnedIDs()[p]] != 0.0) sum += sumOf(damage, *count);
  }
  return model.comm().sum(sum);
}

}  // namespace pd
