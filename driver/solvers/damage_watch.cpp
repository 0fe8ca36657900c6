#include "damage_watch.hpp"

#include "connected_parts.hpp"

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
  double sum = 0.0;
  forEachBond(model, [&](int, int, double damage) { sum += damage; });
  return model.comm().sum(sum);
}

}  // namespace pd
