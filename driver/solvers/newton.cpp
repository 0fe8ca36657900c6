#include "newton.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pd {

namespace {

// A tangent is made anew where it reduces the residual by less than this in one iteration.
constexpr double goodReduction = 0.3;
// Of the unbalanced force that is enough.
constexpr double negligibleError = 1e-2;
// In a row, with products by difference quotients: then the matrix is made after all.
constexpr int mostPoorSteps = 3;

}  // namespace

void Newton::hold(const std::vector<char>& isHeld) {
  if (isHeld != isHeld_) forgetTangent();
  isHeld_ = isHeld;
  if (springs_) springs_->hold(isHeld_);
}

void Newton::forgetTangent() {
  hasTangent_ = false;
  slack_.clear();
}

void Newton::dropTangent() {
  forgetTangent();
  if (springs_) springs_->bondsHaveChanged();
}

void NewtonSettings::take(const LinearSolverSettings& linear) {
  linearSolver = linear.method;
  preconditioner = linear.preconditioner;
  linearTolerance = linear.tolerance;
  maximumLinearIterations = linear.maximumIterations;
  logsLinearSolves = linear.logs;
}

void NewtonSettings::declareKinematics(ParameterDeclarations& declare) {
  declare
      .text("Kinematics",
            "Finite: the forces that materials compute from the present places of the points. Small Strain: those of "
            "the reference configuration, in proportion to the displacements; one linear solve is one equilibrium, "
            "and bonds do not turn. For bodies that strain and turn by a few parts in a thousand, of materials whose "
            "bonds are springs (PDHE, Elastic, Elastic Bond Based).")
      .defaultTo("Finite")
      .oneOf({"Finite", "Small Strain"});
}

void NewtonSettings::takeKinematics(const Teuchos::ParameterList& parameters, const std::string& solver) {
  hasSmallStrain = parameters.get<std::string>("Kinematics") == "Small Strain";
  const bool isTwoLevel = preconditioner == "Two Level";
  const bool isPlain = diagonalScale == 1.0 && diagonalShift == 0.0 && linearSolver == "CG";
  if ((isTwoLevel || hasSmallStrain) && !(isPlain && (isTwoLevel || preconditioner.empty())))
    throw std::invalid_argument(
        solver + (isTwoLevel ? ": \"Preconditioner: Two Level\"" : ": \"Kinematics: Small Strain\"") +
        " is solved by conjugate gradients without a matrix: leave out other linear solvers, preconditioners and the "
        "damping of the diagonal");
}

Newton::Balance Newton::evaluate(Simulation& simulation, double dt, const std::vector<double>& externalForce) {
  Model& model = simulation.model;
  if (settings_.hasSmallStrain) {
    springForce(model);  // which follows from displacements, and moves no point
  } else {
    model.updateCoordinates();
    model.evaluateForce(dt);
  }
  const double *force = model.field(fields_.force), *volume = model.field("Volume");
  const std::vector<char>& isPrescribed = simulation.conditions.displacementIsPrescribed();
  residual_.resize(isHeld_.size());
  // Squares by component: sums that do not wait for each other.
  std::array<double, 3> unbalanced{}, external{}, reaction{};
  for (std::size_t i = 0; i < isHeld_.size(); i += 3)
    for (std::size_t d = 0; d < 3; ++d) {
      const double load = externalForce[i + d] * volume[i / 3], internal = force[i + d] * volume[i / 3];
      const bool isHeld = isHeld_[i + d] != 0;
      residual_[i + d] = isHeld ? 0.0 : internal + load;
      external[d] += isHeld ? 0.0 : load * load;
      reaction[d] += isHeld && isPrescribed[i + d] != 0 ? internal * internal : 0.0;
    }
  leaveOutSlack(externalForce);
  for (std::size_t i = 0; i < residual_.size(); i += 3)
    for (std::size_t d = 0; d < 3; ++d) unbalanced[d] += residual_[i + d] * residual_[i + d];
  const auto sum = [](const std::array<double, 3>& squares) { return squares[0] + squares[1] + squares[2]; };
  std::array<double, 3> mine{sum(unbalanced), sum(external), sum(reaction)};
  std::array<double, 3> all{};
  model.comm().SumAll(mine.data(), all.data(), 3);
  return {std::sqrt(all[0]), std::sqrt(std::max(all[1], all[2]))};
}

/// Where nothing resists a point, and no load acts on it, what bends its line of bonds is not balanced: a fibre in
/// compression would buckle, which a search for equilibrium follows without end.
void Newton::leaveOutSlack(const std::vector<double>& externalForce) {
  for (const SlackDirection& slack : slack_) {
    double load = 0.0, along = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      load += slack.axis[k] * externalForce[3 * slack.point + k];
      along += slack.axis[k] * residual_[3 * slack.point + k];
    }
    if (load != 0.0) continue;
    for (std::size_t k = 0; k < 3; ++k) residual_[3 * slack.point + k] -= along * slack.axis[k];
  }
}

bool Newton::growWithLoads(Simulation& simulation) {
  if (!settings_.hasSmallStrain || simulation.conditions.hasExternalForce()) return false;
  constexpr double rounding = 1e-12;
  Model& model = simulation.model;
  double* displacement = model.field(fields_.displacement);
  const double* start = model.fieldAtN("Displacement");
  double ofStart = 0.0, ofBoth = 0.0, largest = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < isHeld_.size(); ++i) {
    if (!isHeld_[i]) continue;
    ofStart += start[i] * start[i];
    ofBoth += start[i] * displacement[i];
    largest = std::max(largest, std::abs(displacement[i]));
  }
  ofStart = model.comm().sum(ofStart);
  if (ofStart == 0.0) return false;
  const double factor = model.comm().sum(ofBoth) / ofStart;
  for (std::size_t i = 0; i < isHeld_.size(); ++i)
    if (isHeld_[i]) apart = std::max(apart, std::abs(displacement[i] - factor * start[i]));
  if (!(model.comm().max(apart) <= rounding * model.comm().max(largest))) return false;
  for (std::size_t i = 0; i < isHeld_.size(); ++i)
    if (!isHeld_[i]) displacement[i] = factor * start[i];
  return true;
}

void Newton::followHeldPoints(Simulation& simulation, double dt, const std::vector<double>& externalForce) {
  if (growWithLoads(simulation)) return;
  Model& model = simulation.model;
  double* displacement = model.field(fields_.displacement);
  const double* start = model.fieldAtN("Displacement");
  const std::size_t n = isHeld_.size();
  std::vector<double> moved(n);
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    moved[i] = displacement[i] - start[i];
    largest = std::max(largest, std::abs(moved[i]));
  }
  largest = model.comm().max(largest);
  if (largest == 0.0) return;
  // The forces that the held points would cause if the body were linear, by a small part of their motion: strains of
  // 1e-6 keep both nonlinear terms and round-off near 1e-6 of them. Springs are linear.
  const double part = settings_.hasSmallStrain ? 1.0 : 1e-6 * model.discretization().shortestBond / largest;
  std::copy(start, start + n, displacement);
  evaluate(simulation, dt, externalForce);
  const std::vector<double> atStart = residual_;
  for (std::size_t i = 0; i < n; ++i) displacement[i] = start[i] + part * moved[i];
  evaluate(simulation, dt, externalForce);
  for (std::size_t i = 0; i < n; ++i) residual_[i] = atStart[i] + (residual_[i] - atStart[i]) / part;
  const LinearSolveReport report =
      solveLinear(simulation, dt, externalForce, std::clamp(settings_.relativeTolerance, 1e-5, 1e-2));
  const bool isUseful = report.relativeResidual < 0.5;
  for (std::size_t i = 0; i < n; ++i)
    displacement[i] = start[i] + moved[i] + (isUseful && !isHeld_[i] ? step_[i] : 0.0);
}

/// Moves along step_, halved until the residual decreases. Returns the reduction; 1 or more where there is none.
double Newton::search(Simulation& simulation, double dt, const std::vector<double>& externalForce, Balance& balance) {
  double* displacement = simulation.model.field(fields_.displacement);
  const std::vector<double> origin(displacement, displacement + isHeld_.size());
  const double before = balance.free;
  double length = 1.0;
  for (int halving = 0; halving <= 6; ++halving, length *= 0.5) {
    for (std::size_t i = 0; i < isHeld_.size(); ++i)
      if (!isHeld_[i]) displacement[i] = origin[i] + length * step_[i];
    balance = evaluate(simulation, dt, externalForce);
    if (std::isfinite(balance.free) && balance.free < (1.0 - 1e-4 * length) * before) return balance.free / before;
  }
  std::copy(origin.begin(), origin.end(), displacement);
  balance = evaluate(simulation, dt, externalForce);
  return 1.0;
}

NewtonOutcome Newton::solve(Simulation& simulation, double dt, const std::vector<double>& externalForce,
                            double largestScale) {
  NewtonOutcome outcome;
  Balance balance = evaluate(simulation, dt, externalForce);
  bool tangentIsNew = false;
  int nPoorSteps = 0;
  for (int iteration = 0;; ++iteration) {
    outcome.residuals.push_back(balance.free);
    outcome.scale = std::max(balance.scale, largestScale);
    const double asked = std::max(settings_.relativeTolerance * outcome.scale, settings_.absoluteTolerance);
    if (iteration == 0 && balance.free > asked) findFarthest(simulation.model);
    const bool mayGoOn = std::isfinite(balance.free) && iteration < settings_.maximumIterations;
    if (!hasTangent_ && mayGoOn && balance.free > asked) {  // first: what rounding does follows from it
      makeTangent(simulation, dt);
      tangentIsNew = true;
    }
    if (balance.free <= asked || balance.free <= roundOff()) {
      stoppedAtRoundOff = stoppedAtRoundOff || balance.free > asked;
      outcome.hasConverged = true;
      if (settings_.hasSmallStrain) completeSmallStrain(simulation.model, dt);
      return outcome;
    }
    if (!std::isfinite(balance.free)) outcome.trouble = "the force is not finite";
    if (outcome.trouble.empty() && iteration == settings_.maximumIterations) {
      outcome.trouble = "the iterations are used up";
      outcome.iterationsAreUsedUp = true;
    }
    if (!outcome.trouble.empty()) return outcome;

    // Nothing is gained by solving the linear problem better than the load step needs, which in small strain is all
    // that there is to solve.
    const double share = settings_.hasSmallStrain ? 0.9 : 0.3;
    const LinearSolveReport report = solveLinear(
        simulation, dt, externalForce, std::clamp(share * std::max(asked, roundOff()) / balance.free, 1e-12, 0.1));
    if (!report.hasConverged && !(report.relativeResidual < 0.5)) {
      if (improveTangent(Tangent::Assembled)) continue;
      outcome.trouble =
          fmt::format("the linear solver {} ({}) stopped at a relative residual of {:.3g} after {} iterations",
                      report.method, preconditionerName(), report.relativeResidual, report.iterations);
      return outcome;
    }
    forceError_ = negligibleError * asked;
    const double reduction = search(simulation, dt, externalForce, balance);
    ++nIterations;
    learn(reduction, report.relativeResidual);
    const bool isUseless = reduction >= 1.0 && tangentIsNew;
    tangentIsNew = false;
    nPoorSteps = reduction > goodReduction && tangent_ == Tangent::Differences ? nPoorSteps + 1 : 0;
    const bool needsMatrix = isUseless || nPoorSteps == mostPoorSteps;
    if (reduction > goodReduction && !improveTangent(needsMatrix ? Tangent::Assembled : Tangent::Differences)) {
      if (isUseless) {
        outcome.trouble = "no step along Newton's direction brings the forces nearer to balance";
        return outcome;
      }
      hasTangent_ = false;
    }
  }
}

}  // namespace pd
