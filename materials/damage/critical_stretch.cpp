#include "critical_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bond_family.hpp"
#include "damage_views.hpp"
#include "plugins.hpp"
#include "stretch_parameters.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

constexpr auto nowhere = std::numeric_limits<std::size_t>::max();

/// Do all points lie in one plane of constant z?
bool isPlane(const double* coordinates, int nPoints) {
  for (int i = 1; i < nPoints; ++i)
    if (coordinates[3 * static_cast<std::size_t>(i) + 2] != coordinates[2]) return false;
  return true;
}

}  // namespace

void CriticalStretch::declareCommonParameters(ParameterDeclarations& declare) {
  declareCriticalStretch(declare);
  declare
      .real("Critical Compressive Stretch", "1",
            "Bonds that become shorter than (1 - this) of their length break too; without it they never do.")
      .strictlyBetween(0.0, 1.0);
}

void CriticalStretch::declareParameters(ParameterDeclarations& declare) { declareCommonParameters(declare); }

CriticalStretch::CriticalStretch(const Teuchos::ParameterList& params)
    : CriticalStretch(completed<CriticalStretch>(params, "damage model Critical Stretch"), Fields()) {}

CriticalStretch::CriticalStretch(const Teuchos::ParameterList& params, const Fields& fields)
    : BondDamageModel(params), fields_(fields) {
  law_.stretch = criticalStretchFrom(params);
  if (params.isParameter("Critical Compressive Stretch"))
    law_.compressiveStretch = params.get<double>("Critical Compressive Stretch");
}

void CriticalStretch::initialize(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                 const int* neighborhoodList, DataManager& dataManager) const {
  caches_.clear();
  BondDamageModel::initialize(dt, numOwnedPoints, ownedIDs, neighborhoodList, dataManager);
}

void CriticalStretch::stepTakenBack() const {
  caches_.forEach([](Cache& cache) {
    cache.alive.forget();
    cache.slack.clear();
  });
}

struct CriticalStretch::Views {
  int nPoints;
  kernels::StretchFields stretch;
};

void CriticalStretch::findApproach(Cache& cache, const Views& views) const {
  cache.approach.assign(static_cast<std::size_t>(views.nPoints), 0.0);
  double* approach = cache.approach.data();
  for (int d = 0; d < views.stretch.dimension; ++d) {
    const double *now = views.stretch.current[d], *tested = cache.testedPositions[d];
    for (int i = 0; i < views.nPoints; ++i) approach[i] += (now[i] - tested[i]) * (now[i] - tested[i]);
  }
  for (int i = 0; i < views.nPoints; ++i) approach[i] = std::sqrt(approach[i]);
  if (views.stretch.coverage == nullptr) return;
  // A bond goes by the mean coverage of its ends.
  const double perCoverage = 0.5 * law_.steepest() * cache.longestBond;
  const double *now = cache.coverage[0], *tested = cache.testedCoverage[0];
  for (int i = 0; i < views.nPoints; ++i) approach[i] += perCoverage * std::abs(now[i] - tested[i]);
}

/// A few points, at a tip or on a new face, come far nearer than all others: `near` becomes 1 for chunks that bonds of
/// theirs lead to. Returns what the others come nearer by at most.
double CriticalStretch::setApart(const Call& call, const Cache& cache, std::vector<char>& near) const {
  constexpr std::size_t mostApart = 50;  // one in so many points
  near.assign(cache.slack.size(), 0);
  double largest = 0.0, elsewhere = 0.0;  // of points whose bonds are not in this list
  for (std::size_t i = 0; i < cache.approach.size(); ++i) {
    largest = std::max(largest, cache.approach[i]);
    if (cache.chunkOf[i] == nowhere) elsewhere = std::max(elsewhere, cache.approach[i]);
  }
  for (const double share : {1.0 / 64.0, 1.0 / 16.0, 1.0 / 4.0}) {
    const double most = std::max(share * largest, elsewhere);
    const auto isApart = [&](double approach) { return approach > most; };
    const auto n = std::count_if(cache.approach.begin(), cache.approach.end(), isApart);
    if (static_cast<std::size_t>(n) > cache.approach.size() / mostApart) continue;
    for (std::size_t i = 0; i < cache.approach.size(); ++i) {
      if (!isApart(cache.approach[i])) continue;
      const int* list = call.neighborhoodList + cache.listStart[i];
      for (int k = 1; k <= *list; ++k)
        if (const std::size_t chunk = cache.chunkOf[static_cast<std::size_t>(list[k])]; chunk != nowhere)
          near[chunk] = 1;
    }
    return most;
  }
  return largest;
}

bool CriticalStretch::findChunksToTest(const Call& call, Cache& cache, const Views& views,
                                       std::vector<std::size_t>& chunks) const {
  if (cache.slack.empty() || !std::isfinite(law_.steepest())) return false;
  findApproach(cache, views);
  std::vector<char> near;
  const double others = setApart(call, cache, near);
  constexpr double worthwhileShare = 0.25;
  const auto most = static_cast<std::size_t>(worthwhileShare * static_cast<double>(cache.slack.size()));
  for (std::size_t c = 0; c < cache.slack.size(); ++c) {
    const kernels::Chunk& chunk = cache.neighborhood.chunks()[c];
    double own = 0.0;
    for (int lane = 0; lane < chunk.nLanes; ++lane)
      own = std::max(own, cache.approach[static_cast<std::size_t>(cache.neighborhood.pointIds(chunk)[lane])]);
    // The last term is round-off of coordinates.
    const double needed = (own + others) * (1.0 + 1e-9) + 1e-12 * cache.longestBond;
    if (near[c] == 0 && cache.slack[c] > needed) continue;
    chunks.push_back(c);
    if (chunks.size() > most) return false;
  }
  return true;
}

CriticalStretch::Cache& CriticalStretch::cacheOf(const Call& call, const double* x, int nPoints) const {
  return caches_.of(call, x, [&](const Call& c) {
    Cache made;
    made.neighborhood = kernels::ChunkedNeighborhood(c.nOwned, c.ownedIds, c.neighborhoodList);
    made.alive = kernels::AliveBonds(made.neighborhood);
    made.reference.separate(x, nPoints, 3);
    made.isPlane = isPlane(x, nPoints);
    const auto squareOf = [&](int i, int j, std::size_t, double* square) {
      const double length = ReferenceBond(x, i, j).length;
      made.longestBond = std::max(made.longestBond, length);
      *square = length * length;
    };
    made.reference2 = kernels::BondConstants(made.neighborhood, 1, squareOf, kernels::BondConstants::Keep::OnlyUniform);
    made.chunkOf.assign(static_cast<std::size_t>(nPoints), nowhere);
    for (std::size_t chunk = 0; chunk < made.neighborhood.chunks().size(); ++chunk)
      for (int lane = 0; lane < made.neighborhood.chunks()[chunk].nLanes; ++lane)
        made.chunkOf[static_cast<std::size_t>(made.neighborhood.pointIds(made.neighborhood.chunks()[chunk])[lane])] =
            chunk;
    made.listStart.assign(made.chunkOf.size(), 0);
    for (std::size_t p = 0, at = 0; p < static_cast<std::size_t>(c.nOwned); ++p) {
      made.listStart[static_cast<std::size_t>(c.ownedIds[p])] = at;
      at += static_cast<std::size_t>(c.neighborhoodList[at]) + 1;
    }
    return made;
  });
}

void CriticalStretch::worsen(double, const Call& call, DataManager& dataManager) const {
  const double* x = fields_.modelCoordinates.of(dataManager);
  const double* y = fields_.coordinates.of(dataManager);
  double* damage = fields_.damage.of(dataManager);
  double* bondDamage = fields_.bondDamage.of(dataManager);
  const double* noFailure = fields_.noFailure.ifIn(dataManager);
  const int nPoints = fields_.damage.length(dataManager);
  Cache& cache = cacheOf(call, x, nPoints);
  const kernels::ChunkedNeighborhood& neighborhood = cache.neighborhood;
  cache.alive.refresh(neighborhood, bondDamage, damageViews(dataManager, fields_.bondDamage, fields_.damage).damage);
  const int dimension = cache.isPlane && isPlane(y, nPoints) ? 2 : 3;
  cache.current.separate(y, nPoints, dimension);
  const bool hasCoverage = coverage(dataManager, cache.coverage);
  const Views views{
      nPoints, {dimension, cache.reference2, cache.reference, cache.current, hasCoverage ? &cache.coverage : nullptr}};

  std::vector<std::size_t> chunks;
  const bool testsSome = findChunksToTest(call, cache, views, chunks);
  struct Changed {
    const kernels::Chunk* chunk;
    unsigned lanes;  ///< bits
  };
  std::vector<Changed> changed;
  kernels::findOverstretchedBonds(
      neighborhood, cache.alive, views.stretch, law_,
      [&](const kernels::Chunk& chunk, int k, unsigned char over) {
        for (int lane = 0; lane < chunk.nLanes; ++lane) {
          if (((over >> lane) & 1u) == 0) continue;
          const int point = neighborhood.pointIds(chunk)[lane], neighbor = neighborhood.neighbor(chunk, k, lane);
          if (noFailure != nullptr && (noFailure[point] != 0.0 || noFailure[neighbor] != 0.0)) continue;
          bondDamage[neighborhood.bond(chunk, k, lane)] = 1.0;
          cache.alive.markBroken(chunk, k, lane);
          if (changed.empty() || changed.back().chunk != &chunk) changed.push_back({&chunk, 0u});
          changed.back().lanes |= 1u << lane;
        }
      },
      testsSome ? &chunks : nullptr, testsSome ? nullptr : &cache.slack);
  if (!testsSome) {
    std::swap(cache.testedPositions, cache.current);
    if (hasCoverage) std::swap(cache.testedCoverage, cache.coverage);
  }
  for (const auto& [chunk, lanes] : changed)
    for (int lane = 0; lane < kernels::lanes; ++lane) {
      if (((lanes >> lane) & 1u) == 0) continue;
      const double* bonds = bondDamage + neighborhood.firstBond(*chunk, lane);
      const double share = shareOfBroken(bonds, neighborhood.nNeighbors(*chunk, lane));
      damage[neighborhood.pointIds(*chunk)[lane]] = share;
      cache.alive.markSeen(*chunk, lane, share);
    }
}

PD_REGISTER_DAMAGE_MODEL(CriticalStretch, "Critical Stretch", "Bonds break at a critical stretch or fracture energy.")

}  // namespace pd
