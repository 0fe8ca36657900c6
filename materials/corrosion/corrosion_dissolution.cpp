#include "corrosion_dissolution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "diffusion_kernel.hpp"
#include "plugins.hpp"
#include "unknowns.hpp"

namespace pd {

using PeridigmNS::DataManager;
using PeridigmNS::FieldManager;
namespace Field = PeridigmNS::PeridigmField;

namespace {

constexpr double faraday = 96485.33212;  ///< C/mol, CODATA 2018 (exact since 2019 to these digits)
constexpr int checkStride = 8;           ///< a mesh that is no grid is none nearly everywhere
constexpr double leastMetal = 0.1;       ///< of the solid's: less is no initial state of metal
constexpr const char* corrosionDissolution = "material Corrosion Dissolution";

bool has(DataManager& dataManager, const char* label, Field::Step step) {
  FieldManager& fields = FieldManager::self();
  return fields.hasField(label) && dataManager.hasData(fields.getFieldId(label), step);
}

/// Points above saturation are metal at the start. Throws std::invalid_argument where one at x [3] can hardly be meant
/// so.
void requireMetal(double concentration, double saturation, double solid, const double* x) {
  if (concentration >= leastMetal * solid) return;
  std::ostringstream text;
  text << corrosionDissolution << ": the point at (" << x[0] << ", " << x[1] << ", " << x[2] << ") m begins with "
       << concentration << " mol/m3, above the Saturation Concentration " << saturation
       << ", by which it is metal, but with less than a tenth of its Solid Concentration " << solid
       << "; give metal that at the start, and electrolyte no more than saturation";
  throw std::invalid_argument(text.str());
}

}  // namespace

void CorrosionDissolution::declareParameters(ParameterDeclarations& declare) {
  declare.text("Material Model", "Name of this model.").defaultTo("Corrosion Dissolution");
  declare.real("Saturation Concentration", "mol/m3", "Most metal ions that the electrolyte holds.")
      .positive()
      .required();
  declare.real("Charge Number", "1", "Mean charge of the ions, z.").positive().required();
  declare
      .text("Concentration Field",
            "Label of the metal ions' concentration. Another one than hydrogen's, where both live on the same points.")
      .defaultTo("Concentration");
  SolidPhases::declareParameters(declare);
  TransportWeights::declareParameters(declare);
  BondFamily::declareAxis(declare);
}

CorrosionDissolution::CorrosionDissolution(const Teuchos::ParameterList& given)
    : CorrosionDissolution(given, completed<CorrosionDissolution>(given, corrosionDissolution)) {}

CorrosionDissolution::CorrosionDissolution(const Teuchos::ParameterList& given, const Teuchos::ParameterList& params)
    : Material(given),
      weights_(params, corrosionDissolution),
      saturation_(params.get<double>("Saturation Concentration")),
      chargeNumber_(params.get<double>("Charge Number")),
      phases_(params, saturation_, corrosionDissolution),
      acidity_(params, saturation_, corrosionDissolution),
      fields_(params.get<std::string>("Concentration Field"), acidity_.isGiven(), phases_.count() > 1) {}

double CorrosionDissolution::Density() const {
  throw std::invalid_argument(std::string(corrosionDissolution) + " has no mechanics, which this solver needs");
}

std::vector<std::string> CorrosionDissolution::runNotes() const {
  if (weights_.trialOutcome().empty()) return {};
  return {Name() + ": " + weights_.trialOutcome()};
}

struct CorrosionDissolution::Views {
  int nPoints;
  const double *x, *volume, *planeVolume, *concentration, *damage, *salt, *demand, *film, *blockId = nullptr;
  double *diffusivity, *rate, *area, *current, *dissolutionRate, *slope, *solid, *saturation, *diffusionCorrection,
      *dissolutionCorrection, *ph = nullptr;

  Views(const CorrosionDissolution& material, DataManager& dataManager) {
    const Fields& fields = material.fields_;
    nPoints = fields.volume.length(dataManager);
    x = fields.modelCoordinates.of(dataManager);
    volume = fields.volume.of(dataManager);
    planeVolume = material.planeVolumes_.empty() ? volume : material.planeVolumes_.data();
    concentration = fields.concentration.of(dataManager);
    diffusivity = fields.diffusivity.of(dataManager);
    damage = fields.damage.of(dataManager);
    salt = fields.salt.of(dataManager);
    demand = fields.demand.of(dataManager);
    film = fields.film.ifIn(dataManager);
    rate = fields.rate.of(dataManager);
    area = fields.area.of(dataManager);
    current = fields.current.of(dataManager);
    dissolutionRate = fields.dissolutionRate.of(dataManager);
    slope = fields.slope.of(dataManager);
    solid = fields.solid.of(dataManager);
    saturation = fields.saturation.of(dataManager);
    diffusionCorrection = fields.diffusionCorrection.of(dataManager);
    dissolutionCorrection = fields.dissolutionCorrection.of(dataManager);
    ph = fields.ph.ifIn(dataManager);
    blockId = fields.blockId.ifIn(dataManager);
  }
  double filmAt(int j) const { return film == nullptr ? 0.0 : film[j]; }  ///< near a liquid point
  /// Share of the surface of a phase near a liquid point that no film covers.
  double open(int j, const SolidPhases::Phase& phase) const { return phase.open(filmAt(j)); }
};

/// Of rings; 1 without them.
double CorrosionDissolution::radius(const Views& views, int point) const {
  return weights_.rings().areUsed() ? weights_.rings().radius(views.x, point) : 1.0;
}

PhaseGeometry CorrosionDissolution::geometry(const Views& views, const double* damage) const {
  return {weights_, views.x, views.planeVolume, damage, &phases_, views.blockId, followsLoss_};
}

void CorrosionDissolution::initialize(const double, const int numOwnedPoints, const int* ownedIDs,
                                      const int* neighborhoodList, DataManager& dataManager) {
  if (weights_.rings().areUsed())
    planeVolumes_ = weights_.rings().planeVolumes(fields_.modelCoordinates.of(dataManager),
                                                  fields_.volume.of(dataManager), fields_.volume.length(dataManager));
  const Views views(*this, dataManager);
  caches_.clear();
  // Where bonds have a state, Damage counts broken ones. Of damage models the stochastic rule of Dissolution alone has
  // the field Loose.
  followsLoss_ = !has(dataManager, "Bond_Damage", Field::STEP_NP1);
  const bool breaksBondsAtRandom = !followsLoss_ && has(dataManager, "Loose", Field::STEP_NONE);
  if (numOwnedPoints > 0) {
    weights_.fitToGrid(views.planeVolume[ownedIDs[0]]);
    if (weights_.isCalibratedByTrial()) weights_.calibrateByTrial(breaksBondsAtRandom);
  }
  std::fill(views.diffusionCorrection, views.diffusionCorrection + views.nPoints, 1.0);
  std::fill(views.dissolutionCorrection, views.dissolutionCorrection + views.nPoints, 1.0);
  const int* list = neighborhoodList;
  for (int p = 0; p < numOwnedPoints; ++p, list += *list + 1) {
    const int i = ownedIDs[p];
    const std::size_t phase = views.blockId == nullptr ? 0 : phases_.ofBlock(views.blockId[i]);
    views.solid[i] = views.concentration[i] > saturation_ ? phases_[phase].solidConcentration : 0.0;
    if (views.solid[i] > 0.0) requireMetal(views.concentration[i], saturation_, views.solid[i], views.x + 3 * i);
    views.saturation[i] = saturation_;
    views.diffusivity[i] = weights_.diffusivity();
    if (views.ph != nullptr) views.ph[i] = std::numeric_limits<double>::quiet_NaN();
    if (p % checkStride == 0) weights_.checkGrid(views.x, views.planeVolume, i, list + 1, *list);
  }
}

/// Points of blocks without ions are walls, which the diffusion correction is for.
std::vector<double> CorrosionDissolution::relativeDiffusivities(const Call& call, const Views& views) const {
  std::vector<double> diffusivity(views.diffusivity, views.diffusivity + views.nPoints);
  std::replace(diffusivity.begin(), diffusivity.end(), 0.0, weights_.diffusivity());
  return seriesDiffusivities(call, diffusivity.data(),
                             [&](int i, int j) { return weights_.bond(views.x, i, j).mapped; });
}

CorrosionDissolution::Cache& CorrosionDissolution::cacheOf(const Call& call, const Views& views,
                                                           DataManager& dataManager) const {
  return caches_.of(call, views.x, [&](const Call& c) {
    const PhaseGeometry bonds = geometry(views, views.damage);
    Cache made;
    made.neighborhood = kernels::ChunkedNeighborhood(c.nOwned, c.ownedIds, c.neighborhoodList);
    const std::vector<double> relative = relativeDiffusivities(c, views);
    made.diffusion = kernels::BondConstants(made.neighborhood, 1, [&](int i, int j, std::size_t bond, double* value) {
      *value = (relative.empty() ? 1.0 : relative[bond]) * bonds.diffusionWeight(i, j) * views.planeVolume[j] *
               weights_.ringShare(views.x, i, j, views.planeVolume[i], views.planeVolume[j]);
    });
    made.dissolution = kernels::BondConstants(made.neighborhood, 1, [&](int i, int j, std::size_t, double* value) {
      *value = bonds.dissolutionWeight(i, j) * views.planeVolume[j] / radius(views, i);
    });
    made.phases = kernels::PhaseBonds(made.neighborhood, c.nOwned, c.ownedIds, c.neighborhoodList, views.nPoints);
    made.phases.excludeWalls(views.saturation);
    made.isListed.assign(static_cast<std::size_t>(views.nPoints), 0);
    std::vector<char> isOwn(static_cast<std::size_t>(views.nPoints), 0);
    for (int p = 0; p < c.nOwned; ++p) isOwn[static_cast<std::size_t>(c.ownedIds[p])] = 1;
    for (int i = 0; i < dataManager.getOwnedScalarPointMap()->NumMyElements(); ++i)
      if (isOwn[static_cast<std::size_t>(i)] == 0) made.ofOtherBlocks.push_back(i);
    made.concentration.zero(views.nPoints, 1);
    made.diffusionCorrection.zero(views.nPoints, 1);
    made.area.resize(phases_.count());
    made.lostFlux.resize(phases_.count());
    made.correction.resize(phases_.count());
    made.surface.resize(static_cast<std::size_t>(views.nPoints));
    for (kernels::PointArrays* values : {&made.current, &made.currentSum, &made.weightSum})
      values->zero(views.nPoints, 1);
    for (auto* arrays : {&made.area, &made.lostFlux, &made.correction})
      for (kernels::PointArrays& ofPhase : *arrays) ofPhase.zero(views.nPoints, 1);
    if (phases_.count() > 1) made.isOfPhase.resize(phases_.count());
    for (std::size_t p = 0; p < made.isOfPhase.size(); ++p) {
      made.isOfPhase[p].zero(views.nPoints, 1);
      for (int i = 0; i < views.nPoints; ++i)
        made.isOfPhase[p][0][i] = phases_.ofBlock(views.blockId[i]) == p ? 1.0 : 0.0;
    }
    return made;
  });
}

void CorrosionDissolution::precompute(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                      const int* neighborhoodList, DataManager& dataManager) const {
  const Views views(*this, dataManager);
  Cache& cache = cacheOf({numOwnedPoints, ownedIDs, neighborhoodList}, views, dataManager);
  takeUpPhases(dt, cache, views);
  findAcidity(cache, views);
  cache.isPrepared = true;
}

/// Corrections of owned points.
void CorrosionDissolution::takeUpPhases(double dt, Cache& cache, const Views& views) const {
  cache.hasAreas = false;  // corrections of neighbours of other ranks may change by what is out of sight here
  cache.zeroed = nullptr;  // a host may have filled in rates, those of a checkpoint for one
  const bool isChanged = cache.phases.refresh(cache.neighborhood, views.damage);
  if (isChanged) refreshAroundChanges(cache, views);
  if (weights_.isCalibratedByTrial()) return;
  findSurfaces(cache, views);
  if (views.film != nullptr && phases_.filmsDiffer()) takeUpFilms(cache, views);
  findDissolutionCorrections(dt, cache, views);
}

/// Owned points that have changed phase and their neighbours: diffusion corrections, no currents yet, a pH where
/// liquid.
void CorrosionDissolution::refreshAroundChanges(Cache& cache, const Views& views) const {
  const kernels::PhaseBonds& phases = cache.phases;
  const PhaseGeometry bonds = geometry(views, phases.steppedDamage());
  for (const std::size_t c : phases.changedChunks()) {
    const kernels::Chunk& chunk = cache.neighborhood.chunks()[c];
    for (int lane = 0; lane < chunk.nLanes; ++lane) {
      const int i = cache.neighborhood.pointIds(chunk)[lane];
      const int* list = phases.listOf(i);
      views.diffusionCorrection[i] = phases.isLiquid(i) ? bonds.diffusionCorrection(i, list + 1, *list) : 1.0;
      views.area[i] = views.current[i] = views.dissolutionRate[i] = views.slope[i] = 0.0;
      if (views.ph == nullptr || !phases.isLiquid(i) || cache.isListed[static_cast<std::size_t>(i)] != 0) continue;
      cache.isListed[static_cast<std::size_t>(i)] = 1;
      cache.liquid.push_back(i);
    }
  }
}

/// Of owned points of the surface, as metal around them goes.
void CorrosionDissolution::findSurfaces(Cache& cache, const Views& views) const {
  const std::vector<int>& changed = cache.phases.changedPoints();
  if (changed.empty()) return;
  const PhaseGeometry bonds = geometry(views, cache.phases.steppedDamage());
  std::vector<int> neighbors;
  for (const std::size_t c : cache.phases.solidChunksAround(changed)) {
    const kernels::Chunk& chunk = cache.neighborhood.chunks()[c];
    const int* points = cache.neighborhood.pointIds(chunk);
    const unsigned char* bits = cache.phases.fromSolid().of(chunk);
    const double* weights = cache.dissolution.of(c);
    const bool isUniform = cache.dissolution.isUniform(c);
    for (int lane = 0; lane < chunk.nLanes; ++lane) {
      // Bonds to electrolyte reach further than those that dissolve.
      const auto dissolves = [&](int k) {
        return ((bits[k] >> lane) & 1u) != 0 && weights[isUniform ? k : k * kernels::lanes + lane] != 0.0;
      };
      int k = 0;
      while (k < chunk.nNeighbors && !dissolves(k)) ++k;
      PhaseGeometry::Surface& surface = cache.surface[static_cast<std::size_t>(points[lane])];
      surface = {};  // of what a step that is taken back had at its surface
      if (k == chunk.nNeighbors) continue;
      cache.phases.findNeighborsWithoutWalls(points[lane], neighbors);
      surface = bonds.surface(points[lane], neighbors.data(), static_cast<int>(neighbors.size()));
    }
  }
}

/// Visits points of chunks that have bonds from metal to electrolyte.
template <class Visit>
void CorrosionDissolution::forSolid(const Cache& cache, Visit visit) {
  for (const std::size_t c : cache.phases.solidChunks()) {
    const kernels::Chunk& chunk = cache.neighborhood.chunks()[c];
    for (int lane = 0; lane < chunk.nLanes; ++lane) visit(cache.neighborhood.pointIds(chunk)[lane]);
  }
}

/// At each point of metal, over its bonds that dissolve; `values` null: of their weights.
void CorrosionDissolution::sumOverDissolvingBonds(const Cache& cache, const double* values, double* sum) {
  forSolid(cache, [&](int i) { sum[i] = 0.0; });
  kernels::addWeightedSum(cache.neighborhood, cache.dissolution, cache.phases.fromSolid(), cache.phases.solidChunks(),
                          nullptr, values, sum);
}

/// Where phases bear different shares of a film, it decides which of them a front leaves behind. A point has the mean
/// of its dissolving bonds.
void CorrosionDissolution::takeUpFilms(Cache& cache, const Views& views) const {
  const kernels::PhaseBonds& phases = cache.phases;
  const PhaseGeometry bonds = geometry(views, phases.steppedDamage());
  for (const int j : phases.sources()) cache.current[0][j] = views.film[j];
  sumOverDissolvingBonds(cache, nullptr, cache.weightSum[0]);
  sumOverDissolvingBonds(cache, cache.current[0], cache.currentSum[0]);
  forSolid(cache, [&](int i) {
    PhaseGeometry::Surface& surface = cache.surface[static_cast<std::size_t>(i)];
    if (!surface.phases.empty() && cache.weightSum[0][i] != 0.0)
      bonds.takeUpFilm(cache.currentSum[0][i] / cache.weightSum[0][i], i, surface);
  });
}

/// Of a step, by the surface in the middle of it: a front moves at i/(z F C_solid), i of bare metal and as much of it
/// as there is by now.
void CorrosionDissolution::findDissolutionCorrections(double dt, Cache& cache, const Views& views) const {
  const kernels::PhaseBonds& phases = cache.phases;
  bool isBent = false;
  forSolid(cache, [&](int i) {
    const PhaseGeometry::Surface& surface = cache.surface[static_cast<std::size_t>(i)];
    views.dissolutionCorrection[i] = surface.correctionAfter(0.0);
    isBent = isBent || surface.spread != 0.0;
  });
  if (!isBent || dt == 0.0) return;
  sumOverDissolvingBonds(cache, nullptr, cache.weightSum[0]);
  for (std::size_t p = 0; p < phases_.count(); ++p) {
    for (const int j : phases.sources())
      cache.current[0][j] = (1.0 - views.salt[j]) * views.open(j, phases_[p]) *
                            phases_[p].currentDensity.at(views.concentration[j]).current;
    sumOverDissolvingBonds(cache, cache.current[0], cache.currentSum[0]);
    const double perCurrent = 1.0 / (chargeNumber_ * faraday * phases_[p].solidConcentration);
    forSolid(cache, [&](int i) {
      if (cache.weightSum[0][i] == 0.0 || (!cache.isOfPhase.empty() && cache.isOfPhase[p][0][i] == 0.0)) return;
      const double speed = perCurrent * cache.currentSum[0][i] / cache.weightSum[0][i];
      views.dissolutionCorrection[i] = cache.surface[static_cast<std::size_t>(i)].correctionAfter(0.5 * dt * speed);
    });
  }
}

/// pH is a number where there is electrolyte.
void CorrosionDissolution::findAcidity(const Cache& cache, const Views& views) const {
  for (const int i : cache.liquid) views.ph[i] = acidity_.at(views.concentration[i]);
}

void CorrosionDissolution::findAreas(Cache& cache, const Views& views) const {
  const kernels::PhaseBonds& phases = cache.phases;
  for (std::size_t p = 0; p < phases_.count(); ++p) {
    for (const int i : phases.sinks())
      cache.correction[p][0][i] = views.dissolutionCorrection[i] * radius(views, i) *
                                  (cache.isOfPhase.empty() ? 1.0 : cache.isOfPhase[p][0][i]);
    for (const int j : phases.sources()) cache.area[p][0][j] = 0.0;
    kernels::addWeightedSum(cache.neighborhood, cache.dissolution, phases.fromLiquid(), phases.wetChunks(), nullptr,
                            cache.correction[p][0], cache.area[p][0]);
  }
  // Of the points of this call; others are seen to by theirs.
  for (const int j : phases.sources()) {
    double total = 0.0;
    for (const kernels::PointArrays& area : cache.area) total += area[0][j];
    if (total > 0.0) views.area[j] = total;
  }
  cache.hasAreas = true;
}

bool CorrosionDissolution::dissolve(Cache& cache, const Views& views, int j) const {
  bool dissolves = false;
  double total = 0.0, current = 0.0, rate = 0.0, slope = 0.0;
  const double bare = 1.0 - views.salt[j];
  for (std::size_t p = 0; p < phases_.count(); ++p) {
    const double perCurrent = (1.0 - saturation_ / phases_[p].solidConcentration) / (chargeNumber_ * faraday);
    const double area = cache.area[p][0][j];
    double flux = views.demand[j] == 0.0 ? 0.0 : phases_.pace(p, views.filmAt(j)) * views.demand[j];
    if (bare != 0.0) {
      const CurrentDensity::Value i = phases_[p].currentDensity.at(views.concentration[j]);
      const double open = views.open(j, phases_[p]);
      flux += bare * open * perCurrent * i.current;
      current += area * bare * open * i.current;
      rate += area * open * perCurrent * i.current;
      slope += area * open * perCurrent * i.slope;
    }
    cache.lostFlux[p][0][j] = -flux;
    if (area > 0.0) views.rate[j] += area * flux;
    total += area;
    dissolves = dissolves || flux != 0.0;
  }
  if (total > 0.0) {
    views.current[j] = current / total;
    views.dissolutionRate[j] = rate;
    views.slope[j] = slope;
  }
  return dissolves;
}

void CorrosionDissolution::computeFluxDivergence(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                                 const int* neighborhoodList, DataManager& dataManager) const {
  const Views views(*this, dataManager);
  Cache& cache = cacheOf({numOwnedPoints, ownedIDs, neighborhoodList}, views, dataManager);
  const kernels::PhaseBonds& phases = cache.phases;
  // A host that probes with lists of its own prepares nothing for them.
  if (!cache.isPrepared) {
    takeUpPhases(dt, cache, views);
    findAcidity(cache, views);
  }
  if (!cache.hasAreas) {
    findAreas(cache, views);
    for (const auto& [first, end] : phases.liquidRanges())
      std::copy(views.diffusionCorrection + first, views.diffusionCorrection + end,
                cache.diffusionCorrection[0] + first);
  }
  // Deep solid has no rate, and costs nothing.
  if (cache.zeroed != views.rate) std::fill(views.rate, views.rate + views.nPoints, 0.0);
  cache.zeroed = views.rate;
  for (const int i : cache.ofOtherBlocks) views.rate[i] = 0.0;
  for (const std::size_t c : phases.activeChunks()) {
    const kernels::Chunk& chunk = cache.neighborhood.chunks()[c];
    const int* points = cache.neighborhood.pointIds(chunk);
    for (int lane = 0; lane < chunk.nLanes; ++lane) views.rate[points[lane]] = 0.0;
  }
  for (const auto& [first, end] : phases.liquidRanges())
    std::copy(views.concentration + first, views.concentration + end, cache.concentration[0] + first);
  kernels::addScaledFluxDivergence(cache.neighborhood, cache.diffusion, phases.liquid(), phases.liquidChunks(),
                                   cache.diffusionCorrection[0], cache.concentration[0], views.rate);
  bool dissolves = false;
  for (const int j : phases.sources()) {
    const bool isIdle = views.salt[j] == 1.0 && views.demand[j] == 0.0;
    if (isIdle)
      for (kernels::PointArrays& lost : cache.lostFlux) lost[0][j] = 0.0;
    else
      dissolves = dissolve(cache, views, j) || dissolves;
  }
  if (!dissolves) return;
  for (std::size_t p = 0; p < phases_.count(); ++p)
    kernels::addWeightedSum(cache.neighborhood, cache.dissolution, phases.fromSolid(), phases.solidChunks(),
                            cache.correction[p][0], cache.lostFlux[p][0], views.rate);
}

/// Of liquid points; the loss of solid ones follows from it.
void CorrosionDissolution::computeJacobian(const double dt, const int numOwnedPoints, const int* ownedIDs,
                                           const int* neighborhoodList, DataManager& dataManager,
                                           PeridigmNS::SerialMatrix& jacobian, JacobianType) const {
  const UnknownPlace place = unknownPlace(fields_.label);
  if (!place.isUnknown) return;
  const Views views(*this, dataManager);
  Cache& cache = cacheOf({numOwnedPoints, ownedIDs, neighborhoodList}, views, dataManager);
  if (!cache.isPrepared) takeUpPhases(dt, cache, views);
  const auto& map = *dataManager.getOverlapScalarPointMap();
  const auto row = [&](int i) { return place.row(map.GID(i)); };
  for (const std::size_t c : cache.phases.liquidChunks()) {
    const kernels::Chunk& chunk = cache.neighborhood.chunks()[c];
    const double* weights = cache.diffusion.of(c);
    const unsigned char* bits = cache.phases.liquid().of(chunk);
    const bool isUniform = cache.diffusion.isUniform(c);
    for (int lane = 0; lane < chunk.nLanes; ++lane) {
      const int i = cache.neighborhood.pointIds(chunk)[lane];
      if (!cache.phases.isLiquid(i)) continue;
      const int own = row(i);
      double sum = 0.0;
      for (int k = 0; k < chunk.nNeighbors; ++k) {
        if (((bits[k] >> lane) & 1) == 0) continue;
        const int j = cache.neighborhood.neighbor(chunk, k, lane);
        const double w = 0.5 * (views.diffusionCorrection[i] + views.diffusionCorrection[j]) * views.volume[i] *
                         weights[isUniform ? k : k * kernels::lanes + lane];
        sum += w;
        jacobian.addValue(own, row(j), w);
      }
      jacobian.addValue(own, own, (1.0 - views.salt[i]) * views.slope[i] * views.volume[i] - sum);
    }
  }
}

PD_REGISTER_MATERIAL(CorrosionDissolution, "Corrosion Dissolution",
                     "Dissolution of a metal into an electrolyte and diffusion of its ions.")

}  // namespace pd
