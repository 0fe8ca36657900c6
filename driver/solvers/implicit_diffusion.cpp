#include "implicit_diffusion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "diffusion/scalar_unknown.hpp"
#include "field_names.hpp"

namespace pd {

void ImplicitDiffusion::declareParameters(ParameterDeclarations& declare) {
  declare.text("Field", "The scalar point field whose steady state is wanted.").defaultTo("Temperature");
  LoadSteps::declareParameters(declare);
  declare.integer("Maximum Solver Iterations", "Newton iterations for one steady state.").defaultTo(10).atLeast(1);
  declare
      .real("Relative Tolerance", "1",
            "Norm of what flows into free points over that of what flows into prescribed ones. 1e-6 where no tolerance "
            "is given. What rounding makes of the flux is always enough.")
      .strictlyBetween(0.0, 1.0);
  declare.real("Absolute Tolerance", "unit of the field x m3/s", "Norm of what flows into free points that is enough.")
      .positive();
  LinearSolverSettings::declareParameters(declare, {"None", "Jacobi", "ILU", "Multigrid"});
}

ImplicitDiffusion::ImplicitDiffusion(const Teuchos::ParameterList& given)
    : parameters_(completed<ImplicitDiffusion>(given, "ImplicitDiffusion")),
      fields_(parameters_),
      field_(parameters_.get<std::string>("Field")),
      fluxField_(fluxDivergenceField(field_)),
      loadSteps_(parameters_, "ImplicitDiffusion"),
      linear_(parameters_),
      maximumIterations_(parameters_.get<int>("Maximum Solver Iterations")) {
  if (parameters_.isParameter("Absolute Tolerance")) {
    absoluteTolerance_ = parameters_.get<double>("Absolute Tolerance");
    relativeTolerance_ = 0.0;
  }
  if (parameters_.isParameter("Relative Tolerance")) relativeTolerance_ = parameters_.get<double>("Relative Tolerance");
}

void ImplicitDiffusion::initialize(Simulation& simulation) {
  requireFluxDivergence(simulation.model, field_, "ImplicitDiffusion");
  if (rateIsAsymmetric(simulation.model, field_) && linear_.method == "CG")
    throw RunError("ImplicitDiffusion: a flow carries \"" + field_ +
                   "\", which takes \"Linear Solver: GMRES\", \"Preconditioner: ILU\", or \"Linear Solver: "
                   "Direct\"");
}

/// The points that a value at the prescribed ones can reach: where these are 1 and all others 0, what is reached has an
/// inflow, becomes 1, and passes it on.
void ImplicitDiffusion::findHeldPoints(Simulation& simulation) {
  Model& model = simulation.model;
  const std::vector<char>& isPrescribed = simulation.conditions.valueIsPrescribed(field_);
  bool hasChanged = model.comm().any(isPrescribed != isPrescribed_);
  if (model.hasDamage()) {
    const double bondDamage = bondDamageSum_.of(model);
    hasChanged = hasChanged || bondDamage != bondDamage_;
    bondDamage_ = bondDamage;
  }
  if (!hasChanged) return;
  hasMatrix_ = false;
  isPrescribed_ = isPrescribed;
  double* values = model.field(field_);
  const double* rate = model.field(fluxField_);
  const auto nOwned = static_cast<std::size_t>(model.nOwned());
  const std::vector<double> present(values, values + nOwned);
  for (std::size_t i = 0; i < nOwned; ++i) values[i] = isPrescribed_[i] ? 1.0 : 0.0;
  long long nNew = 1;
  while (nNew > 0) {
    model.importGhosts(field_);
    evaluateFlux(model, 0.0);
    nNew = 0;
    for (std::size_t i = 0; i < nOwned; ++i) {
      if (values[i] != 0.0 || rate[i] == 0.0) continue;
      values[i] = 1.0;
      ++nNew;
    }
    nNew = model.comm().sum(nNew);
  }
  isHeld_ = isPrescribed_;
  long long nOutOfReach = 0, nPrescribed = 0;
  for (std::size_t i = 0; i < nOwned; ++i) {
    nPrescribed += isPrescribed_[i] ? 1 : 0;
    nOutOfReach += values[i] == 0.0 ? 1 : 0;
  }
  for (std::size_t i = 0; i < isHeld_.size(); ++i)
    if (values[i] == 0.0) isHeld_[i] = 1;  // ghosts agree with their owners: nothing has changed since the import
  nOutOfReach_ = model.comm().sum(nOutOfReach);
  std::copy(present.begin(), present.end(), values);
  model.importGhosts(field_);
  if (model.comm().sum(nPrescribed) == 0)
    throw RunError("ImplicitDiffusion: no point has a prescribed " + field_ +
                   ", which leaves the steady state open; prescribe it somewhere, or use the solver Diffusion");
  if (nOutOfReach_ > 0)
    simulation.output.log(fmt::format(
        "ImplicitDiffusion: {} point(s) exchange nothing with points whose {} is prescribed, and keep theirs",
        nOutOfReach_, field_));
}

/// Points that nothing prescribed reaches may keep their values where nothing flows among them. The first evaluation
/// of a load step has been made.
void ImplicitDiffusion::requireNoFluxOutOfReach(Simulation& simulation, double t) const {
  Model& model = simulation.model;
  if (nOutOfReach_ == 0) return;
  const double *values = model.field(field_), *rate = model.field(fluxField_);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  long long nFlowing = 0;
  for (int i = 0; i < model.nOwned(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!isHeld_[k] || isPrescribed_[k] || rate[i] == 0.0) continue;
    ++nFlowing;
    low = std::min(low, values[i]);
    high = std::max(high, values[i]);
  }
  nFlowing = model.comm().sum(nFlowing);
  low = -model.comm().max(-low);
  high = model.comm().max(high);
  // Rounding of values that are meant to be equal is no flux.
  if (nFlowing == 0 || high - low <= 1e-9 * std::max(std::abs(low), std::abs(high))) return;
  throw RunError(fmt::format(
      "ImplicitDiffusion: load step {} (t = {:.6g} s): between {} points flows {}, whose values lie between {:.6g} and "
      "{:.6g}, but none of them exchanges anything with a point where it is prescribed, which leaves their steady "
      "state "
      "open; prescribe it on their part of the body, start from one value there, or use the solver Diffusion",
      nLoadSteps_, t, nFlowing, field_, low, high));
}

void ImplicitDiffusion::rehearse(Simulation& simulation, double t, double dt) {
  findHeldPoints(simulation);
  evaluateFlux(simulation.model, dt);
  requireNoFluxOutOfReach(simulation, t + dt);
}

void ImplicitDiffusion::evaluateFlux(Model& model, double dt) {
  if (!holdsLimits_) std::copy_n(model.field(field_), model.nPoints(), model.field(fields_.limitedAt));
  model.evaluateFluxDivergence(dt, fluxField_);
}

ImplicitDiffusion::Balance ImplicitDiffusion::evaluate(Simulation& simulation, double dt) {
  Model& model = simulation.model;
  evaluateFlux(model, dt);
  const double *volume = model.field("Volume"), *rate = model.field(fluxField_);
  const auto nOwned = static_cast<std::size_t>(model.nOwned());
  residual_.assign(nOwned, 0.0);
  std::vector<double> held(nOwned, 0.0);
  for (std::size_t i = 0; i < nOwned; ++i)
    if (isPrescribed_[i] || !isHeld_[i]) (isHeld_[i] ? held : residual_)[i] = volume[i] * rate[i];
  return {normOverRanks(model.comm(), residual_), normOverRanks(model.comm(), held)};
}

void ImplicitDiffusion::assemble(Simulation& simulation, double dt) {
  // Negative: positive definite for conservative fluxes.
  stiffness_ = assembleFluxMatrix(simulation.model, field_, dt, -1.0, false, isHeld_, system_);
  hasMatrix_ = true;
  ++nMatrices_;
}

void ImplicitDiffusion::solveLinear(Simulation& simulation, double tolerance) {
  const Timers::Scope timer(simulation.model.timers(), "linear solve");
  if (linear_.tolerance > 0.0) tolerance = linear_.tolerance;
  const auto attempt = [&](const std::string& method) {
    step_.assign(residual_.size(), 0.0);
    const LinearSolveReport report = system_->solve(residual_.data(), step_.data(), method, linear_.preconditioner,
                                                    tolerance, linear_.maximumIterations);
    nLinearIterations_ += report.iterations;
    if (linear_.logs)
      simulation.output.log(fmt::format("{} ({}): {} iterations, relative residual {:.3g}, asked for {:.3g}",
                                        report.method, linear_.preconditioner, report.iterations,
                                        report.relativeResidual, tolerance));
    return report;
  };
  ++nSolves_;
  // Fluxes that are not balanced between blocks give a matrix that is not symmetric, which CG may not master.
  if (!attempt(linear_.method).hasConverged && linear_.method == "CG") attempt("GMRES");
}

double ImplicitDiffusion::largestValue(Simulation& simulation) const {
  double largest = 0.0;
  const double* values = simulation.model.field(field_);
  for (int i = 0; i < simulation.model.nOwned(); ++i) largest = std::max(largest, std::abs(values[i]));
  return simulation.model.comm().max(largest);
}

/// With limits that are held, of a steady state by these: whether it is one by the limits of its own values, too, or as
/// near to that as kinks let it come. Otherwise the limits move half way to these, which does not go to and fro.
bool ImplicitDiffusion::keepsToLimits(Simulation& simulation, double dt, double target) {
  constexpr int mostHolds = 30;
  constexpr double nearEnough = 1e-5;
  Model& model = simulation.model;
  double* limitedAt = model.field(fields_.limitedAt);
  const double* values = model.field(field_);
  const std::vector<double> before(limitedAt, limitedAt + model.nPoints());
  holdsLimits_ = false;
  const Balance own = evaluate(simulation, dt);
  const bool isOver = own.free <= target || (++nHolds_ > mostHolds && own.free <= nearEnough * own.held);
  if (isOver) largestByLimits_ = std::max(largestByLimits_, own.free / own.held);
  holdsLimits_ = true;
  for (std::size_t i = 0; i < before.size(); ++i) limitedAt[i] = isOver ? before[i] : 0.5 * (before[i] + values[i]);
  if (isOver) evaluate(simulation, dt);  // of these limits, which conserve what flows
  return isOver;
}

void ImplicitDiffusion::giveUp(Simulation& simulation, double t, int iterations, const Balance& balance,
                               double target) const {
  const double held = std::max(balance.held, std::numeric_limits<double>::min());
  throw RunError(fmt::format(
      "ImplicitDiffusion: load step {} (t = {:.6g} s): no steady state: what flows into free points is {:.3g} of what "
      "flows into prescribed ones after {} iterations, asked for {:.3g} ({}, {}). Allow more iterations (Maximum "
      "Solver Iterations), or try another Linear Solver or Preconditioner{}",
      nLoadSteps_, t, balance.free / held, iterations, target / held, linear_.method, linear_.preconditioner,
      rateIsAsymmetric(simulation.model, field_)
          ? "; where a material Advection Diffusion has Scheme: Limited, whose kinks may keep Newton's method from it, "
            "take \"Scheme: Upwind Biased\""
          : ""));
}

void ImplicitDiffusion::advance(Simulation& simulation, double t, double dt) {
  constexpr int iterationsAtKinks = 40;  // Newton's method rarely takes more where kinks do not lead it to and fro
  Model& model = simulation.model;
  requireFlow(model, field_, "ImplicitDiffusion");
  ++nLoadSteps_;
  simulation.conditions.applyPrescribedValue(field_, t + dt);
  model.importGhosts(field_);
  holdsLimits_ = false;
  nHolds_ = 0;
  findHeldPoints(simulation);
  const bool isCarried = rateIsAsymmetric(model, field_);
  bool matrixIsNew = false;
  double before = std::numeric_limits<double>::infinity(), part = 1.0;
  for (int iteration = 0;; ++iteration) {
    const Balance balance = evaluate(simulation, dt);
    if (iteration == 0) requireNoFluxOutOfReach(simulation, t + dt);
    if (!hasMatrix_) {
      assemble(simulation, dt);
      matrixIsNew = true;
    }
    const double roundOff = 4.0 * std::numeric_limits<double>::epsilon() * stiffness_ * largestValue(simulation);
    const double target = std::max({relativeTolerance_ * balance.held, absoluteTolerance_, roundOff});
    const double relative = balance.free / std::max(balance.held, std::numeric_limits<double>::min());
    if (balance.free <= target) {
      if (holdsLimits_ && !keepsToLimits(simulation, dt, target)) {
        hasMatrix_ = false;
        continue;
      }
      if (balance.free > roundOff) largestResidual_ = std::max(largestResidual_, relative);
      break;
    }
    if (iteration == maximumIterations_ || !std::isfinite(balance.free))
      giveUp(simulation, t + dt, iteration, balance, target);
    if (isCarried && !holdsLimits_ && iteration >= iterationsAtKinks) {
      holdsLimits_ = true;
      hasMatrix_ = false;
      continue;
    }
    // A flux that is not linear in the field needs the matrix of the present values.
    if (balance.free > 0.1 * before && !matrixIsNew) {
      assemble(simulation, dt);
      matrixIsNew = true;
    }
    // Fluxes with kinks may lead to and fro: then what lies between is better.
    part = holdsLimits_ ? 1.0 : !(balance.free > 0.5 * before) ? std::min(1.0, 2.0 * part) : std::max(0.25, 0.7 * part);
    before = balance.free;
    solveLinear(simulation, std::clamp(0.5 * target / balance.free, 1e-13, 0.5));
    double* values = model.field(field_);
    for (std::size_t i = 0; i < step_.size(); ++i)
      if (!isHeld_[i]) values[i] += part * step_[i];
    model.importGhosts(field_);
    matrixIsNew = false;
  }
  model.requireFinite(field_, static_cast<int>(nLoadSteps_));
  model.acceptStep(t + dt, dt);
}

std::vector<std::string> ImplicitDiffusion::summary() const {
  std::vector<std::string> lines{fmt::format(
      "ImplicitDiffusion of {}: {} load steps, {} linear solves ({}{}), {} iterations, {} matrices; largest residual "
      "above rounding, relative to what flows into prescribed points {:.3g}",
      field_, nLoadSteps_, nSolves_, linear_.method, linear_.method == "Direct" ? "" : ", " + linear_.preconditioner,
      nLinearIterations_, nMatrices_, largestResidual_)};
  if (largestByLimits_ > 0.0)
    lines.push_back(fmt::format(
        "ImplicitDiffusion of {}: limits of slopes were held, which kinks led to and fro; by those of the values "
        "themselves that residual is {:.3g}",
        field_, largestByLimits_));
  return lines;
}

PD_REGISTER_SOLVER(ImplicitDiffusion, "ImplicitDiffusion", "Steady state of a diffusing scalar, load step by load step")

}  // namespace pd
