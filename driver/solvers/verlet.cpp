#include "verlet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bulk_modulus_step.hpp"
#include "largest_frequency.hpp"

namespace pd {

void Verlet::declareParameters(ParameterDeclarations& declare) {
  declare.real("Fixed dt", "s", "Time step; without it, the critical one times the safety factor.").positive();
  declare
      .real("Safety Factor", "1",
            "Part of the critical time step that is used where \"Fixed dt\" is not given: 0.85 by default, 1 with "
            "\"Critical Step: Bulk Modulus\", as in Peridigm.")
      .positive();
  declare.flag("Allow Unstable Step", "Run even where the time step is above the critical one.").defaultTo(false);
  declare.real("Damping", "1/s", "Coefficient c of the mass-proportional damping force -c rho v.")
      .defaultTo(0.0)
      .atLeast(0.0);
  declare
      .text("Critical Step",
            "How the critical step is found: from the highest frequency of this very model (the default), or by "
            "Peridigm's formula from the bulk modulus (the default of decks of Peridigm), in which "
            "case \"Safety Factor\" multiplies \"Fixed dt\" too, the steps need not meet the final time, and no step "
            "is refused.")
      .oneOf({"Highest Frequency", "Bulk Modulus"});
}

Verlet::Verlet(const Teuchos::ParameterList& given) {
  const auto parameters = completed<Verlet>(given, "Verlet");
  if (parameters.isParameter("Fixed dt")) fixedStep_ = parameters.get<double>("Fixed dt");
  usesBulkModulus_ =
      parameters.isParameter("Critical Step") && parameters.get<std::string>("Critical Step") == "Bulk Modulus";
  safetyFactor_ = usesBulkModulus_ ? 1.0 : 0.85;
  if (parameters.isParameter("Safety Factor")) safetyFactor_ = parameters.get<double>("Safety Factor");
  allowUnstableStep_ = parameters.get<bool>("Allow Unstable Step");
  damping_ = parameters.get<double>("Damping");
}

RestartState Verlet::restartState() const {
  return {{"steps", static_cast<double>(step_)}, {"critical step", criticalStep_}};
}

void Verlet::setRestartState(const RestartState& state) {
  step_ = static_cast<int>(state["steps"]);
  criticalStep_ = state["critical step"];
  forceIsCurrent_ = false;
  damageIsCurrent_ = true;
}

void Verlet::fieldsHaveChanged() {
  forceIsCurrent_ = false;
  damageIsCurrent_ = true;
}

void Verlet::estimateCriticalStep(Simulation& simulation) {
  if (usesBulkModulus_) {
    criticalStep_ = bulkModulusCriticalStep(simulation.model);
    return;
  }
  const auto density = pointDensity(simulation.model);
  const LargestEigenvalue found =
      largestSquaredFrequency(simulation, density, heldDisplacements(simulation), 2.0e-4, 300);
  const double largest = found.upperBound;
  // Round-off and the probe leave 1e-6. A warning, not an error: what buckles is unstable too.
  if (found.smallestSeen < -1.0e-4 * largest) {
    warning_ = fmt::format(
        "Verlet: warning: the body is unstable as it starts: some motion has a negative stiffness, {:.2g} of the "
        "largest, and grows by itself. Unless it is to buckle, use a smaller Poisson's ratio, where k_t < 0, or "
        "\"Tangential Force: Objective\"",
        found.smallestSeen / largest);
    simulation.output.log(warning_);
  }
  criticalStep_ = largest > 0.0 ? 2.0 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

double Verlet::stepToUse() const {
  if (fixedStep_ > 0.0) return usesBulkModulus_ ? safetyFactor_ * fixedStep_ : fixedStep_;
  return safetyFactor_ * criticalStep_;
}

void Verlet::initialize(Simulation& simulation) {
  requireMechanics(simulation.model, "Verlet");
  estimateCriticalStep(simulation);
  estimatedStep_ = criticalStep_;
  forceIsCurrent_ = false;
  const double step = stepToUse();
  if (!std::isfinite(step))
    throw RunError("Verlet: no point has a stiffness, so that there is no critical time step; give \"Fixed dt\"");
  simulation.output.log(fmt::format("Verlet: critical time step {:.6g} s, used {:.6g} s = {:.4g} of it", criticalStep_,
                                    step, step / criticalStep_));
  if (step <= criticalStep_ || allowUnstableStep_ || usesBulkModulus_) return;
  throw RunError(
      fmt::format("Verlet: the time step {:.6g} s is above the critical one, {:.6g} s (2 / highest frequency "
                  "of the model). Lower \"Fixed dt\" or \"Safety Factor\", leave them out, or set \"Allow "
                  "Unstable Step: true\"",
                  step, criticalStep_));
}

int Verlet::numberOfIncrements(Simulation& simulation, double t0, double t1) {
  // Round-off in a step that divides the time neither adds nor takes one.
  const double n = (t1 - t0) / stepToUse();
  const double whole = usesBulkModulus_ ? std::floor(n * (1.0 + 1.0e-10)) : std::ceil(n * (1.0 - 1.0e-10));
  if (whole > std::numeric_limits<int>::max())
    throw RunError(fmt::format("Verlet: {:.3g} time steps of {:.6g} s lie between {:g} and {:g} s; shorten the run",
                               whole, stepToUse(), t0, t1));
  if (usesBulkModulus_ && whole < 1.0)
    simulation.output.log(fmt::format(
        "Verlet: warning: the time step {:.6g} s is longer than the time from {:g} to {:g} s: as in Peridigm no step "
        "is "
        "made; lower \"Safety Factor\", or leave out \"Critical Step: Bulk Modulus\", by which steps need not meet the "
        "final time",
        stepToUse(), t0, t1));
  return std::max(usesBulkModulus_ ? 0 : 1, static_cast<int>(whole));
}

double Verlet::incrementEnd(int increment, int nIncrements, double t0, double t1) const {
  return usesBulkModulus_ ? t0 + increment * stepToUse() : Solver::incrementEnd(increment, nIncrements, t0, t1);
}

void Verlet::updateMasses(Simulation& simulation) {
  const auto density = pointDensity(simulation.model);
  const auto isHeld = heldDisplacements(simulation);
  inverseDensity_.resize(isHeld.size());
  for (std::size_t i = 0; i < isHeld.size(); ++i) inverseDensity_[i] = isHeld[i] ? 0.0 : 1.0 / density[i / 3];
}

void Verlet::evaluateForce(Simulation& simulation, double t, double dt) {
  Model& model = simulation.model;
  model.updateCoordinates();
  if (model.hasDamage() && !damageIsCurrent_) model.evaluateDamage(dt);
  damageIsCurrent_ = false;
  model.evaluateForce(dt);
  externalForce(simulation, t, externalForce_);
}

void Verlet::advance(Simulation& simulation, double t, double dt) {
  Model& model = simulation.model;
  ++step_;
  usedStep_ = std::max(usedStep_, dt);
  if (!forceIsCurrent_) {
    updateMasses(simulation);
    evaluateForce(simulation, t, dt);
    forceIsCurrent_ = true;
  }
  const std::size_t n = inverseDensity_.size();
  double *displacement = model.field(fields_.displacement), *velocity = model.field(fields_.velocity);
  const double* force = model.field(fields_.force);
  {
    const Timers::Scope timer(model.timers(), "time stepping");
    const double keep = 1.0 - 0.5 * dt * damping_;
    for (std::size_t i = 0; i < n; ++i) {
      if (inverseDensity_[i] > 0.0)
        velocity[i] = keep * velocity[i] + 0.5 * dt * (force[i] + externalForce_[i]) * inverseDensity_[i];
      displacement[i] += dt * velocity[i];
    }
  }
  simulation.conditions.applyPrescribed(t + dt);
  evaluateForce(simulation, t + dt, dt);
  {
    const Timers::Scope timer(model.timers(), "time stepping");
    const double shrink = 1.0 / (1.0 + 0.5 * dt * damping_);
    for (std::size_t i = 0; i < n; ++i)
      if (inverseDensity_[i] > 0.0)
        velocity[i] = shrink * (velocity[i] + 0.5 * dt * (force[i] + externalForce_[i]) * inverseDensity_[i]);
  }
  model.acceptStep(t + dt, dt);
}

std::vector<std::string> Verlet::summary() const {
  std::vector<std::string> lines = {fmt::format(
      "Verlet: {} steps, critical time step {:.6g} s ({}), used {:.6g} s = {:.4g} of it", step_, criticalStep_,
      usesBulkModulus_ ? "from the bulk modulus" : "2 / highest frequency", usedStep_, usedStep_ / criticalStep_)};
  if (!warning_.empty()) lines.push_back(warning_);
  return lines;
}

PD_REGISTER_SOLVER(Verlet, "Verlet", "Explicit dynamics by central differences (velocity Verlet)")

}  // namespace pd
