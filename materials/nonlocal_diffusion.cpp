#include "nonlocal_diffusion.hpp"

#include <algorithm>
#include <stdexcept>

#include "meshfree_quadrature.hpp"
#include "unknowns.hpp"

namespace pd {

using PeridigmNS::DataManager;

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
                                     const std::string& owner, Interface interface, Quadrature quadrature)
    : owner_(owner),
      family_(family),
      interface_(interface),
      quadrature_(quadrature),
      diffusivity_(params.get<double>("Diffusivity")),
      fields_(params.get<std::string>("Diffusing Field")) {
  const std::string kernel = params.get<std::string>("Diffusion Kernel");
  if (kernel == "Inverse") kernel_ = kernels::DiffusionKernel::Inverse;
  if (kernel == "Constant") kernel_ = kernels::DiffusionKernel::Constant;
  stopsAtBrokenBonds_ = params.get<bool>("Diffusion Stops At Broken Bonds");
  microDiffusivity_ = kernels::microDiffusivity(family_.section, kernel_, diffusivity_, family_.horizon);
}

void NonlocalDiffusion::initialize(const Call& call, DataManager& dataManager) {
  caches_.clear();
  double* diffusivity = fields_.diffusivity.of(dataManager);
  for (int p = 0; p < call.nOwned; ++p) diffusivity[call.ownedIds[p]] = diffusivity_;
  if (family_.rescalesToLattice)
    microDiffusivity_ = kernels::latticeMicroDiffusivity(
        family_.section, kernel_, diffusivity_, family_.horizon,
        family_.latticeSpacing(
            call, (fields_.cellVolume.isIn(dataManager) ? fields_.cellVolume : fields_.volume).of(dataManager), owner_),
        family_.volumeCorrection);
  if (quadrature_ == Quadrature::Fitted && fields_.interactionShare.isIn(dataManager))
    throw std::invalid_argument(
        owner_ +
        ": the improved quadrature fits weights to whole neighbourhoods, which Cracks and Voids of "
        "the deck take a part of; leave \"Use Improved Quadrature\" out");
}

double NonlocalDiffusion::weight(const Quantities& of, const ReferenceBond& geometry, int i, int j,
                                 std::size_t bond) const {
  return microDiffusivity_ * kernels::kernelValue(kernel_, geometry.length) *
         family_.share(geometry.length, of.cellVolume[i], of.cellVolume[j]) *
         (of.interactionShare == nullptr ? 1.0 : of.interactionShare[bond]);
}

std::vector<double> NonlocalDiffusion::fittedWeights(const Call& call, const double* x) const {
  std::vector<double> all, xi;
  if (quadrature_ == Quadrature::Volumes) return all;
  std::size_t at = 0;
  for (int p = 0; p < call.nOwned; ++p) {
    const int point = call.ownedIds[p], count = call.neighborhoodList[at++];
    xi.clear();
    for (int k = 0; k < count; ++k) {
      const ReferenceBond bond(x, point, call.neighborhoodList[at++]);
      xi.insert(xi.end(), bond.xi.begin(), bond.xi.end());
    }
    const std::vector<double> own = kernels::meshfreeWeights(xi, family_.horizon, kernel_);
    if (own.empty())
      throw std::invalid_argument(
          owner_ + ": the " + std::to_string(count) + " neighbours of the point at (" + std::to_string(x[3 * point]) +
          ", " + std::to_string(x[3 * point + 1]) + ", " + std::to_string(x[3 * point + 2]) +
          ") m cannot integrate quadratic fields, as the improved quadrature asks for; choose a larger Horizon, or "
          "leave \"Use Improved Quadrature\" out");
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

NonlocalDiffusion::Quantities NonlocalDiffusion::quantities(const Call& call, DataManager& dataManager) const {
  const double* x = fields_.modelCoordinates.of(dataManager);
  const double* volume = fields_.volume.of(dataManager);
  const double* cellVolume = fields_.cellVolume.ifIn(dataManager);
  Quantities of{x,
                volume,
                fields_.blockId.of(dataManager),
                {},
                cellVolume == nullptr ? volume : cellVolume,
                fields_.interactionShare.ifIn(dataManager),
                fittedWeights(call, x),
                {}};
  if (family_.rings.areUsed()) {
    of.ofPlane = family_.rings.planeVolumes(x, volume, fields_.volume.length(dataManager));
    of.volume = of.cellVolume = of.ofPlane.data();
  }
  if (interface_ == Interface::Series)
    of.relative = seriesDiffusivities(call, fields_.diffusivity.of(dataManager),
                                      [x](int i, int j) { return ReferenceBond(x, i, j).xi; });
  return of;
}

/// Between blocks each end sees to half of the flux, at both ends. Within a block both find the same flux, and each
/// sees to all of its own; where a layer lies between them, they find what it makes of the bond, and of that each sees
/// to half at both. So fluxes are balanced even if one end does not see all that the other one does.
NonlocalDiffusion::RateConstants NonlocalDiffusion::rateConstants(const Quantities& of, int i, int j,
                                                                  std::size_t bond) const {
  const ReferenceBond geometry(of.x, i, j);
  const double relative = of.relative.empty() ? 1.0 : of.relative[bond];
  if (quadrature_ == Quadrature::Fitted)
    return {relative * microDiffusivity_ * kernels::kernelValue(kernel_, geometry.length) * of.fitted[bond], 0.0};
  const double w = weight(of, geometry, i, j, bond);
  const double own = w * of.volume[j] * family_.ringShare(of.x, i, j, of.volume[i], of.volume[j]);
  if (interface_ == Interface::OwnConstants) return {own, 0.0};
  const double neighbor = w * of.volume[i] * family_.ringShare(of.x, j, i, of.volume[j], of.volume[i]);
  if (of.blockId[i] != of.blockId[j]) return {0.5 * relative * own, 0.5 * relative * neighbor};
  return {0.5 * (1.0 + relative) * own, 0.5 * (relative - 1.0) * neighbor};
}

NonlocalDiffusion::Cache NonlocalDiffusion::makeCache(const Call& call, const Quantities& of) const {
  Cache made;
  made.neighborhood = kernels::ChunkedNeighborhood(call.nOwned, call.ownedIds, call.neighborhoodList);
  made.weights = kernels::BondConstants(made.neighborhood, 1, [&](int i, int j, std::size_t bond, double* values) {
    values[0] = rateConstants(of, i, j, bond).own;
  });
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    if (of.blockId[i] == of.blockId[j] && (of.relative.empty() || of.relative[bond] == 1.0)) return;
    const double neighbor = rateConstants(of, i, j, bond).neighbor;
    if (neighbor != 0.0) made.sharedBonds.push_back({{i, j, bond}, neighbor});
  });
  if (stopsAtBrokenBonds_) made.alive = kernels::AliveBonds(made.neighborhood);
  return made;
}

DamageViews NonlocalDiffusion::cuts(DataManager& dataManager) const {
  return stopsAtBrokenBonds_ ? damageViews(dataManager, fields_.bondDamage, fields_.damage) : DamageViews();
}

void NonlocalDiffusion::computeFluxDivergence(const Call& call, DataManager& dataManager) const {
  const double* concentration = fields_.concentration.of(dataManager);
  double* rate = fields_.rate.of(dataManager);
  const int nPoints = fields_.concentration.length(dataManager);
  std::fill(rate, rate + nPoints, 0.0);

  Cache& cache = caches_.of(call, fields_.modelCoordinates.of(dataManager),
                            [&](const Call& c) { return makeCache(c, quantities(c, dataManager)); });
  const auto [bondDamage, damage] = cuts(dataManager);
  const bool isCut = bondDamage != nullptr;
  if (isCut) cache.alive.refresh(cache.neighborhood, bondDamage, damage);
  cache.concentration.copy(concentration, nPoints);
  kernels::addFluxDivergence(cache.neighborhood, cache.weights, isCut ? &cache.alive : nullptr, cache.concentration[0],
                             rate);
  for (const auto& [ends, rateConstant] : cache.sharedBonds)
    if (!isCut || bondDamage[ends.bond] < 1.0)
      rate[ends.neighbor] += rateConstant * (concentration[ends.point] - concentration[ends.neighbor]);
}

void NonlocalDiffusion::computeJacobian(const Call& call, DataManager& dataManager,
                                        PeridigmNS::SerialMatrix& jacobian) const {
  const double* bondDamage = cuts(dataManager).bondDamage;
  const auto& map = *dataManager.getOverlapScalarPointMap();
  const UnknownPlace place = unknownPlace(fields_.diffusingField);
  if (!place.isUnknown) return;
  const Quantities of = quantities(call, dataManager);
  const double* volume = fields_.volume.of(dataManager);
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    if (bondDamage != nullptr && bondDamage[bond] >= 1.0) return;
    const RateConstants constants = rateConstants(of, i, j, bond);
    const int row = place.row(map.GID(i)), column = place.row(map.GID(j));
    const double own = constants.own * volume[i], neighbor = constants.neighbor * volume[j];
    jacobian.addValue(row, row, -own);
    jacobian.addValue(row, column, own);
    if (neighbor == 0.0) return;
    jacobian.addValue(column, column, -neighbor);
    jacobian.addValue(column, row, neighbor);
  });
}

}  // namespace pd
