#include "quasi_static.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "linear_solver_settings.hpp"
#include "mechanics.hpp"

namespace pd {

namespace {

NewtonSettings newtonSettings(const Teuchos::ParameterList& parameters) {
  NewtonSettings settings;
  settings.maximumIterations = parameters.get<int>("Maximum Solver Iterations");
  const bool hasAbsolute = parameters.isParameter("Absolute Tolerance");
  if (hasAbsolute) settings.absoluteTolerance = parameters.get<double>("Absolute Tolerance");
  if (parameters.isParameter("Relative Tolerance"))
    settings.relativeTolerance = parameters.get<double>("Relative Tolerance");
  else if (hasAbsolute)
    settings.relativeTolerance = 0.0;
  settings.take(LinearSolverSettings(parameters));
  settings.diagonalScale = parameters.get<double>("Damped Newton Diagonal Scale Factor");
  settings.diagonalShift = parameters.get<double>("Damped Newton Diagonal Shift Factor");
  settings.takeKinematics(parameters, "QuasiStatic");
  return settings;
}

}  // namespace

void QuasiStatic::declareParameters(ParameterDeclarations& declare) {
  LoadSteps::declareParameters(declare);
  declare.integer("Maximum Solver Iterations", "Newton iterations for one equilibrium.").defaultTo(50).atLeast(1);
  declare
      .real("Relative Tolerance", "1",
            "Norm of the unbalanced force over that of reactions or external forces, the largest so far. 1e-6 where no "
            "tolerance is given. What rounding of coordinates makes of the forces is always enough.")
      .strictlyBetween(0.0, 1.0);
  declare.real("Absolute Tolerance", "N", "Norm of the unbalanced force that is enough.").positive();
  NewtonSettings::declareKinematics(declare);
  LinearSolverSettings::declareParameters(declare, {"None", "Jacobi", "Block Jacobi", "ILU", "Multigrid", "Two Level"});
  declare
      .real("Damped Newton Diagonal Scale Factor", "1",
            "The diagonal of the tangent is multiplied by this: shorter, safer Newton steps.")
      .defaultTo(1.0)
      .positive();
  declare
      .real("Damped Newton Diagonal Shift Factor", "1",
            "This part of its largest entry is added to the diagonal of the tangent.")
      .defaultTo(0.0)
      .atLeast(0.0);
  declare
      .flag("Velocity From Increments",
            "After a load step the Velocity of each point is its displacement over the length of the step: for output, "
            "and for a solver that follows (true in decks of Peridigm).")
      .defaultTo(false);
  declare
      .integer("Maximum Load Step Reductions",
               "How often a load step without equilibrium is halved, as long as no bond has broken in it.")
      .defaultTo(5)
      .atLeast(0);
  declare
      .integer("Maximum Breakage Passes",
               "Equilibria in one load step after bonds broke: a crack that runs needs many. All bonds that exceed "
               "their limit in an equilibrium break together.")
      .defaultTo(1000)
      .atLeast(1);
}

QuasiStatic::QuasiStatic(const Teuchos::ParameterList& given)
    : parameters_(completed<QuasiStatic>(given, "QuasiStatic")),
      fields_(parameters_),
      loadSteps_(parameters_, "QuasiStatic"),
      maximumBreakagePasses_(parameters_.get<int>("Maximum Breakage Passes")),
      maximumHalvings_(parameters_.get<int>("Maximum Load Step Reductions")),
      newton_(newtonSettings(parameters_)) {}

void QuasiStatic::initialize(Simulation& simulation) {
  requireMechanics(simulation.model, "QuasiStatic");
  newton_.requireSprings(simulation.model);
}

void QuasiStatic::rehearse(Simulation& simulation, double t, double dt) {
  findLooseParts(simulation);
  externalForce(simulation, t + dt, externalForce_);
  requireHeldLoads(simulation, t + dt);
}

int QuasiStatic::numberOfIncrements(Simulation&, double t0, double t1) { return loadSteps_.count(t0, t1); }

double QuasiStatic::incrementEnd(int increment, int nIncrements, double t0, double t1) const {
  return loadSteps_.end(increment, nIncrements, t0, t1);
}

void QuasiStatic::findLooseParts(Simulation& simulation) {
  const HeldInPlace before = std::move(held_);
  held_ = pd::findLooseParts(simulation.model, heldDisplacements(simulation));
  hasLookedForParts_ = true;
  newton_.hold(held_.isHeld);
  if (held_.sameCounts(before)) return;
  simulation.output.log(fmt::format(
      "QuasiStatic: load step {}: {} part(s) of {} points in all that no prescribed displacement keeps from moving as "
      "rigid bodies, and {} point(s) without bonds: held in place",
      loadStep_, held_.parts.size(), held_.nPointsOfParts(), held_.nPointsWithoutBonds));
}

void QuasiStatic::requireHeldLoads(Simulation& simulation, double t) const {
  if (!simulation.conditions.hasExternalForce()) return;
  const std::string trouble =
      loadsThatNothingHolds(simulation.model, held_, heldDisplacements(simulation), externalForce_, largestScale_);
  if (!trouble.empty())
    throw RunError(fmt::format("QuasiStatic: load step {} (t = {:.6g} s): {}; {}", loadStep_, t, trouble,
                               remedyOfLoadsNothingHolds));
}

void QuasiStatic::takeUpBreakage(Simulation& simulation) {
  const double bondDamage = simulation.model.hasDamage() ? bondDamageSum_.of(simulation.model) : 0.0;
  const bool hasBroken = looksForBreakage_ && bondDamage > bondDamage_ * (1.0 + 1e-12);
  bondDamage_ = bondDamage;
  if (hasBroken) {
    newton_.dropTangent();
    mustRestoreTangent_ = false;
    lastLength_ = 0.0;
  }
  if (!hasLookedForParts_ || hasBroken) findLooseParts(simulation);
}

void QuasiStatic::extrapolate(Simulation& simulation, double dt) {
  double* displacement = simulation.model.field(fields_.displacement);
  const double* increment = simulation.model.field(fields_.increment);
  for (std::size_t i = 0; i < held_.isHeld.size(); ++i)
    if (!held_.isHeld[i]) displacement[i] += increment[i] * (dt / lastLength_);
}

bool QuasiStatic::reachEquilibrium(Simulation& simulation, double dt) {
  outcome_ = newton_.solve(simulation, dt, externalForce_, largestScale_);
  if (!outcome_.hasConverged) return false;
  largestScale_ = std::max(largestScale_, outcome_.scale);
  return true;
}

void QuasiStatic::breakBonds(Simulation& simulation, double t, double dt) {
  Model& model = simulation.model;
  if (!model.hasDamage()) return;
  double before = bondDamage_;
  for (int pass = 0;; ++pass) {
    model.evaluateDamage(dt);
    const double after = bondDamageSum_.of(model);
    if (!(after > before * (1.0 + 1e-12))) {
      bondDamage_ = after;
      mostPasses_ = std::max<long long>(mostPasses_, pass);
      return;
    }
    if (pass == maximumBreakagePasses_)
      throw RunError(fmt::format(
          "QuasiStatic: load step {} (t = {:.6g} s): bonds still break after {} equilibria. Take smaller load steps, "
          "allow more (Maximum Breakage Passes), or use Verlet: a crack that runs by itself is not quasi-static",
          loadStep_, t + dt, pass));
    before = after;
    lastLength_ = 0.0;
    ++nPasses_;
    newton_.dropTangent();
    if (!newton_.keepsTogether()) {
      findLooseParts(simulation);
      requireHeldLoads(simulation, t + dt);
    }
    if (!reachEquilibrium(simulation, dt)) fail(t + dt, " after bonds broke");
  }
}

void QuasiStatic::advanceInParts(Simulation& simulation, double t, double dt, int nHalvings) {
  Model& model = simulation.model;
  simulation.beginStep();
  const auto load = [&] {
    simulation.conditions.applyPrescribed(t + dt);
    externalForce(simulation, t + dt, externalForce_);
    requireHeldLoads(simulation, t + dt);
  };
  const auto goBack = [&] {
    simulation.takeBackStep();
    newton_.dropTangent();
    newton_.prepareTangent(simulation, dt);
    lastLength_ = 0.0;
  };
  bool isThere = false;
  if (lastLength_ > 0.0) {
    extrapolate(simulation, dt);
    load();
    isThere = reachEquilibrium(simulation, dt);
    if (!isThere) goBack();
  }
  if (!isThere) {
    load();
    newton_.followHeldPoints(simulation, dt, externalForce_);
    isThere = reachEquilibrium(simulation, dt);
  }
  if (!isThere) {
    if (nHalvings == maximumHalvings_) fail(t + dt, nHalvings > 0 ? ", however short the load step" : "");
    goBack();
    ++nHalvings_;
    advanceInParts(simulation, t, 0.5 * dt, nHalvings + 1);
    advanceInParts(simulation, t + 0.5 * dt, 0.5 * dt, nHalvings + 1);
    return;
  }
  const double *displacement = model.field(fields_.displacement), *start = model.fieldAtN("Displacement");
  double* increment = model.field(fields_.increment);
  for (std::size_t i = 0; i < held_.isHeld.size(); ++i) increment[i] = displacement[i] - start[i];
  lastLength_ = dt;
  breakBonds(simulation, t, dt);
  newton_.watchBondMotion(model);
  model.acceptStep(t + dt, dt);
}

void QuasiStatic::advance(Simulation& simulation, double t, double dt) {
  ++loadStep_;
  simulation.model.fieldAtN("Displacement");  // kept from now on: where each part of the load step starts
  takeUpBreakage(simulation);
  newton_.startIncrement(simulation.model);
  if (mustRestoreTangent_) newton_.restoreTangent(simulation, dt);
  mustRestoreTangent_ = false;
  newton_.prepareTangent(simulation, dt);
  const double* displacement = simulation.model.field(fields_.displacement);
  std::vector<double> start;
  if (fields_.velocity.isUsed()) start.assign(displacement, displacement + held_.isHeld.size());
  advanceInParts(simulation, t, dt, 0);
  if (fields_.velocity.isUsed()) {
    double* velocity = simulation.model.field(fields_.velocity);
    for (std::size_t i = 0; i < start.size(); ++i) velocity[i] = (displacement[i] - start[i]) / dt;
  }
  simulation.model.requireFinite("Displacement", loadStep_);
}

void QuasiStatic::fail(double t, const std::string& when) const {
  std::string residuals;
  for (const double residual : outcome_.residuals)
    residuals += fmt::format("{}{:.2g}", residuals.empty() ? "" : ", ",
                             outcome_.scale > 0.0 ? residual / outcome_.scale : residual);
  throw RunError(fmt::format(
      "QuasiStatic: load step {} (t = {:.6g} s): no equilibrium{}: {}. Unbalanced force, relative to {:.4g} "
      "N of reactions or loads: {}. Take smaller load steps (Load Steps), allow more iterations (Maximum "
      "Solver Iterations), or try another Linear Solver or Preconditioner",
      loadStep_, t, when, outcome_.trouble, outcome_.scale, residuals));
}

RestartState QuasiStatic::restartState() const {
  return {{"load steps", static_cast<double>(loadStep_)},
          {"largest force", largestScale_},
          {"length of the last load step", lastLength_},
          {"has a tangent", newton_.hasTangent() ? 1.0 : 0.0},
          {"bond damage", bondDamage_},
          {"further equilibria", static_cast<double>(nPasses_)},
          {"most of them in a load step", static_cast<double>(mostPasses_)},
          {"halved load steps", static_cast<double>(nHalvings_)}};
}

void QuasiStatic::setRestartState(const RestartState& state) {
  loadStep_ = static_cast<int>(state["load steps"]);
  largestScale_ = state["largest force"];
  lastLength_ = state["length of the last load step"];
  mustRestoreTangent_ = state["has a tangent"] != 0.0;
  bondDamage_ = state["bond damage"];
  nPasses_ = static_cast<long long>(state["further equilibria"]);
  mostPasses_ = static_cast<long long>(state["most of them in a load step"]);
  nHalvings_ = static_cast<long long>(state["halved load steps"]);
}

std::vector<std::string> QuasiStatic::summary() const {
  std::vector<std::string> lines = {fmt::format(
      "QuasiStatic: {} load steps, {} Newton iterations, {} tangents{}, {} linear iterations (largest relative "
      "residual of a linear solve {:.3g})",
      loadStep_, newton_.nIterations, newton_.nTangents, newton_.couplesFamilies() ? " (coupling whole families)" : "",
      newton_.nLinearIterations, newton_.largestLinearResidual)};
  lines.push_back(
      fmt::format("QuasiStatic: {} further equilibria after bonds broke (at most {} in a load step), {} "
                  "load steps halved",
                  nPasses_, mostPasses_, nHalvings_));
  if (newton_.nGmresFallbacks > 0)
    lines.push_back(
        fmt::format("QuasiStatic: {} linear solves went on with GMRES: the tangent was not positive definite",
                    newton_.nGmresFallbacks));
  if (newton_.stoppedAtRoundOff)
    lines.push_back("QuasiStatic: the tolerance was below what rounding of coordinates leaves; the latter was reached");
  for (const std::string& warning : newton_.warnings()) lines.push_back("QuasiStatic: " + warning);
  return lines;
}

PD_REGISTER_SOLVER(QuasiStatic, "QuasiStatic", "Static equilibrium by Newton's method, bonds breaking in between")

}  // namespace pd
