#include "bond_mechanics.hpp"

#include <algorithm>
#include <iostream>
#include <stdexcept>

#include "Peridigm_InfluenceFunction.hpp"
#include "bond_mechanics_views.hpp"
#include "surface_correction.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

SurfaceCorrection correctionFrom(const Teuchos::ParameterList& params) {
  const std::string name = params.get<std::string>("Surface Correction");
  if (name == "Volume Method") return SurfaceCorrection::VolumeMethod;
  if (name == "Energy Method") return SurfaceCorrection::EnergyMethod;
  return SurfaceCorrection::None;
}

}  // namespace

void BondMechanics::declareParameters(ParameterDeclarations& declare) {
  declare.real("Young's Modulus", "Pa", "Young's modulus; give it to switch mechanics on.").positive();
  declare
      .real("Poisson's Ratio", "1",
            "Poisson's ratio. Above 1/3 in plane stress, 1/4 otherwise, k_t is negative: allowed with a warning while "
            "the lattice is stable.")
      .strictlyBetween(-1.0, 0.5);
  declare
      .text("Tangential Force",
            "Objective: the rotation of the neighbourhood is removed from the tangential bond force, which then "
            "conserves angular momentum. Linear: as printed by Zhu & Ni, right for small rotations only.")
      .oneOf({"Objective", "Linear"})
      .defaultTo("Objective");
  declare
      .text("Surface Correction",
            "Stiffness of bonds near free surfaces: None; Volume Method: 2 V0/(V_i + V_j) from family volumes; Energy "
            "Method: from the strain energy of uniform strain along each axis. A cantilever six horizons high is 6 to "
            "8 % too soft by None, 8 to 11 % too stiff by the Volume Method and right within 2 % by the Energy Method, "
            "on squares, turned squares and triangles. The latter two cost a pass over the bonds at the start and, "
            "near surfaces, a constant of each bond in memory.")
      .oneOf({"None", "Volume Method", "Energy Method"})
      .defaultTo("None")
      .from("Le & Bobaru, Comput. Mech. 61 (2018) 499; Madenci & Oterkus (2014)");
  declare.needs("Young's Modulus", {"Poisson's Ratio"});
  declare.needs("Poisson's Ratio", {"Young's Modulus"});
}

BondMechanics::Fields::Fields(SurfaceCorrection correction) {
  if (correction == SurfaceCorrection::VolumeMethod)
    familyVolume = writes(pd::fields::pointScalar("Family_Volume", "m3", "Volume of the point's neighbourhood."),
                          Ghosts::AfterInitialize);
  if (correction == SurfaceCorrection::EnergyMethod)
    surfaceFactor = writes(surfaceCorrectionFactor(), Ghosts::AfterInitialize);
}

BondMechanics::BondMechanics(const Teuchos::ParameterList& params, const BondFamily& family, const std::string& owner)
    : owner_(owner), family_(family), surfaceCorrection_(correctionFrom(params)), fields_(surfaceCorrection_) {
  youngsModulus_ = params.get<double>("Young's Modulus");
  poissonsRatio_ = params.get<double>("Poisson's Ratio");
  if (params.get<std::string>("Tangential Force") == "Linear") form_ = kernels::TangentialForm::Linear;
  constants_ = family_.elasticConstants(youngsModulus_, poissonsRatio_);
}

BondMechanics::Views::Views(const BondMechanics& owner, DataManager& dataManager) {
  // Peridigm's finite-difference Jacobian hands no map of owned points.
  const auto ownedPoints = dataManager.getOwnedScalarPointMap();
  ownsFirstPoint = !ownedPoints.is_null() && ownedPoints->LID(0) != -1;
  const Fields& fields = owner.fields_;
  nPoints = fields.volume.length(dataManager);
  x = fields.modelCoordinates.of(dataManager);
  y = fields.coordinates.of(dataManager);
  volume = fields.volume.of(dataManager);
  cellVolume = fields.cellVolume.isIn(dataManager) ? fields.cellVolume.of(dataManager) : volume;
  interactionShare = fields.interactionShare.ifIn(dataManager);
  blockId = fields.blockId.of(dataManager);
  force = fields.force.of(dataManager);
  familyVolume = fields.familyVolume.ifIn(dataManager);
  surfaceFactor = fields.surfaceFactor.ifIn(dataManager);
  damaged = damageViews(dataManager, fields.bondDamage, fields.damage);
}

void BondMechanics::initialize(const Call& call, DataManager& dataManager) {
  const Views views(*this, dataManager);
  caches_.clear();
  if (family_.rescalesToLattice) {
    const double spacing = family_.latticeSpacing(call, views.cellVolume, owner_);
    constants_ = family_.latticeElasticConstants(youngsModulus_, poissonsRatio_, spacing);
  }
  computeSurfaceData(call, views);
  if (constants_.tangential < 0.0) checkStability(call, views);
}

void BondMechanics::computeSurfaceData(const Call& call, const Views& views) const {
  if (surfaceCorrection_ == SurfaceCorrection::None) return;
  const auto influence = PeridigmNS::InfluenceFunction::self().getInfluenceFunction();
  const double c11 = kernels::stiffness(family_.section.geometry, youngsModulus_, poissonsRatio_).c11;
  const bool usesVolume = surfaceCorrection_ == SurfaceCorrection::VolumeMethod;
  for (int p = 0; p < call.nOwned; ++p) {
    const auto i = static_cast<std::size_t>(call.ownedIds[p]);
    if (usesVolume) views.familyVolume[i] = 0.0;
    for (std::size_t d = 0; !usesVolume && d < 3; ++d) views.surfaceFactor[3 * i + d] = 0.0;
  }
  forEachBond(call, [&](int i, int j, std::size_t index) {
    const ReferenceBond bond(views.x, i, j);
    const double volume =
        views.shareOf(index) * family_.share(bond.length, views.cellVolume[i], views.cellVolume[j]) * views.volume[j];
    if (usesVolume) {
      views.familyVolume[i] += volume;
      return;
    }
    // Strain energy of unit strain along d, in units of C11/2 (kernels/bond_constants.cpp).
    for (std::size_t d = 0; d < 3; ++d) {
      const double n2 = bond.xi[d] * bond.xi[d] / (bond.length * bond.length);
      views.surfaceFactor[3 * static_cast<std::size_t>(i) + d] +=
          0.5 * influence(bond.length, family_.horizon) * bond.length * volume *
          (constants_.normal * n2 * n2 + constants_.tangential * (n2 - n2 * n2)) / c11;
    }
  });
  for (int p = 0; !usesVolume && p < call.nOwned; ++p)
    for (std::size_t d = 0; d < 3; ++d) {
      double& factor = views.surfaceFactor[3 * static_cast<std::size_t>(call.ownedIds[p]) + d];
      factor = factor > 0.0 ? 1.0 / factor : 1.0;
    }
}

double BondMechanics::wholeFamilyVolume(double volume) const {
  const auto known = wholeFamilyVolumes_.find(volume);
  if (known != wholeFamilyVolumes_.end()) return known->second;
  return wholeFamilyVolumes_[volume] = kernels::latticeFamilyVolume(family_.section, family_.horizon,
                                                                    family_.spacing(volume), family_.volumeCorrection);
}

double BondMechanics::surfaceFactor(const Views& views, const ReferenceBond& bond, int i, int j) const {
  if (surfaceCorrection_ == SurfaceCorrection::VolumeMethod) {
    const double whole = 0.5 * (wholeFamilyVolume(views.cellVolume[i]) + wholeFamilyVolume(views.cellVolume[j]));
    return kernels::surfaceFactor(whole, views.familyVolume[i], views.familyVolume[j]);
  }
  if (surfaceCorrection_ == SurfaceCorrection::EnergyMethod) {
    // Radius, along the bond, of the ellipsoid whose half-axes are the mean factors of both ends.
    double sum = 0.0;
    for (std::size_t d = 0; d < static_cast<std::size_t>(family_.dimension()); ++d) {
      const double axis = 0.5 * (views.surfaceFactor[3 * static_cast<std::size_t>(i) + d] +
                                 views.surfaceFactor[3 * static_cast<std::size_t>(j) + d]);
      sum += bond.xi[d] * bond.xi[d] / (bond.length * bond.length * axis * axis);
    }
    return 1.0 / std::sqrt(sum);
  }
  return 1.0;
}

double BondMechanics::strength(const Views& views, const ReferenceBond& geometry, int i, int j,
                               std::size_t bond) const {
  return PeridigmNS::InfluenceFunction::self().getInfluenceFunction()(geometry.length, family_.horizon) *
         family_.share(geometry.length, views.cellVolume[i], views.cellVolume[j]) *
         surfaceFactor(views, geometry, i, j) * views.shareOf(bond);
}

std::vector<kernels::WeightedBond> BondMechanics::familyOf(int i, const int* neighbors, int count,
                                                           const Views& views) const {
  const auto influence = PeridigmNS::InfluenceFunction::self().getInfluenceFunction();
  std::vector<kernels::WeightedBond> bonds;
  for (int k = 0; k < count; ++k) {
    const int j = neighbors[k];
    const ReferenceBond bond(views.x, i, j);
    const double share = family_.share(bond.length, views.cellVolume[i], views.cellVolume[j]);
    if (share > 0.0) bonds.push_back({bond.xi, share * views.volume[j] * influence(bond.length, family_.horizon)});
  }
  return bonds;
}

void BondMechanics::checkStability(const Call& call, const Views& views) const {
  // Whole neighbourhoods only: those of free surfaces carry no plane waves.
  std::vector<std::size_t> starts;
  std::size_t at = 0;
  int most = 0;
  for (int p = 0; p < call.nOwned; ++p) {
    starts.push_back(at);
    most = std::max(most, call.neighborhoodList[at]);
    at += static_cast<std::size_t>(call.neighborhoodList[at]) + 1;
  }
  std::vector<int> whole;
  for (int p = 0; p < call.nOwned; ++p)
    if (call.neighborhoodList[starts[static_cast<std::size_t>(p)]] >= 0.98 * most) whole.push_back(p);
  constexpr std::size_t samples = 8;
  double smallest = 1.0;
  for (std::size_t s = 0; s < std::min(samples, whole.size()); ++s) {
    const auto p = static_cast<std::size_t>(whole[s * whole.size() / std::min(samples, whole.size())]);
    const auto bonds =
        familyOf(call.ownedIds[p], call.neighborhoodList + starts[p] + 1, call.neighborhoodList[starts[p]], views);
    smallest = std::min(smallest, kernels::smallestRelativeStiffness(bonds, family_.dimension(), constants_, form_));
  }
  const std::string ratio = "Poisson's ratio " + std::to_string(poissonsRatio_) +
                            " makes the tangential bond stiffness negative (k_t/k_n = " +
                            std::to_string(constants_.tangential / constants_.normal) + ")";
  if (smallest <= 0.0)
    throw std::invalid_argument(owner_ + ": " + ratio +
                                " and this lattice unstable (its acoustic tensor is not positive definite); use a "
                                "smaller Poisson's ratio, or a larger ratio of horizon to spacing");
  if (views.ownsFirstPoint)
    std::clog << owner_ << ": warning: " << ratio << "; the lattice is stable (smallest relative stiffness " << smallest
              << "), but edges and corners of a body lose stability at smaller ratios than its bulk\n";
}

BondMechanics::Cache BondMechanics::makeCache(const Call& call, const Views& views, bool foldsDamage) const {
  Cache cache;
  cache.neighborhood = kernels::ChunkedNeighborhood(call.nOwned, call.ownedIds, call.neighborhoodList);
  cache.alive = kernels::AliveBonds(cache.neighborhood);
  cache.data.dimension = family_.dimension();
  cache.data.form = form_;
  cache.data.constants = constants_;
  const auto strengthOf = [&](int i, int j, std::size_t bond) {
    return strength(views, ReferenceBond(views.x, i, j), i, j, bond) *
           (foldsDamage ? 1.0 - views.damaged.bondDamage[bond] : 1.0);
  };
  cache.data.strength = kernels::BondConstants(
      cache.neighborhood, 1,
      [&](int i, int j, std::size_t bond, double* values) { values[0] = strengthOf(i, j, bond); });
  cache.interfaceBonds = findInterfaceBonds(call, views.blockId);
  const int dimension = family_.dimension();
  cache.data.coefficients =
      kernels::bondCoefficients(cache.neighborhood, cache.data, [&](int i, int j, std::size_t bond, double* values) {
        const ReferenceBond reference(views.x, i, j);
        for (int d = 0; d < dimension; ++d) values[d] = reference.xi[static_cast<std::size_t>(d)];
        values[dimension] = strengthOf(i, j, bond);
        values[dimension + 1] = views.volume[j];
      });
  cache.reference.separate(views.x, views.nPoints, dimension);
  cache.volume.copy(views.volume, views.nPoints);
  return cache;
}

void BondMechanics::addForce(Cache& cache, const Views& views) const {
  const int dimension = family_.dimension();
  cache.displacement.separateDifference(views.y, views.x, views.nPoints, dimension);
  cache.force.zero(views.nPoints, dimension);
  kernels::addTwoParameterForce(cache.neighborhood, cache.data, cache.alive, cache.reference, cache.displacement,
                                cache.volume[0], cache.force);
  cache.force.addTo(views.force, views.nPoints, dimension);
  addInterfaceForce(cache, views);
}

void BondMechanics::addInterfaceForce(const Cache& cache, const Views& views) const {
  const bool isLinear = form_ == kernels::TangentialForm::Linear;
  const double normal = constants_.normal, tangential = constants_.tangential, radial = normal - tangential;
  for (const auto& [i, j, bond] : cache.interfaceBonds) {
    const double alive = views.damaged.bondDamage == nullptr ? 1.0 : 1.0 - views.damaged.bondDamage[bond];
    if (alive == 0.0) continue;
    const ReferenceBond reference(views.x, i, j), current(views.y, i, j);
    const double half = 0.5 * alive * strength(views, reference, i, j, bond);
    double along = 0.0;
    for (std::size_t d = 0; d < 3; ++d) along += (current.xi[d] - reference.xi[d]) * reference.xi[d];
    for (std::size_t d = 0; d < 3; ++d) {
      const double force = isLinear ? radial * along / std::pow(reference.length, 3) * reference.xi[d] +
                                          tangential / reference.length * (current.xi[d] - reference.xi[d])
                                    : (normal / reference.length - radial / current.length) * current.xi[d];
      views.force[3 * static_cast<std::size_t>(i) + d] -= half * force * views.volume[j];
      views.force[3 * static_cast<std::size_t>(j) + d] -= half * force * views.volume[i];
    }
  }
}

void BondMechanics::computeForce(const Call& call, DataManager& dataManager) const {
  const Views views(*this, dataManager);
  std::fill(views.force, views.force + 3 * static_cast<std::size_t>(views.nPoints), 0.0);
  Cache& cache = caches_.of(call, views.x, [&](const Call& c) { return makeCache(c, views, false); });
  if (views.damaged.bondDamage != nullptr &&
      !cache.alive.refresh(cache.neighborhood, views.damaged.bondDamage, views.damaged.damage)) {
    // Bonds that are damaged in part: rare, and then their strength changes from call to call.
    caches_.clear();
    Cache partial = makeCache(call, views, true);
    addForce(partial, views);
    return;
  }
  addForce(cache, views);
}

}  // namespace pd
