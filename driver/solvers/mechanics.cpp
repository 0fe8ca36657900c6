#include "mechanics.hpp"

#include <algorithm>
#include <cmath>

#include "Peridigm_Field.hpp"

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

std::vector<int> mechanicsFieldIds(bool withVelocity) {
  using namespace PeridigmField;
  auto& fields = FieldManager::self();
  std::vector<int> ids;
  for (const char* label : {"Displacement", "Coordinates", "Force_Density"})
    ids.push_back(fields.getFieldId(NODE, VECTOR, TWO_STEP, label));
  if (withVelocity) ids.push_back(fields.getFieldId(NODE, VECTOR, TWO_STEP, "Velocity"));
  return ids;
}

void requireMechanics(const Model& model, const char* solver) {
  const int force = FieldManager::self().getFieldId("Force_Density");
  const auto& blocks = *model.blocks();
  const bool hasForce = std::any_of(blocks.begin(), blocks.end(), [&](Block block) {
    const auto ids = block.getMaterialModel()->FieldIds();
    return std::find(ids.begin(), ids.end(), force) != ids.end();
  });
  if (!hasForce) throw RunError(std::string(solver) + ": no material of this run computes forces");
}

void externalForce(const Simulation& simulation, double t, std::vector<double>& force) {
  const std::size_t n = 3 * static_cast<std::size_t>(simulation.model.nOwned());
  const bool hasForce = simulation.conditions.hasExternalForce();
  if (hasForce || force.size() != n) force.assign(n, 0.0);
  if (hasForce) simulation.conditions.addExternalForce(t, force.data());
}

void DamageMonitor::remember(Model& model) {
  const double* damage = model.field("Damage");
  damage_.assign(damage, damage + model.nOwned());
}

long long DamageMonitor::countChanged(Model& model) {
  const double* damage = model.field("Damage");
  long long nChanged = 0;
  for (std::size_t i = 0; i < damage_.size(); ++i) nChanged += damage[i] != damage_[i] ? 1 : 0;
  remember(model);
  return model.comm().sum(nChanged);
}

LargestEigenvalue largestSquaredFrequency(Simulation& simulation, const std::vector<double>& density,
                                          const std::vector<char>& isHeld, double relativeTolerance,
                                          int maximumIterations) {
  Model& model = simulation.model;
  const int n = 3 * model.nOwned();
  double* displacement = model.field("Displacement");
  const double* force = model.field("Force_Density");
  const double* volume = model.field("Volume");
  const std::vector<double> origin(displacement, displacement + n);
  const auto evaluate = [&] {
    model.updateCoordinates();
    model.evaluateForce(0.0);
  };
  evaluate();
  const std::vector<double> forceAtOrigin(force, force + n);
  // Strains of 1e-6: nonlinear terms and round-off both stay near 1e-6 of the tangent.
  const double probe = 1.0e-6 * model.discretization().shortestBond;
  const auto isFree = [&](int i) { return isHeld[static_cast<std::size_t>(i)] == 0; };

  SelfAdjointOperator op;
  op.dot = [&](const double* a, const double* b) {
    double sum = 0.0;
    for (int i = 0; i < n; ++i) sum += density[static_cast<std::size_t>(i / 3)] * volume[i / 3] * a[i] * b[i];
    return model.comm().sum(sum);
  };
  op.apply = [&](const double* direction, double* image) {
    double length = 0.0;
    for (int i = 0; i < n; ++i) length = std::max(length, std::abs(direction[i]));
    const double step = probe / model.comm().max(length);
    for (int i = 0; i < n; ++i) displacement[i] = origin[static_cast<std::size_t>(i)] + step * direction[i];
    evaluate();
    for (int i = 0; i < n; ++i)
      image[i] = isFree(i) ? (forceAtOrigin[static_cast<std::size_t>(i)] - force[i]) /
                                 (step * density[static_cast<std::size_t>(i / 3)])
                           : 0.0;
  };
  std::vector<double> start = randomPointValues(model.discretization().globalIds, model.nOwned(), 3);
  for (int i = 0; i < n; ++i)
    if (!isFree(i)) start[static_cast<std::size_t>(i)] = 0.0;
  const LargestEigenvalue result = largestEigenvalue(op, std::move(start), relativeTolerance, maximumIterations);

  std::copy(origin.begin(), origin.end(), displacement);
  model.updateCoordinates();
  return result;
}

}  // namespace pd
