#include "dissolving_bonds.hpp"

#include <algorithm>
#include <limits>

#include "bond_thresholds.hpp"

namespace pd {

using PeridigmNS::DataManager;

DissolvingBonds::Cache DissolvingBonds::makeCache(const Call& call, std::size_t nPoints) {
  Cache made;
  made.neighborhood = {call.neighborhoodList, call.nOwned};
  made.position.assign(nPoints, -1);
  made.around.resize(nPoints);
  std::size_t at = 0;
  for (int p = 0; p < call.nOwned; ++p) {
    made.position[static_cast<std::size_t>(call.ownedIds[p])] = p;
    made.starts.push_back(at + 1);
    at += static_cast<std::size_t>(call.neighborhoodList[at]) + 1;
  }
  for (int p = 0; p < call.nOwned; ++p) {
    const int* neighbors = call.neighborhoodList + made.starts[static_cast<std::size_t>(p)];
    for (int k = 0; k < neighbors[-1]; ++k)
      if (made.position[static_cast<std::size_t>(neighbors[k])] < 0)
        made.around[static_cast<std::size_t>(neighbors[k])].push_back(p);
  }
  constexpr double notYet = std::numeric_limits<double>::quiet_NaN();
  made.seenExpected.assign(nPoints, notYet);
  made.seenDamage.assign(static_cast<std::size_t>(call.nOwned), notYet);
  return made;
}

std::vector<int> DissolvingBonds::pointsToVisit(const Call& call, const std::vector<double>& expected,
                                                const double* damage, Cache& cache) {
  std::vector<char> isMarked(static_cast<std::size_t>(call.nOwned), 0);
  for (std::size_t j = 0; j < expected.size(); ++j) {
    if (expected[j] == cache.seenExpected[j]) continue;
    cache.seenExpected[j] = expected[j];
    for (const int p : cache.around[j]) isMarked[static_cast<std::size_t>(p)] = 1;
    if (cache.position[j] < 0) continue;
    // Neighbourhoods are symmetric.
    const auto own = static_cast<std::size_t>(cache.position[j]);
    const int* neighbors = call.neighborhoodList + cache.starts[own];
    isMarked[own] = 1;
    for (int k = 0; k < neighbors[-1]; ++k) {
      const int p = cache.position[static_cast<std::size_t>(neighbors[k])];
      if (p >= 0) isMarked[static_cast<std::size_t>(p)] = 1;
    }
  }
  std::vector<int> marked;
  for (int p = 0; p < call.nOwned; ++p) {
    const bool isOverwritten = damage[call.ownedIds[p]] != cache.seenDamage[static_cast<std::size_t>(p)];
    if (isOverwritten || isMarked[static_cast<std::size_t>(p)] != 0) marked.push_back(p);
  }
  return marked;
}

void DissolvingBonds::lookAtAllAgain() const {
  caches_.forEach(
      [](Cache& cache) { cache.seenDamage.assign(cache.seenDamage.size(), std::numeric_limits<double>::quiet_NaN()); });
}

bool DissolvingBonds::breaks(int id, double own, int neighborId, double other, int imageShift) const {
  if (!seed_ || own >= 1.0 || other >= 1.0) return own >= 1.0 || other >= 1.0;
  if (own <= 0.0 && other <= 0.0) return false;
  const kernels::BondThresholds thresholds = kernels::bondThresholds(*seed_, id, neighborId, imageShift);
  return own > thresholds.ofFirst || other > thresholds.ofSecond;
}

void DissolvingBonds::update(const Call& call, const std::vector<double>& expected, DataManager& dataManager) const {
  double* damage = fields_.damage.of(dataManager);
  double* loose = fields_.loose.isUsed() ? fields_.loose.of(dataManager) : nullptr;
  double* bondDamage = fields_.bondDamage.of(dataManager);
  const double* oldBondDamage = fields_.bondDamage.before(dataManager);
  const double* imageShift = fields_.imageShift.ifIn(dataManager);
  const auto& map = *dataManager.getOverlapScalarPointMap();
  Cache& cache = caches_.of(call, fields_.modelCoordinates.of(dataManager),
                            [&](const Call& c) { return makeCache(c, expected.size()); });
  // A host that keeps N and NP1 apart has put back the bonds of the last call.
  if (bondDamage != oldBondDamage)
    cache.seenDamage.assign(cache.seenDamage.size(), std::numeric_limits<double>::quiet_NaN());
  for (const int p : pointsToVisit(call, expected, damage, cache)) {
    const auto position = static_cast<std::size_t>(p);
    const int i = call.ownedIds[p], id = map.GID(i);
    const double own = expected[static_cast<std::size_t>(i)];
    const int* neighbors = call.neighborhoodList + cache.starts[position];
    double* bonds = bondDamage + (cache.starts[position] - position - 1);
    int nBroken = 0;
    for (int k = 0; k < neighbors[-1]; ++k) {
      const double other = expected[static_cast<std::size_t>(neighbors[k])];
      if (bonds[k] < 1.0) {
        const int shift = imageShift == nullptr ? 0 : static_cast<int>(imageShift[neighbors[k]]);
        if (breaks(id, own, map.GID(neighbors[k]), other, shift)) bonds[k] = 1.0;
      }
      nBroken += bonds[k] >= 1.0 ? 1 : 0;
    }
    const bool isLiquid = own >= 1.0, hasLostAll = nBroken == neighbors[-1];
    damage[i] = isLiquid ? 1.0 : std::min(static_cast<double>(nBroken) / std::max(neighbors[-1], 1), mostDamagedSolid);
    if (loose != nullptr) loose[i] = hasLostAll && !isLiquid ? 1.0 : 0.0;
    cache.seenDamage[position] = damage[i];
  }
}

}  // namespace pd
