// What a material sees of broken bonds.
#ifndef PD_DAMAGE_VIEWS_HPP
#define PD_DAMAGE_VIEWS_HPP

#include "fields.hpp"

namespace pd {

/// What a material sees of the damage model of its block, at NP1.
struct DamageViews {
  const double* bondDamage = nullptr;  ///< null where the block has no damage model
  /// Damage where it tells which points' bonds have broken since the last call, else null. A host that keeps N and NP1
  /// apart may break other bonds in a repeated step, but as many.
  const double* damage = nullptr;
};

inline DamageViews damageViews(PeridigmNS::DataManager& dataManager, const FieldHandle& bondDamage,
                               const FieldHandle& damage) {
  DamageViews views;
  if (!bondDamage.isIn(dataManager) || !damage.isIn(dataManager)) return views;
  views.bondDamage = bondDamage.of(dataManager);
  if (views.bondDamage == bondDamage.before(dataManager)) views.damage = damage.of(dataManager);
  return views;
}

}  // namespace pd

#endif
