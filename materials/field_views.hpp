// Plain pointers to the fields of a block.
#ifndef PD_FIELD_VIEWS_HPP
#define PD_FIELD_VIEWS_HPP

#include "Peridigm_DataManager.hpp"
#include "Peridigm_Field.hpp"
#include "fields.hpp"

namespace pd {

inline double* view(PeridigmNS::DataManager& dataManager, int id, PeridigmNS::PeridigmField::Step step) {
  double* values = nullptr;
  dataManager.getData(id, step)->ExtractView(&values);
  return values;
}

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
