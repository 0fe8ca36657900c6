#include "bond_damage_model.hpp"

#include <algorithm>

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
  countBrokenBonds({numOwnedPoints, ownedIDs, neighborhoodList}, fields().bondDamage.of(dataManager),
                   fields().damage.of(dataManager));
}

void BondDamageModel::carryOver(const Fields& fields, const Call& call, DataManager& dataManager) {
  double* bondDamage = fields.bondDamage.of(dataManager);
  const double* before = fields.bondDamage.before(dataManager);
  if (bondDamage == before) return;
  std::copy(before, before + fields.bondDamage.length(dataManager), bondDamage);
  countBrokenBonds(call, bondDamage, fields.damage.of(dataManager));
}

void BondDamageModel::computeDamage(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                    const int* neighborhoodList, DataManager& dataManager) const {
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  carryOver(fields(), call, dataManager);
  worsen(dt, call, dataManager);
}

}  // namespace pd
