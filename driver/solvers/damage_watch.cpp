#include "damage_watch.hpp"

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

double totalBondDamage(Model& model) {
  using namespace PeridigmNS;
  auto& fields = FieldManager::self();
  const int id = fields.hasField("Bond_Damage") ? fields.getFieldId("Bond_Damage") : -1;
  double sum = 0.0;
  for (Block& block : *model.blocks()) {
    if (id < 0 || !block.hasData(id, PeridigmField::STEP_NP1)) continue;
    double* damage = nullptr;
    block.getData(id, PeridigmField::STEP_NP1)->ExtractView(&damage);
    for (int bond = 0; bond < block.getNeighborhoodData()->NumBonds(); ++bond) sum += damage[bond];
  }
  return model.comm().sum(sum);
}

}  // namespace pd
