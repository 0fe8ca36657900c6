#include "bond_damage_model.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

#include "simd.hpp"

namespace pd {

using PeridigmNS::DataManager;

double shareOfBroken(const double* bondDamage, int count) {
  kernels::Vector broken = 0.0;
  int k = 0;
  for (; k + kernels::lanes <= count; k += kernels::lanes) broken += kernels::load(bondDamage + k);
  double sum = kernels::stdx::reduce(broken);
  for (; k < count; ++k) sum += bondDamage[k];
  return count > 0 ? sum / count : 0.0;
}

void countBrokenBonds(const Call& call, const double* bondDamage, double* damage) {
  const int* entry = call.neighborhoodList;
  for (int p = 0; p < call.nOwned; ++p) {
    damage[call.ownedIds[p]] = shareOfBroken(bondDamage, *entry);
    bondDamage += *entry;
    entry += *entry + 1;
  }
}

void BondDamageModel::initialize(const double, const int numOwnedPoints, const int* ownedIDs,
                                 const int* neighborhoodList, DataManager& dataManager) const {
  const double* bondDamage = fields().bondDamage.ifIn(dataManager);
  if (bondDamage == nullptr) return;
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  double* damage = fields().damage.of(dataManager);
  const LiquidPoints liquid(call, damage);
  countBrokenBonds(call, bondDamage, damage);
  weighBonds(fields(), call, dataManager);
  if (marksLiquid()) liquid.restore(call, damage);
}

void BondDamageModel::carryOver(const Fields& fields, const Call& call, DataManager& dataManager) {
  double* bondDamage = fields.bondDamage.ifIn(dataManager);
  const double* before = bondDamage == nullptr ? nullptr : fields.bondDamage.before(dataManager);
  if (bondDamage == before) return;
  std::copy(before, before + fields.bondDamage.length(dataManager), bondDamage);
  countBrokenBonds(call, bondDamage, fields.damage.of(dataManager));
}

void BondDamageModel::computeDamage(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                    const int* neighborhoodList, DataManager& dataManager) const {
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  double* damage = fields().damage.of(dataManager);
  const bool hasLiquid = marksLiquid() && fields().bondDamage.isIn(dataManager);
  const std::optional<LiquidPoints> liquid = hasLiquid ? std::make_optional<LiquidPoints>(call, damage) : std::nullopt;
  carryOver(fields(), call, dataManager);
  if (liquid) liquid->restore(call, damage);
  worsen(dt, call, dataManager);
  weighBonds(fields(), call, dataManager);
}

void BondDamageModel::weighBonds(const Fields& fields, const Call& call, DataManager& dataManager) {
  const double* share = fields.interactionShare.ifIn(dataManager);
  const double* bondDamage = fields.bondDamage.ifIn(dataManager);
  if (share == nullptr || bondDamage == nullptr) return;
  const double* counted = fields.countedBonds.of(dataManager);
  double* damage = fields.damage.of(dataManager);
  const int* entry = call.neighborhoodList;
  for (int p = 0; p < call.nOwned; ++p) {
    double left = 0.0;
    for (int k = 0; k < *entry; ++k) left += share[k] * (1.0 - bondDamage[k]);
    const double all = counted[call.ownedIds[p]];
    damage[call.ownedIds[p]] = all > 0.0 ? std::clamp(1.0 - left / all, 0.0, 1.0) : 0.0;
    share += *entry;
    bondDamage += *entry;
    entry += *entry + 1;
  }
}

LiquidPoints::LiquidPoints(const Call& call, const double* damage) {
  std::copy_if(call.ownedIds, call.ownedIds + call.nOwned, std::back_inserter(points_),
               [damage](int i) { return damage[i] >= 1.0; });
}

void LiquidPoints::restore(const Call& call, double* damage) const {
  for (int p = 0; p < call.nOwned; ++p) {
    double& value = damage[call.ownedIds[p]];
    value = std::min(value, mostDamagedSolid);
  }
  for (const int i : points_) damage[i] = 1.0;
}

}  // namespace pd
