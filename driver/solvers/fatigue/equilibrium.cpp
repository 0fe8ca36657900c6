#include "equilibrium.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../../boundary/condition.hpp"
#include "../connected_parts.hpp"
#include "../linear_solver_settings.hpp"
#include "../mechanics.hpp"

namespace pd {

namespace {

NewtonSettings newtonSettings(const Teuchos::ParameterList& parameters, const std::string& solver) {
  NewtonSettings settings;
  settings.maximumIterations = parameters.get<int>("Maximum Solver Iterations");
  settings.relativeTolerance = parameters.get<double>("Relative Tolerance");
  settings.take(LinearSolverSettings(parameters));
  settings.takeKinematics(parameters, solver);
  return settings;
}

}  // namespace

void Equilibrium::declareParameters(ParameterDeclarations& declare) {
  declare.integer("Maximum Solver Iterations", "Newton iterations for one equilibrium.").defaultTo(50).atLeast(1);
  declare
      .real("Relative Tolerance", "1",
            "Norm of the unbalanced force over that of reactions or external forces, the largest so far: no strain is "
            "used before it is that small. What rounding of coordinates makes of the forces is always enough.")
      .defaultTo(1e-6)
      .strictlyBetween(0.0, 1e-2);
  NewtonSettings::declareKinematics(declare);
  declare
      .flag(
          "Tip Window",
          "In Small Strain, for cracks of many events: the stiffness of the body is condensed onto a corridor ahead of "
          "the tip, once and again when the tip has left it, which costs as much as some hundred events; in a window "
          "of the corridor an equilibrium then takes a few milliseconds. All points are found in equilibrium where "
          "fields are written, and every so many events. For plane bodies of Elastic Bond Based, or PDHE with the "
          "Poisson's ratio of such bonds, on one "
          "rank.")
      .defaultTo(false);
  LinearSolverSettings::declareParameters(declare, {"None", "Jacobi", "Block Jacobi", "ILU", "Multigrid", "Two Level"});
}

Equilibrium::Equilibrium(const Teuchos::ParameterList& parameters, std::string solver)
    : solver_(std::move(solver)), newton_(newtonSettings(parameters, solver_)) {
  if (!parameters.get<bool>("Tip Window")) return;
  if (parameters.get<std::string>("Kinematics") != "Small Strain")
    throw std::invalid_argument(solver_ + ": \"Tip Window\" is for \"Kinematics: Small Strain\"");
  window_ = std::make_unique<EventWindow>();
}

void Equilibrium::forgetHistory() {
  newton_.forgetHistory();
  carried_ = 0.0;
  if (window_) window_->forget();
}

void Equilibrium::requireWindow(Simulation& simulation) {
  if (!window_) return;
  newton_.startIncrement(simulation.model);
  window_->start(*newton_.springs());
}

void Equilibrium::findSupports(Simulation& simulation) {
  const HeldInPlace before = std::move(held_);
  held_ = findLooseParts(simulation.model, heldDisplacements(simulation));
  hasSupports_ = true;
  newton_.hold(held_.isHeld);
  if (!held_.hasAny() || held_.sameCounts(before)) return;
  simulation.output.log(fmt::format(
      "{}: {} part(s) of {} points in all that no prescribed displacement keeps from moving as rigid bodies, "
      "and {} point(s) without bonds: held in place",
      solver_, held_.parts.size(), held_.nPointsOfParts(), held_.nPointsWithoutBonds));
}

bool Equilibrium::keepsTogether() {
  newton_.dropTangent();
  isOfTheseBonds_ = false;
  return hasSupports_ && newton_.keepsTogether();
}

int Equilibrium::countLoadedParts(Simulation& simulation, double t) {
  Model& model = simulation.model;
  const ConnectedParts parts = findConnectedParts(model);
  const std::vector<char>& isPrescribed = simulation.conditions.displacementIsPrescribed();
  externalForce(simulation, t, externalForce_);
  std::vector<double> mine(parts.names.size(), 0.0), all(parts.names.size(), 0.0);
  for (std::size_t i = 0; i < parts.partOfPoint.size(); ++i)
    for (std::size_t d = 3 * i; d < 3 * i + 3; ++d)
      if (isPrescribed[d] != 0 || externalForce_[d] != 0.0) mine[static_cast<std::size_t>(parts.partOfPoint[i])] += 1.0;
  model.comm().SumAll(mine.data(), all.data(), static_cast<int>(mine.size()));
  int n = 0;
  for (std::size_t p = 0; p < all.size(); ++p)
    n += all[p] > 0.0 && 100 * parts.sizes[p] >= model.discretization().nGlobal && !parts.isSingle(p) ? 1 : 0;
  return n;
}

std::string Equilibrium::loadsNothingHolds(Simulation& simulation, double t) {
  if (!simulation.conditions.hasExternalForce()) return "";
  externalForce(simulation, t, externalForce_);
  return loadsThatNothingHolds(simulation.model, held_, heldDisplacements(simulation), externalForce_, largestScale_);
}

void Equilibrium::requireHeldLoads(Simulation& simulation, double t) {
  const std::string trouble = loadsNothingHolds(simulation, t);
  if (!trouble.empty())
    throw RunError(fmt::format("{} ({:.6g} cycles): {}; {}", solver_, t, trouble, remedyOfLoadsNothingHolds));
}

void Equilibrium::findFromRest(Simulation& simulation, double t) {
  Model& model = simulation.model;
  double *now = model.field("Displacement"), *atN = model.fieldAtN("Displacement");
  std::fill(now, now + 3LL * model.nPoints(), 0.0);
  std::fill(atN, atN + 3LL * model.nPoints(), 0.0);
  newton_.dropTangent();
  newton_.prepareTangent(simulation, 0.0);
  simulation.conditions.applyPrescribed(t);
  externalForce(simulation, t, externalForce_);
  newton_.followHeldPoints(simulation, 0.0, externalForce_);
  solve(simulation, t);
}

void Equilibrium::find(Simulation& simulation, double t) {
  simulation.conditions.applyPrescribed(t);
  newton_.dropTangent();
  if (window_) {
    externalForce(simulation, t, externalForce_);
    if (window_->find(simulation, *newton_.springs(), externalForce_)) {
      isComplete_ = false;
      isOfTheseBonds_ = true;
      simulation.model.updateCoordinates();
      if (wholeIsDue()) complete(simulation, t);
      return;
    }
  }
  solve(simulation, t);
  if (window_) window_->wholeIsFound(simulation, *newton_.springs(), externalForce_, t);
}

bool Equilibrium::complete(Simulation& simulation, double t) {
  if (isComplete_) return false;
  if (!isOfTheseBonds_) {
    simulation.output.log(solver_ +
                          ": displacements far from the tip are those of some events before the body came apart");
    return false;
  }
  solve(simulation, t);
  simulation.output.stateHasChanged();
  window_->wholeIsFound(simulation, *newton_.springs(), externalForce_, t);
  return true;
}

bool Equilibrium::breaksOutsideWindow(Model& model) const { return !isComplete_ && window_->breaksOutside(model); }

bool Equilibrium::completeForComputes(Simulation& simulation, double t, bool areEvaluated) {
  if (isComplete_) return false;
  Model& model = simulation.model;
  std::vector<char> isRead(static_cast<std::size_t>(model.nPoints()), 0);
  const auto someLookEverywhere = [&] { return !simulation.output.markRead(model, isRead).empty(); };
  if (someLookEverywhere()) return areEvaluated && complete(simulation, t);  // else where they are written
  if (std::find(isRead.begin(), isRead.end(), 1) == isRead.end()) return false;
  if (!areEvaluated) {
    // Where they look may depend on a tip that another of them finds.
    simulation.output.evaluateGlobals(model);
    someLookEverywhere();
  }
  return !window_->has(isRead) && complete(simulation, t);
}

void Equilibrium::solve(Simulation& simulation, double t) {
  externalForce(simulation, t, externalForce_);
  const NewtonOutcome outcome = newton_.solve(simulation, 0.0, externalForce_, largestScale_);
  const double residual = outcome.scale > 0.0 ? outcome.residuals.back() / outcome.scale : outcome.residuals.back();
  if (!outcome.hasConverged)
    throw NoEquilibrium(
        fmt::format("{} ({:.6g} cycles): no equilibrium: {}. Unbalanced force, relative to {:.4g} N of reactions or "
                    "loads: {:.2g}. Allow more iterations (Maximum Solver Iterations), or try another Linear Solver or "
                    "Preconditioner; loose ends and fibres on the lips of a crack, which buckle, are no trouble to "
                    "Kinematics: Small Strain",
                    solver_, t, outcome.trouble, outcome.scale, residual),
        outcome);
  largestScale_ = std::max(largestScale_, outcome.scale);
  largestResidual_ = std::max(largestResidual_, residual);
  carriedBefore_ = carried_;
  carried_ = carriedForce(simulation);
  if (!hasBeenLoaded_ && simulation.conditions.hasExternalForce()) noteFirstLoads(simulation.model, t);
  isComplete_ = isOfTheseBonds_ = true;
  ++nSolutions_;
}

/// A window does not see what the body carries. So that its end is seen, the whole body is found as soon as what breaks
/// has released most of its energy; and the sooner the less it carries, or would carry by then if it went on falling.
bool Equilibrium::wholeIsDue() const {
  constexpr double little = 0.3, most = 0.7;
  if (window_->releasedSinceWhole() > most * workOfReactions_ && workOfReactions_ > 0.0) return true;
  const double fall = std::max(carriedBefore_ - carried_, 0.0);
  return window_->isDue(largestScale_ > 0.0 ? std::clamp((carried_ - fall) / (little * largestScale_), 0.0, 1.0) : 1.0);
}

double Equilibrium::carriedForce(Simulation& simulation) {
  Model& model = simulation.model;
  const double *force = model.field("Force_Density"), *volume = model.field("Volume");
  const double* displacement = model.field("Displacement");
  const std::vector<char>& isPrescribed = simulation.conditions.displacementIsPrescribed();
  std::array<double, 3> mine{}, all{};  // squares of loads and reactions; work of reactions
  for (std::size_t i = 0; i < externalForce_.size(); ++i) {
    mine[0] += std::pow(externalForce_[i] * volume[i / 3], 2);
    if (isPrescribed[i] == 0) continue;
    mine[1] += std::pow(force[i] * volume[i / 3], 2);
    mine[2] -= 0.5 * force[i] * volume[i / 3] * displacement[i];
  }
  model.comm().SumAll(mine.data(), all.data(), 3);
  workOfReactions_ = all[2];
  return std::sqrt(std::max(all[0], all[1]));
}

void Equilibrium::noteFirstLoads(Model& model, double t) {
  hasBeenLoaded_ = model.comm().any(
      std::any_of(externalForce_.begin(), externalForce_.end(), [](double force) { return force != 0.0; }));
  if (!hasBeenLoaded_) return;
  firstLoadedAt_ = t;
  std::copy_n(model.field("Displacement"), externalForce_.size(), model.field(fields_.firstDisplacement));
}

/// Each load by itself: beside a much larger one on another body its own would not be seen.
double Equilibrium::yielded(Simulation& simulation, double t) const {
  if (!hasBeenLoaded_) return 0.0;
  Model& model = simulation.model;
  const double* volume = model.field("Volume");
  const auto compliance = [&](const Condition& load, double time, const double* displacement) {
    std::vector<double> force(externalForce_.size(), 0.0);
    load.addForceDensity(model.discretization(), simulation.conditions.runTime(time), force.data());
    std::array<double, 2> mine{}, all{};  // work, and the square of the force
    for (std::size_t i = 0; i < force.size(); ++i) {
      mine[0] += force[i] * volume[i / 3] * displacement[i];
      mine[1] += std::pow(force[i] * volume[i / 3], 2);
    }
    model.comm().SumAll(mine.data(), all.data(), 2);
    return all[1] > 0.0 ? all[0] / all[1] : 0.0;  // m/N
  };
  double most = 0.0;
  for (const auto& condition : simulation.conditions.all()) {
    if (!condition->isLoad()) continue;
    const double first = compliance(*condition, firstLoadedAt_, model.field(fields_.firstDisplacement));
    if (first > 0.0) most = std::max(most, compliance(*condition, t, model.fieldAtN("Displacement")) / first);
  }
  return most;
}

RestartState Equilibrium::restartState() const {
  RestartState state{{"largest force", largestScale_},
                     {"has been loaded", hasBeenLoaded_ ? 1.0 : 0.0},
                     {"first loaded at", firstLoadedAt_}};
  state.addPart("window", window_ ? window_->restartState() : EventWindow().restartState());
  return state;
}

void Equilibrium::setRestartState(const RestartState& state) {
  largestScale_ = state["largest force"];
  hasBeenLoaded_ = state["has been loaded"] != 0.0;
  firstLoadedAt_ = state["first loaded at"];
  if (window_) window_->setRestartState(state.part("window"));
}

std::vector<std::string> Equilibrium::summary() const {
  std::vector<std::string> lines{fmt::format(
      "{}: {} equilibria with a relative residual of at most {:.2g}, {} Newton iterations, {} tangents, {} "
      "linear iterations",
      solver_, nSolutions_, largestResidual_, newton_.nIterations, newton_.nTangents, newton_.nLinearIterations)};
  if (window_) lines.push_back(window_->summary(solver_));
  if (newton_.stoppedAtRoundOff)
    lines.push_back(solver_ + ": the tolerance was below what rounding of coordinates leaves; the latter was reached");
  return lines;
}

}  // namespace pd
