#include "nonlocal_diffusion.hpp"

#include <algorithm>

#include "Peridigm_DegreesOfFreedomManager.hpp"
#include "field_names.hpp"

namespace pd {

using PeridigmNS::DataManager;
using PeridigmNS::FieldManager;
namespace Field = PeridigmNS::PeridigmField;

void NonlocalDiffusion::declareParameters(ParameterDeclarations& declare) {
  declare.real("Diffusivity", "m2/s", "Diffusivity; give it to switch diffusion on.").positive();
  declare.text("Diffusion Kernel", "Dependence of a bond's flux on its length: 1/|xi|^2, 1/|xi| or constant.")
      .oneOf({"Inverse Square", "Inverse", "Constant"})
      .defaultTo("Inverse Square");
  declare
      .text("Diffusing Field",
            "Label of the field that diffuses; its rate goes to <label>_Flux_Divergence (Flux_Divergence for "
            "Temperature, the pair that Peridigm solves for).")
      .defaultTo("Concentration");
  declare.flag("Diffusion Stops At Broken Bonds", "Broken bonds carry no flux (by default cracks do not hinder it).")
      .defaultTo(false);
}

NonlocalDiffusion::NonlocalDiffusion(const Teuchos::ParameterList& params, const BondFamily& family,
                                     const std::string& owner, Interface interface)
    : owner_(owner), family_(family), interface_(interface), diffusivity_(params.get<double>("Diffusivity")) {
  const std::string kernel = params.get<std::string>("Diffusion Kernel");
  if (kernel == "Inverse") kernel_ = kernels::DiffusionKernel::Inverse;
  if (kernel == "Constant") kernel_ = kernels::DiffusionKernel::Constant;
  stopsAtBrokenBonds_ = params.get<bool>("Diffusion Stops At Broken Bonds");
  microDiffusivity_ = kernels::microDiffusivity(family_.section, kernel_, diffusivity_, family_.horizon);

  const std::string field = params.get<std::string>("Diffusing Field");
  FieldManager& fields = FieldManager::self();
  modelCoordinatesId_ = fields.getFieldId(Field::NODE, Field::VECTOR, Field::CONSTANT, "Model_Coordinates");
  volumeId_ = fields.getFieldId(Field::ELEMENT, Field::SCALAR, Field::CONSTANT, "Volume");
  fieldId_ = fields.getFieldId(Field::NODE, Field::SCALAR, Field::TWO_STEP, field);
  fluxId_ = fields.getFieldId(Field::NODE, Field::SCALAR, Field::TWO_STEP, fluxDivergenceField(field));
  damageId_ = fields.getFieldId(Field::ELEMENT, Field::SCALAR, Field::TWO_STEP, "Damage");
  blockId_ = fields.getFieldId(Field::ELEMENT, Field::SCALAR, Field::CONSTANT, "Block_Id");
  bondDamageId_ = fields.getFieldId(Field::BOND, Field::SCALAR, Field::TWO_STEP, "Bond_Damage");
}

std::vector<int> NonlocalDiffusion::fieldIds() const {
  return {modelCoordinatesId_, volumeId_, blockId_, fieldId_, fluxId_};
}

void NonlocalDiffusion::initialize(const Call& call, DataManager& dataManager) {
  caches_.clear();
  if (family_.rescalesToLattice)
    microDiffusivity_ = kernels::latticeMicroDiffusivity(
        family_.section, kernel_, diffusivity_, family_.horizon,
        family_.latticeSpacing(call, view(dataManager, volumeId_, Field::STEP_NONE), owner_), family_.volumeCorrection);
}

double NonlocalDiffusion::weight(const ReferenceBond& bond, double volume, double neighborVolume) const {
  return microDiffusivity_ * kernels::kernelValue(kernel_, bond.length) *
         family_.share(bond.length, volume, neighborVolume);
}

DamageViews NonlocalDiffusion::cuts(DataManager& dataManager) const {
  return stopsAtBrokenBonds_ ? damageViews(dataManager, bondDamageId_, damageId_) : DamageViews();
}

void NonlocalDiffusion::addInterfaceFlux(const Cache& cache, const double* x, const double* volume,
                                         const double* concentration, const double* bondDamage, double* rate) const {
  for (const auto& [i, j, bond] : cache.interfaceBonds) {
    if (bondDamage != nullptr && bondDamage[bond] >= 1.0) continue;
    rate[j] +=
        0.5 * weight(ReferenceBond(x, i, j), volume[i], volume[j]) * volume[i] * (concentration[i] - concentration[j]);
  }
}

void NonlocalDiffusion::computeFluxDivergence(const Call& call, DataManager& dataManager) const {
  const double* x = view(dataManager, modelCoordinatesId_, Field::STEP_NONE);
  const double* volume = view(dataManager, volumeId_, Field::STEP_NONE);
  const double* concentration = view(dataManager, fieldId_, Field::STEP_NP1);
  double* rate = view(dataManager, fluxId_, Field::STEP_NP1);
  const int nPoints = dataManager.getData(fieldId_, Field::STEP_NP1)->MyLength();
  std::fill(rate, rate + nPoints, 0.0);

  const double* blockId = view(dataManager, blockId_, Field::STEP_NONE);
  Cache& cache = caches_.of(call, x, [&](const Call& c) {
    Cache made;
    made.neighborhood = kernels::ChunkedNeighborhood(c.nOwned, c.ownedIds, c.neighborhoodList);
    made.weights = kernels::BondConstants(made.neighborhood, 1, [&](int i, int j, std::size_t, double* values) {
      const double part = isShared(blockId, i, j) ? 0.5 : 1.0;
      values[0] = part * weight(ReferenceBond(x, i, j), volume[i], volume[j]) * volume[j];
    });
    if (interface_ == Interface::Balanced) made.interfaceBonds = findInterfaceBonds(c, blockId);
    if (stopsAtBrokenBonds_) made.alive = kernels::AliveBonds(made.neighborhood);
    return made;
  });
  const auto [bondDamage, damage] = cuts(dataManager);
  const bool isCut = bondDamage != nullptr;
  if (isCut) cache.alive.refresh(cache.neighborhood, bondDamage, damage);
  cache.concentration.copy(concentration, nPoints);
  kernels::addFluxDivergence(cache.neighborhood, cache.weights, isCut ? &cache.alive : nullptr, cache.concentration[0],
                             rate);
  addInterfaceFlux(cache, x, volume, concentration, bondDamage, rate);
}

void NonlocalDiffusion::computeJacobian(const Call& call, DataManager& dataManager,
                                        PeridigmNS::SerialMatrix& jacobian) const {
  const double* x = view(dataManager, modelCoordinatesId_, Field::STEP_NONE);
  const double* volume = view(dataManager, volumeId_, Field::STEP_NONE);
  const double* bondDamage = cuts(dataManager).bondDamage;
  const double* blockId = view(dataManager, blockId_, Field::STEP_NONE);
  const auto& map = *dataManager.getOverlapScalarPointMap();
  auto& unknowns = PeridigmNS::DegreesOfFreedomManager::self();
  const int perPoint = unknowns.totalNumberOfDegreesOfFreedom(), offset = unknowns.temperatureDofOffset();
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    if (bondDamage != nullptr && bondDamage[bond] >= 1.0) return;
    const bool isInterface = isShared(blockId, i, j);
    const double w =
        (isInterface ? 0.5 : 1.0) * weight(ReferenceBond(x, i, j), volume[i], volume[j]) * volume[i] * volume[j];
    const int row = perPoint * map.GID(i) + offset, column = perPoint * map.GID(j) + offset;
    jacobian.addValue(row, row, -w);
    jacobian.addValue(row, column, w);
    if (!isInterface) return;
    jacobian.addValue(column, column, -w);
    jacobian.addValue(column, row, w);
  });
}

}  // namespace pd
