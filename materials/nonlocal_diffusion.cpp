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
  if (family_.rescalesToLattice)
    microDiffusivity_ = kernels::latticeMicroDiffusivity(
        family_.section, kernel_, diffusivity_, family_.horizon,
        family_.latticeSpacing(call, fields_.volume.of(dataManager), owner_), family_.volumeCorrection);
}

double NonlocalDiffusion::weight(const ReferenceBond& bond, double volume, double neighborVolume) const {
  return microDiffusivity_ * kernels::kernelValue(kernel_, bond.length) *
         family_.share(bond.length, volume, neighborVolume);
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

double NonlocalDiffusion::rateConstant(const double* x, const double* volume, int i, int j,
                                       const std::vector<double>& fitted, std::size_t bond) const {
  const ReferenceBond geometry(x, i, j);
  if (fitted.empty()) return weight(geometry, volume[i], volume[j]) * volume[j];
  return microDiffusivity_ * kernels::kernelValue(kernel_, geometry.length) * fitted[bond];
}

DamageViews NonlocalDiffusion::cuts(DataManager& dataManager) const {
  return stopsAtBrokenBonds_ ? damageViews(dataManager, fields_.bondDamage, fields_.damage) : DamageViews();
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
  const double* x = fields_.modelCoordinates.of(dataManager);
  const double* volume = fields_.volume.of(dataManager);
  const double* concentration = fields_.concentration.of(dataManager);
  double* rate = fields_.rate.of(dataManager);
  const int nPoints = fields_.concentration.length(dataManager);
  std::fill(rate, rate + nPoints, 0.0);

  const double* blockId = fields_.blockId.of(dataManager);
  Cache& cache = caches_.of(call, x, [&](const Call& c) {
    Cache made;
    made.neighborhood = kernels::ChunkedNeighborhood(c.nOwned, c.ownedIds, c.neighborhoodList);
    const std::vector<double> fitted = fittedWeights(c, x);
    made.weights = kernels::BondConstants(made.neighborhood, 1, [&](int i, int j, std::size_t bond, double* values) {
      values[0] = (isShared(blockId, i, j) ? 0.5 : 1.0) * rateConstant(x, volume, i, j, fitted, bond);
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
  const double* x = fields_.modelCoordinates.of(dataManager);
  const double* volume = fields_.volume.of(dataManager);
  const double* bondDamage = cuts(dataManager).bondDamage;
  const double* blockId = fields_.blockId.of(dataManager);
  const auto& map = *dataManager.getOverlapScalarPointMap();
  const UnknownPlace place = unknownPlace(fields_.diffusingField);
  if (!place.isUnknown) return;
  const std::vector<double> fitted = fittedWeights(call, x);
  forEachBond(call, [&](int i, int j, std::size_t bond) {
    if (bondDamage != nullptr && bondDamage[bond] >= 1.0) return;
    const bool isInterface = isShared(blockId, i, j);
    const double w = (isInterface ? 0.5 : 1.0) * rateConstant(x, volume, i, j, fitted, bond) * volume[i];
    const int row = place.row(map.GID(i)), column = place.row(map.GID(j));
    jacobian.addValue(row, row, -w);
    jacobian.addValue(row, column, w);
    if (!isInterface) return;
    jacobian.addValue(column, column, -w);
    jacobian.addValue(column, row, w);
  });
}

}  // namespace pd
