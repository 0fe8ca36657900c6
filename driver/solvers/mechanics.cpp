#include "mechanics.hpp"

#include <algorithm>

#include "../model/rates.hpp"

namespace pd {

using namespace PeridigmNS;

std::vector<char> heldDisplacements(const Simulation& simulation) {
  const std::vector<char>& prescribed = simulation.conditions.displacementIsPrescribed();
  const int dimension = simulation.model.discretization().dimension;
  std::vector<char> isHeld(prescribed.begin(), prescribed.begin() + 3LL * simulation.model.nOwned());
  for (std::size_t i = 0; i < isHeld.size(); ++i)
    if (static_cast<int>(i % 3) >= dimension) isHeld[i] = 1;
  return isHeld;
}

std::vector<double> pointDensity(Model& model) {
  std::vector<double> density(static_cast<std::size_t>(model.nOwned()), 0.0);
  for (Block& block : *model.blocks()) {
    const double value = block.getMaterialModel()->Density();
    if (!(value > 0.0)) throw RunError("block \"" + block.getName() + "\": its material has no positive mass density");
    const auto points = block.getNeighborhoodData();
    for (int k = 0; k < points->NumOwnedPoints(); ++k) density[static_cast<std::size_t>(points->OwnedIDs()[k])] = value;
  }
  return density;
}

void requireMechanics(const Model& model, const char* solver) {
  const auto& blocks = *model.blocks();
  if (std::none_of(blocks.begin(), blocks.end(), [](Block block) { return computesForces(block); }))
    throw RunError(std::string(solver) + ": no material of this run computes forces");
}

void externalForce(const Simulation& simulation, double t, std::vector<double>& force) {
  const std::size_t n = 3 * static_cast<std::size_t>(simulation.model.nOwned());
  const bool hasForce = simulation.conditions.hasExternalForce();
  if (hasForce || force.size() != n) force.assign(n, 0.0);
  if (hasForce) simulation.conditions.addExternalForce(t, force.data());
}

}  // namespace pd
