#include "corrosion_dissolution.hpp"

#include <algorithm>
#include <stdexcept>

#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "diffusion_kernel.hpp"
#include "field_names.hpp"
#include "field_views.hpp"
#include "plugins.hpp"

namespace pd {

using PeridigmNS::DataManager;
using PeridigmNS::FieldManager;
namespace Field = PeridigmNS::PeridigmField;

namespace {

constexpr double faraday = 96485.33212;  ///< C/mol, CODATA 2018 (exact since 2019 to these digits)
constexpr const char* owner = "material Corrosion Dissolution";

Teuchos::ParameterList completed(const Teuchos::ParameterList& params) {
  ParameterDeclarations declarations;
  CorrosionDissolution::declareParameters(declarations);
  Teuchos::ParameterList list = declarations.complete(params, owner);
  if (list.get<double>("Saturation Concentration") >= list.get<double>("Solid Concentration"))
    throw std::invalid_argument(std::string(owner) +
                                ": \"Saturation Concentration\" must be below \"Solid Concentration\"");
  return list;
}

}  // namespace

void CorrosionDissolution::declareParameters(ParameterDeclarations& declare) {
  declare.text("Material Model", "Name of this model.").defaultTo("Corrosion Dissolution");
  declare.real("Diffusivity", "m2/s", "Of metal ions in the electrolyte.").positive().required();
  declare.real("Solid Concentration", "mol/m3", "Metal atoms in the intact solid.").positive().required();
  declare.real("Saturation Concentration", "mol/m3", "Most metal ions that the electrolyte holds.")
      .positive()
      .required();
  declare.real("Charge Number", "1", "Mean charge of the ions, z.").positive().required();
  declare
      .real("Dissolution Range", "m",
            "How far apart solid and liquid points may be that exchange metal; by default half the horizon. Where salt "
            "covers the surface, the electrolyte is saturated as far as that.")
      .positive();
  CurrentDensity::declareParameters(declare);
  BondFamily::declareParameters(declare);
}

CorrosionDissolution::CorrosionDissolution(const Teuchos::ParameterList& given)
    : CorrosionDissolution(given, completed(given)) {}

CorrosionDissolution::CorrosionDissolution(const Teuchos::ParameterList& given, const Teuchos::ParameterList& params)
    : Material(given),
      family_(params, owner),
      interfaceFamily_(family_),
      diffusivity_(params.get<double>("Diffusivity")),
      solidConcentration_(params.get<double>("Solid Concentration")),
      saturation_(params.get<double>("Saturation Concentration")),
      chargeNumber_(params.get<double>("Charge Number")),
      currentDensity_(params, saturation_, owner) {
  microDiffusivity_ = kernels::microDiffusivity(family_.section, kernels::DiffusionKernel::InverseSquare, diffusivity_,
                                                family_.horizon);
  interfaceFamily_.horizon =
      params.isParameter("Dissolution Range") ? params.get<double>("Dissolution Range") : 0.5 * family_.horizon;
  if (interfaceFamily_.horizon > family_.horizon)
    throw std::invalid_argument(std::string(owner) + ": \"Dissolution Range\" must not exceed the horizon");
  interfaceConstant_ = kernels::interfaceFluxConstant(family_.section, interfaceFamily_.horizon);
  FieldManager& fields = FieldManager::self();
  const auto point = [&](const char* label, Field::Temporal temporal = Field::CONSTANT) {
    return fields.getFieldId(Field::NODE, Field::SCALAR, temporal, label);
  };
  modelCoordinatesId_ = fields.getFieldId(Field::NODE, Field::VECTOR, Field::CONSTANT, "Model_Coordinates");
  volumeId_ = fields.getFieldId(Field::ELEMENT, Field::SCALAR, Field::CONSTANT, "Volume");
  damageId_ = fields.getFieldId(Field::ELEMENT, Field::SCALAR, Field::TWO_STEP, "Damage");
  concentrationId_ = point("Concentration", Field::TWO_STEP);
  rateId_ = point(fluxDivergenceField("Concentration").c_str(), Field::TWO_STEP);
  saltId_ = point("Salt_Coverage");
  demandId_ = point("Dissolution_Demand");
  areaId_ = point("Interface_Area_Density");
  currentId_ = point("Current_Density");
  dissolutionRateId_ = point("Dissolution_Rate");
  slopeId_ = point("Dissolution_Rate_Slope");
  solidId_ = point("Solid_Concentration");
  saturationId_ = point("Saturation_Concentration");
  completenessId_ = point("Interface_Completeness");
}

double CorrosionDissolution::Density() const {
  throw std::invalid_argument(std::string(owner) + " has no mechanics, which this solver needs");
}

std::vector<int> CorrosionDissolution::FieldIds() const {
  return {modelCoordinatesId_,
          volumeId_,
          concentrationId_,
          rateId_,
          damageId_,
          saltId_,
          demandId_,
          areaId_,
          currentId_,
          dissolutionRateId_,
          slopeId_,
          solidId_,
          saturationId_,
          completenessId_};
}

struct CorrosionDissolution::Views {
  int nPoints;
  const double *x, *volume, *concentration, *damage, *salt, *demand;
  double *rate, *area, *current, *dissolutionRate, *slope, *solid, *saturation, *completeness;

  Views(const CorrosionDissolution& material, DataManager& dataManager) {
    nPoints = dataManager.getData(material.volumeId_, Field::STEP_NONE)->MyLength();
    x = view(dataManager, material.modelCoordinatesId_, Field::STEP_NONE);
    volume = view(dataManager, material.volumeId_, Field::STEP_NONE);
    concentration = view(dataManager, material.concentrationId_, Field::STEP_NP1);
    damage = view(dataManager, material.damageId_, Field::STEP_NP1);
    salt = view(dataManager, material.saltId_, Field::STEP_NONE);
    demand = view(dataManager, material.demandId_, Field::STEP_NONE);
    rate = view(dataManager, material.rateId_, Field::STEP_NP1);
    area = view(dataManager, material.areaId_, Field::STEP_NONE);
    current = view(dataManager, material.currentId_, Field::STEP_NONE);
    dissolutionRate = view(dataManager, material.dissolutionRateId_, Field::STEP_NONE);
    slope = view(dataManager, material.slopeId_, Field::STEP_NONE);
    solid = view(dataManager, material.solidId_, Field::STEP_NONE);
    saturation = view(dataManager, material.saturationId_, Field::STEP_NONE);
    completeness = view(dataManager, material.completenessId_, Field::STEP_NONE);
  }
};

double CorrosionDissolution::diffusionWeight(const ReferenceBond& bond, double volume, double neighborVolume) const {
  return microDiffusivity_ / (bond.length * bond.length) * family_.share(bond.length, volume, neighborVolume);
}

double CorrosionDissolution::dissolutionWeight(const ReferenceBond& bond, double volume, double neighborVolume) const {
  return interfaceConstant_ / bond.length * interfaceFamily_.share(bond.length, volume, neighborVolume);
}

void CorrosionDissolution::initialize(const double, const int numOwnedPoints, const int* ownedIDs,
                                      const int* neighborhoodList, DataManager& dataManager) {
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  const Views views(*this, dataManager);
  caches_.clear();
  if (family_.rescalesToLattice) {
    const double spacing = family_.latticeSpacing(call, views.volume, owner);
    microDiffusivity_ =
        kernels::latticeMicroDiffusivity(family_.section, kernels::DiffusionKernel::InverseSquare, diffusivity_,
                                         family_.horizon, spacing, family_.volumeCorrection);
    interfaceConstant_ = kernels::latticeInterfaceFluxConstant(family_.section, interfaceFamily_.horizon, spacing,
                                                               family_.volumeCorrection);
  }
  for (int p = 0; p < numOwnedPoints; ++p) {
    const int i = ownedIDs[p];
    views.solid[i] = views.concentration[i] > saturation_ ? solidConcentration_ : 0.0;
    views.saturation[i] = saturation_;
  }
  findCompleteness(call, views);
}

/// Flux that a plane front at a point passes, of what it passes inside a body: along each axis on the side where more
/// is, then for the axis where least is. (Of a front that runs along a side, this is what the side takes away; for one
/// that runs at a side, nothing.)
void CorrosionDissolution::findCompleteness(const Call& call, const Views& views) const {
  const auto dimension = static_cast<std::size_t>(family_.dimension());
  std::size_t at = 0;
  for (int p = 0; p < call.nOwned; ++p) {
    const int i = call.ownedIds[p];
    double passed[2][3] = {};
    const int count = call.neighborhoodList[at++];
    for (int k = 0; k < count; ++k) {
      const int j = call.neighborhoodList[at++];
      const ReferenceBond bond(views.x, i, j);
      const double weight = dissolutionWeight(bond, views.volume[i], views.volume[j]) * views.volume[j];
      for (std::size_t d = 0; d < dimension; ++d) passed[bond.xi[d] > 0.0][d] += weight * std::abs(bond.xi[d]);
    }
    double least = 1.0;
    for (std::size_t d = 0; d < dimension; ++d) least = std::min(least, std::max(passed[0][d], passed[1][d]));
    constexpr double smallest = 0.1;  // of points that hang by a corner
    views.completeness[i] = std::max(least, smallest);
  }
}

CorrosionDissolution::Cache& CorrosionDissolution::cacheOf(const Call& call, const Views& views) const {
  return caches_.of(call, views.x, [&](const Call& c) {
    Cache made;
    made.neighborhood = kernels::ChunkedNeighborhood(c.nOwned, c.ownedIds, c.neighborhoodList);
    made.diffusion = kernels::BondConstants(made.neighborhood, 1, [&](int i, int j, std::size_t, double* value) {
      *value = diffusionWeight(ReferenceBond(views.x, i, j), views.volume[i], views.volume[j]) * views.volume[j];
    });
    made.dissolution = kernels::BondConstants(made.neighborhood, 1, [&](int i, int j, std::size_t, double* value) {
      *value = dissolutionWeight(ReferenceBond(views.x, i, j), views.volume[i], views.volume[j]) * views.volume[j];
    });
    made.phases = kernels::PhaseBonds(made.neighborhood, c.nOwned, c.ownedIds, c.neighborhoodList, views.nPoints);
    made.lostFlux.zero(views.nPoints, 1);
    made.area.zero(views.nPoints, 1);
    made.perCompleteness.zero(views.nPoints, 1);
    for (int i = 0; i < views.nPoints; ++i) made.perCompleteness[0][i] = 1.0 / views.completeness[i];
    return made;
  });
}

/// What changes with the phases alone.
void CorrosionDissolution::updateInterface(Cache& cache, int nPoints) const {
  cache.lostFlux.zero(nPoints, 1);
  cache.area.zero(nPoints, 1);
  kernels::addWeightedSum(cache.neighborhood, cache.dissolution, cache.phases.fromLiquid(), cache.phases.wetChunks(),
                          nullptr, cache.perCompleteness[0], cache.area[0]);
}

void CorrosionDissolution::computeFluxDivergence(const double, const int numOwnedPoints, const int* ownedIDs,
                                                 const int* neighborhoodList, DataManager& dataManager) const {
  const Call call{numOwnedPoints, ownedIDs, neighborhoodList};
  const Views views(*this, dataManager);
  std::fill(views.rate, views.rate + views.nPoints, 0.0);
  Cache& cache = cacheOf(call, views);
  if (cache.phases.refresh(cache.neighborhood, views.damage)) updateInterface(cache, views.nPoints);
  for (int p = 0; p < numOwnedPoints; ++p) {
    const int i = ownedIDs[p];
    views.area[i] = cache.area[0][i];
    views.current[i] = views.dissolutionRate[i] = views.slope[i] = 0.0;
  }
  cache.concentration.copy(views.concentration, views.nPoints);
  kernels::addFluxDivergence(cache.neighborhood, cache.diffusion, &cache.phases.liquid(), cache.concentration[0],
                             views.rate, &cache.phases.liquidChunks());

  const double perCurrent = (1.0 - saturation_ / solidConcentration_) / (chargeNumber_ * faraday);
  bool dissolves = false;
  for (const int j : cache.phases.sources()) {
    const double area = cache.area[0][j];  // of the points of this call; others are seen to by theirs
    double flux = views.demand[j];
    if (views.salt[j] < 1.0) {
      const CurrentDensity::Value current = currentDensity_.at(views.concentration[j]);
      flux += (1.0 - views.salt[j]) * perCurrent * current.current;
      if (area > 0.0) {
        views.current[j] = (1.0 - views.salt[j]) * current.current;
        views.dissolutionRate[j] = area * perCurrent * current.current;
        views.slope[j] = area * perCurrent * current.slope;
      }
    }
    cache.lostFlux[0][j] = -flux;
    if (area > 0.0) views.rate[j] += area * flux;
    dissolves = dissolves || flux != 0.0;
  }
  if (dissolves)
    kernels::addWeightedSum(cache.neighborhood, cache.dissolution, cache.phases.fromSolid(), cache.phases.solidChunks(),
                            cache.perCompleteness[0], cache.lostFlux[0], views.rate);
}

/// Of liquid points; the loss of solid ones follows from it.
void CorrosionDissolution::computeJacobian(const double, const int numOwnedPoints, const int* ownedIDs,
                                           const int* neighborhoodList, DataManager& dataManager,
                                           PeridigmNS::SerialMatrix& jacobian, JacobianType) const {
  const Views views(*this, dataManager);
  const auto& map = *dataManager.getOverlapScalarPointMap();
  auto& unknowns = PeridigmNS::DegreesOfFreedomManager::self();
  const int perPoint = unknowns.totalNumberOfDegreesOfFreedom(), offset = unknowns.temperatureDofOffset();
  const auto row = [&](int i) { return perPoint * map.GID(i) + offset; };
  forEachBond({numOwnedPoints, ownedIDs, neighborhoodList}, [&](int i, int j, std::size_t) {
    if (views.damage[i] < 1.0 || views.damage[j] < 1.0) return;
    const double w = diffusionWeight(ReferenceBond(views.x, i, j), views.volume[i], views.volume[j]) * views.volume[i] *
                     views.volume[j];
    jacobian.addValue(row(i), row(i), -w);
    jacobian.addValue(row(i), row(j), w);
  });
  for (int p = 0; p < numOwnedPoints; ++p) {
    const int i = ownedIDs[p];
    if (views.damage[i] >= 1.0)
      jacobian.addValue(row(i), row(i), (1.0 - views.salt[i]) * views.slope[i] * views.volume[i]);
  }
}

PD_REGISTER_MATERIAL(CorrosionDissolution, "Corrosion Dissolution",
                     "Dissolution of a metal into an electrolyte and diffusion of its ions.")

}  // namespace pd
