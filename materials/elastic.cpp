#include "elastic.hpp"

#include <algorithm>
#include <stdexcept>

#include "Peridigm_InfluenceFunction.hpp"
#include "damage_views.hpp"
#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;

namespace {

constexpr const char* owner = "material Elastic";
constexpr const char* moduli[] = {"Bulk Modulus", "Shear Modulus", "Young's Modulus", "Poisson's Ratio"};

}  // namespace

void Elastic::declareParameters(ParameterDeclarations& declare) {
  declare.text("Material Model", "Name of this model.").defaultTo("Elastic");
  declare.real("Density", "kg/m3", "Mass density.").positive().required();
  declare.real("Bulk Modulus", "Pa", "Bulk modulus; two of the four elastic constants are given.").positive();
  declare.real("Shear Modulus", "Pa", "Shear modulus.").positive();
  declare.real("Young's Modulus", "Pa", "Young's modulus.").positive();
  declare.real("Poisson's Ratio", "1", "Poisson's ratio.").strictlyBetween(-1.0, 0.5);
  declare.real("Horizon", "m", "Radius of the neighbourhood; given by the block.").positive();
  BondFamily::declarePlane(declare);
  declare
      .text("Volume Correction",
            "Which share of a neighbour's cell counts near the horizon: all of it up to the horizon (None), "
            "all of every neighbour, however far (Every Neighbor; of decks of Peridigm), or linear between horizon -/+ "
            "half a spacing (Ramp Beyond Horizon; needs neighbours up to "
            "there), or the same but nothing beyond the horizon (Ramp To Horizon).")
      .oneOf({"Ramp Beyond Horizon", "Ramp To Horizon", "None", "Every Neighbor"})
      .defaultTo("None");
  declare.flag("Apply Automatic Differentiation Jacobian",
               "Accepted for decks of Peridigm, where it chooses between two ways to the same tangent.");
  declare.real("Finite Difference Probe Length", "m", "Step of the finite-difference tangent.").positive();
  declare.atMostOneOf({"Plane Stress", "Plane Strain"});
}

Elastic::Elastic(const Teuchos::ParameterList& given) : Elastic(given, completed<Elastic>(given, owner)) {}

Elastic::Elastic(const Teuchos::ParameterList& given, const Teuchos::ParameterList& params)
    : Material(given), family_(params, owner) {
  const auto nModuli =
      std::count_if(std::begin(moduli), std::end(moduli), [&](const char* name) { return params.isParameter(name); });
  if (nModuli != 2)
    throw std::invalid_argument(
        "material Elastic: give two of \"Bulk Modulus\", \"Shear Modulus\", \"Young's Modulus\", \"Poisson's Ratio\"");
  density_ = params.get<double>("Density");
  bulkModulus_ = calculateBulkModulus(params);
  shearModulus_ = calculateShearModulus(params);
  constants_ = kernels::solidConstants(family_.section.geometry, bulkModulus_, shearModulus_);
  if (params.isParameter("Finite Difference Probe Length"))
    m_finiteDifferenceProbeLength = params.get<double>("Finite Difference Probe Length");
}

struct Elastic::Views {
  int nPoints;
  const double *x, *y, *volume;
  const double* cellVolume;        ///< volume where the deck has no voids
  const double* interactionShare;  ///< null: all of every bond
  DamageViews damaged;
  double *weightedVolume, *dilatation, *force;

  Views(const Elastic& owner, DataManager& dataManager) {
    const Fields& fields = owner.fields_;
    nPoints = fields.volume.length(dataManager);
    x = fields.modelCoordinates.of(dataManager);
    y = fields.coordinates.of(dataManager);
    volume = fields.volume.of(dataManager);
    cellVolume = fields.cellVolume.isIn(dataManager) ? fields.cellVolume.of(dataManager) : volume;
    interactionShare = fields.interactionShare.ifIn(dataManager);
    weightedVolume = fields.weightedVolume.of(dataManager);
    dilatation = fields.dilatation.of(dataManager);
    force = fields.force.of(dataManager);
    damaged = damageViews(dataManager, fields.bondDamage, fields.damage);
  }
  double unbroken(std::size_t bond) const {
    return damaged.bondDamage == nullptr ? 1.0 : 1.0 - damaged.bondDamage[bond];
  }
};

double Elastic::influence(const Views& views, const ReferenceBond& geometry, int i, int j, std::size_t bond) const {
  return PeridigmNS::InfluenceFunction::self().getInfluenceFunction()(geometry.length, family_.horizon) *
         family_.share(geometry.length, views.cellVolume[i], views.cellVolume[j]) *
         (views.interactionShare == nullptr ? 1.0 : views.interactionShare[bond]);
}

void Elastic::initialize(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                         DataManager& dataManager) {
  const Views views(*this, dataManager);
  caches_.clear();
  for (int p = 0; p < numOwnedPoints; ++p) views.weightedVolume[ownedIDs[p]] = 0.0;
  forEachBond({numOwnedPoints, ownedIDs, neighborhoodList}, [&](int i, int j, std::size_t index) {
    const ReferenceBond bond(views.x, i, j);
    views.weightedVolume[i] += influence(views, bond, i, j, index) * bond.length * bond.length * views.volume[j];
  });
}

Elastic::Cache Elastic::makeCache(const Call& call, const Views& views) const {
  Cache cache;
  cache.neighborhood = kernels::ChunkedNeighborhood(call.nOwned, call.ownedIds, call.neighborhoodList);
  cache.alive = kernels::AliveBonds(cache.neighborhood);
  cache.data.constants = constants_;
  cache.data.influence =
      kernels::BondConstants(cache.neighborhood, 1, [&](int i, int j, std::size_t bond, double* values) {
        values[0] = influence(views, ReferenceBond(views.x, i, j), i, j, bond);
      });
  cache.data.coefficients =
      kernels::solidCoefficients(cache.neighborhood, [&](int i, int j, std::size_t index, double* values) {
        const ReferenceBond bond(views.x, i, j);
        std::copy(bond.xi.begin(), bond.xi.end(), values);
        values[3] = influence(views, bond, i, j, index);
        values[4] = views.volume[j];
      });
  cache.reference.separate(views.x, views.nPoints, 3);
  cache.volume.copy(views.volume, views.nPoints);
  return cache;
}

void Elastic::computeForce(const double, const int numOwnedPoints, const int* ownedIDs, const int* neighborhoodList,
                           DataManager& dataManager) const {
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  const Views views(*this, dataManager);
  std::fill(views.force, views.force + 3 * static_cast<std::size_t>(views.nPoints), 0.0);
  Cache& cache = caches_.of(call, views.x, [&](const Call& c) { return makeCache(c, views); });
  if (views.damaged.bondDamage != nullptr &&
      !cache.alive.refresh(cache.neighborhood, views.damaged.bondDamage, views.damaged.damage)) {
    caches_.clear();
    addForceOfDamagedBonds(call, views);
    return;
  }
  cache.displacement.separateDifference(views.y, views.x, views.nPoints, 3);
  cache.force.zero(views.nPoints, 3);
  kernels::addSolidForce(cache.neighborhood, cache.data, cache.alive,
                         {cache.reference, cache.displacement, cache.volume[0]}, views.weightedVolume, views.dilatation,
                         cache.force);
  cache.force.addTo(views.force, views.nPoints, 3);
}

std::vector<double> Elastic::dilatations(const Call& call, const Views& views) const {
  std::vector<double> theta(static_cast<std::size_t>(views.nPoints), 0.0);
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    if (views.weightedVolume[i] == 0.0) return;
    const ReferenceBond reference(views.x, i, j), current(views.y, i, j);
    theta[static_cast<std::size_t>(i)] += constants_.dimension / views.weightedVolume[i] * views.unbroken(bond) *
                                          influence(views, reference, i, j, bond) * reference.length *
                                          (current.length - reference.length) * views.volume[j];
  });
  return theta;
}

void Elastic::addForceOfDamagedBonds(const Call& call, const Views& views) const {
  const std::vector<double> theta = dilatations(call, views);
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    const double unbroken = views.unbroken(bond);
    if (unbroken == 0.0 || views.weightedVolume[i] == 0.0) return;
    const ReferenceBond reference(views.x, i, j), current(views.y, i, j);
    const double state = unbroken * influence(views, reference, i, j, bond) / views.weightedVolume[i] *
                         (constants_.volumetric * theta[static_cast<std::size_t>(i)] * reference.length +
                          unbroken * constants_.deviatoric * (current.length - reference.length));
    for (std::size_t d = 0; d < 3; ++d) {
      const double force = state * current.xi[d] / current.length;
      views.force[3 * static_cast<std::size_t>(i) + d] += force * views.volume[j];
      views.force[3 * static_cast<std::size_t>(j) + d] -= force * views.volume[i];
    }
  });
  for (int p = 0; p < call.nOwned; ++p)
    views.dilatation[call.ownedIds[p]] = theta[static_cast<std::size_t>(call.ownedIds[p])];
}

void Elastic::computeStoredElasticEnergyDensity(const double, const int numOwnedPoints, const int* ownedIDs,
                                                const int* neighborhoodList, DataManager& dataManager) const {
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  const Views views(*this, dataManager);
  double* energy = fields_.energy.of(dataManager);
  const std::vector<double> theta = dilatations(call, views);
  for (int p = 0; p < numOwnedPoints; ++p) {
    const double own = theta[static_cast<std::size_t>(ownedIDs[p])];
    energy[ownedIDs[p]] = 0.5 * constants_.bulk * own * own;
  }
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    if (views.weightedVolume[i] == 0.0) return;
    const ReferenceBond reference(views.x, i, j), current(views.y, i, j);
    const double deviation = current.length - reference.length -
                             theta[static_cast<std::size_t>(i)] * reference.length / constants_.dimension;
    energy[i] += 0.5 * constants_.deviatoric / views.weightedVolume[i] * views.unbroken(bond) *
                 influence(views, reference, i, j, bond) * deviation * deviation * views.volume[j];
  });
}

LinearSprings Elastic::springs(const Call& call, DataManager& data) const {
  const Views views(*this, data);
  LinearSprings result;
  result.family = springFamily();
  forEachBond(call, [&](int i, int j, std::size_t index) {
    const ReferenceBond bond(views.x, i, j);
    result.along.push_back(constants_.deviatoric * influence(views, bond, i, j, index) * views.volume[i] *
                           views.volume[j] / views.weightedVolume[i]);
  });
  // The energy volumetric/(2 D) theta^2 V_i, with theta = D s/(V_i deviatoric).
  const double factor = constants_.volumetric * constants_.dimension / (constants_.deviatoric * constants_.deviatoric);
  for (int p = 0; p < call.nOwned; ++p) result.dilatational.push_back(factor / views.volume[call.ownedIds[p]]);
  return result;
}

PD_REGISTER_MATERIAL(Elastic, "Elastic", "Linear peridynamic solid: ordinary state-based elasticity.")

}  // namespace pd
