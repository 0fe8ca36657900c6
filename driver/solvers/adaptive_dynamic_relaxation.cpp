#include "adaptive_dynamic_relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "absolute_row_sums.hpp"
#include "damage_watch.hpp"
#include "loose_parts.hpp"

namespace pd {

void AdaptiveDynamicRelaxation::declareParameters(ParameterDeclarations& declare) {
  declare.integer("Load Steps", "Increments of the run: what output counts.").defaultTo(1).atLeast(1);
  declare
      .integer("Iterations Per Load Step",
               "Relaxation steps a load step, whatever the residual; velocities go on from one load step to the next.")
      .atLeast(1);
  declare
      .real("Relative Tolerance", "1",
            "Norm of the unbalanced force over that of reactions and external forces (the largest so far) at which a "
            "load step is in equilibrium. 1e-5 where no number of iterations is given either.")
      .strictlyBetween(0.0, 1.0);
  declare.atMostOneOf({"Iterations Per Load Step", "Relative Tolerance"});
  declare.integer("Maximum Iterations", "Relaxation steps a load step may take to meet its tolerance.")
      .defaultTo(100000)
      .atLeast(1);
}

AdaptiveDynamicRelaxation::AdaptiveDynamicRelaxation(const Teuchos::ParameterList& given) {
  const auto parameters = completed<AdaptiveDynamicRelaxation>(given, "Adaptive Dynamic Relaxation");
  nIncrements_ = parameters.get<int>("Load Steps");
  if (parameters.isParameter("Iterations Per Load Step"))
    iterationsPerLoadStep_ = parameters.get<int>("Iterations Per Load Step");
  relativeTolerance_ =
      parameters.isParameter("Relative Tolerance") ? parameters.get<double>("Relative Tolerance") : 1.0e-5;
  maximumIterations_ = parameters.get<int>("Maximum Iterations");
}

void AdaptiveDynamicRelaxation::initialize(Simulation& simulation) {
  requireMechanics(simulation.model, "Adaptive Dynamic Relaxation");
}

void AdaptiveDynamicRelaxation::rehearse(Simulation& simulation, double t, double dt) {
  externalForce(simulation, t + dt, externalForce_);
  requireHeldLoads(simulation, t + dt);
}

RestartState AdaptiveDynamicRelaxation::restartState() const {
  return {{"has masses", hasMasses_ ? 1.0 : 0.0},
          {"is moving", isMoving_ ? 1.0 : 0.0},
          {"largest force", largestScale_},
          {"load steps", static_cast<double>(loadStep_)},
          {"rounds after bonds broke", static_cast<double>(nBreakingRounds_)}};
}

void AdaptiveDynamicRelaxation::setRestartState(const RestartState& state) {
  hasMasses_ = state["has masses"] != 0.0;
  isMoving_ = state["is moving"] != 0.0;
  largestScale_ = state["largest force"];
  loadStep_ = static_cast<int>(state["load steps"]);
  nBreakingRounds_ = static_cast<long long>(state["rounds after bonds broke"]);
}

void AdaptiveDynamicRelaxation::prepareMasses(Simulation& simulation) {
  Model& model = simulation.model;
  const auto n = static_cast<std::size_t>(model.nOwned());
  double* mass = model.field(fields_.mass);
  if (!hasMasses_) {
    // Breaking bonds only lowers the row sums: one estimate keeps the pseudo time step of one stable for the whole run.
    AbsoluteRowSums rowSums(model);
    model.assembleJacobian(0.0, rowSums);
    const std::vector<double> sums = rowSums.ownedSums();
    const double* volume = model.field("Volume");
    // 1.1: Underwood's margin on the frequency. The largest component's sum serves all three, so that the bound
    // survives rotations.
    for (std::size_t i = 0; i < n; ++i)
      mass[i] = 0.25 * 1.1 * 1.1 * std::max({sums[3 * i], sums[3 * i + 1], sums[3 * i + 2]}) / volume[i];
    hasMasses_ = true;
  }
  const auto isHeld = heldDisplacements(simulation);
  const auto& isPrescribed = simulation.conditions.displacementIsPrescribed();
  inverseMass_.assign(3 * n, 0.0);
  prescribed_.clear();
  for (std::size_t i = 0; i < 3 * n; ++i) {
    if (!isHeld[i] && mass[i / 3] > 0.0) inverseMass_[i] = 1.0 / mass[i / 3];
    if (isPrescribed[i]) prescribed_.push_back(static_cast<int>(i));
  }
}

void AdaptiveDynamicRelaxation::evaluateForce(Simulation& simulation, double dt, bool breakBonds) {
  if (breakBonds) simulation.model.evaluateDamage(dt);
  simulation.model.evaluateForce(dt);
}

AdaptiveDynamicRelaxation::Norms AdaptiveDynamicRelaxation::measure(Simulation& simulation) const {
  Model& model = simulation.model;
  const Timers::Scope timer(model.timers(), "relaxation update");
  const double *force = model.field(fields_.force), *volume = model.field("Volume");
  const double *velocity = model.field(fields_.velocity), *before = model.field(fields_.acceleration);
  double free = 0.0, external = 0.0, reaction = 0.0, stiffness = 0.0, kinetic = 0.0;
  const std::size_t n = inverseMass_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!(inverseMass_[i] > 0.0)) continue;
    const double total = (force[i] + externalForce_[i]) * volume[i / 3], applied = externalForce_[i] * volume[i / 3];
    free += total * total;
    external += applied * applied;
    const double momentum = velocity[i] * volume[i / 3] / inverseMass_[i];
    kinetic += velocity[i] * momentum;
    stiffness -= momentum * ((force[i] + externalForce_[i]) * inverseMass_[i] - before[i]);
  }
  for (const int entry : prescribed_) {
    const double total = force[entry] * volume[entry / 3];
    reaction += total * total;
  }
  std::array<double, 5> mine = {free, external, reaction, stiffness, kinetic}, all = {};
  model.comm().SumAll(mine.data(), all.data(), 5);
  Norms norms;
  norms.free = std::sqrt(all[0]);
  norms.scale = std::sqrt(std::max(all[1], all[2]));
  if (all[3] > 0.0 && all[4] > 0.0) norms.damping = std::min(1.9, 2.0 * std::sqrt(all[3] / all[4]));
  return norms;
}

void AdaptiveDynamicRelaxation::move(Simulation& simulation, double damping) {
  Model& model = simulation.model;
  const Timers::Scope timer(model.timers(), "relaxation update");
  const double* force = model.field(fields_.force);
  double *displacement = model.field(fields_.displacement), *velocity = model.field(fields_.velocity);
  double* before = model.field(fields_.acceleration);
  // The first step of a motion starts from rest at half a step.
  const double keep = isMoving_ ? (2.0 - damping) / (2.0 + damping) : 0.0;
  const double push = isMoving_ ? 2.0 / (2.0 + damping) : 0.5;
  const std::size_t n = inverseMass_.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double acceleration = (force[i] + externalForce_[i]) * inverseMass_[i];
    const double speed = keep * velocity[i] + push * acceleration;
    velocity[i] = speed;
    before[i] = acceleration;
    displacement[i] += speed;
  }
  isMoving_ = true;
}

double AdaptiveDynamicRelaxation::residual(const Norms& norms) {
  // The largest scale so far, so that a body that has broken apart and carries nothing any more can come to rest.
  largestScale_ = std::max(largestScale_, norms.scale);
  if (norms.free == 0.0) return 0.0;
  return largestScale_ > 0.0 ? norms.free / largestScale_ : 1.0;
}

void AdaptiveDynamicRelaxation::iterateFixed(Simulation& simulation, double dt) {
  const bool breakBonds = simulation.model.hasDamage();
  for (int k = 0; k < iterationsPerLoadStep_; ++k) {
    evaluateForce(simulation, dt, breakBonds);
    const Norms norms = measure(simulation);
    lastResidual_ = residual(norms);
    move(simulation, norms.damping);
    simulation.model.updateCoordinates();
  }
  nIterations_ += iterationsPerLoadStep_;
}

int AdaptiveDynamicRelaxation::relax(Simulation& simulation, double t, double dt, int nAllowed) {
  Model& model = simulation.model;
  double* velocity = model.field(fields_.velocity);
  std::fill(velocity, velocity + inverseMass_.size(), 0.0);
  isMoving_ = false;
  for (int k = 0;; ++k) {
    evaluateForce(simulation, dt, false);
    const Norms norms = measure(simulation);
    lastResidual_ = residual(norms);
    if (lastResidual_ <= relativeTolerance_) return k;
    if (!std::isfinite(norms.free)) model.requireFinite("Force_Density", loadStep_);
    if (k == nAllowed)
      throw RunError(fmt::format(
          "Adaptive Dynamic Relaxation: load step {} (t = {:.6g} s) is not in equilibrium after {} iterations: "
          "relative "
          "residual {:.3g}, asked for {:.3g}. Take smaller load steps, allow more iterations (\"Maximum Iterations\"), "
          "or look for parts that nothing holds",
          loadStep_, t + dt, maximumIterations_, lastResidual_, relativeTolerance_));
    move(simulation, norms.damping);
    model.updateCoordinates();
  }
}

void AdaptiveDynamicRelaxation::iterateToTolerance(Simulation& simulation, double t, double dt) {
  Model& model = simulation.model;
  const bool hasDamage = model.hasDamage();
  DamageMonitor damage;
  if (hasDamage) damage.remember(model);
  int nIterations = 0;
  do {
    nIterations += relax(simulation, t, dt, maximumIterations_ - nIterations);
    if (!hasDamage) break;
    model.evaluateDamage(dt);
  } while (damage.countChanged(model) > 0 && ++nBreakingRounds_ > 0);
  nIterations_ += nIterations;
}

/// Statics has no solution where a load acts on what nothing holds. Looked for once, before bonds break.
void AdaptiveDynamicRelaxation::requireHeldLoads(Simulation& simulation, double t) const {
  if (!simulation.conditions.hasExternalForce()) return;
  const std::vector<char> isHeld = heldDisplacements(simulation);
  const std::string trouble = loadsThatNothingHolds(simulation.model, findLooseParts(simulation.model, isHeld), isHeld,
                                                    externalForce_, largestScale_);
  if (!trouble.empty())
    throw RunError(fmt::format("Adaptive Dynamic Relaxation: load step {} (t = {:.6g} s): {}", loadStep_, t, trouble));
}

void AdaptiveDynamicRelaxation::advance(Simulation& simulation, double t, double dt) {
  ++loadStep_;
  simulation.conditions.applyPrescribed(t + dt);
  simulation.model.updateCoordinates();
  externalForce(simulation, t + dt, externalForce_);
  if (inverseMass_.empty()) {
    requireHeldLoads(simulation, t + dt);
    prepareMasses(simulation);
  }
  if (iterationsPerLoadStep_ > 0)
    iterateFixed(simulation, dt);
  else
    iterateToTolerance(simulation, t, dt);
  largestResidual_ = std::max(largestResidual_, lastResidual_);
  simulation.model.acceptStep(t + dt, dt);
}

std::vector<std::string> AdaptiveDynamicRelaxation::summary() const {
  const std::string aim = iterationsPerLoadStep_ > 0
                              ? fmt::format("{} a load step, whatever the residual", iterationsPerLoadStep_)
                              : fmt::format("to a relative residual of {:.3g}", relativeTolerance_);
  return {
      fmt::format("Adaptive Dynamic Relaxation: {} load steps, {} iterations ({}), {} further rounds after bonds "
                  "broke; relative residual at the end {:.3g}, largest of a load step {:.3g}",
                  loadStep_, nIterations_, aim, nBreakingRounds_, lastResidual_, largestResidual_)};
}

PD_REGISTER_SOLVER(AdaptiveDynamicRelaxation, "Adaptive Dynamic Relaxation",
                   "Static equilibrium by damped pseudo-dynamics (Underwood; Kilic & Madenci)")

}  // namespace pd
