#include "stabilized_runge_kutta.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd {

void StabilizedRungeKutta::declareParameters(ParameterDeclarations& declare) {
  declare.integer("Sub Steps", "Equal time steps an increment is cut into.").atLeast(1);
  declare.real("Time Step", "s", "Length of a time step; an increment is cut into equal steps of this length or less.")
      .positive();
  declare
      .real("Relative Tolerance", "1",
            "Local error of a step relative to the value; the step is chosen so. 1e-4 where no step is given either.")
      .strictlyBetween(0.0, 1.0);
  declare.atMostOneOf({"Sub Steps", "Time Step", "Relative Tolerance"});
  declare
      .real("Absolute Tolerance", "unit of the field",
            "Local error of a step that is always good enough; by default the relative tolerance times the largest "
            "value of the field.")
      .positive();
  declare.integer("Maximum Stages", "Stages a step may have; longer steps are cut.").defaultTo(200).atLeast(3);
  declare
      .real("Stability Margin", "1",
            "Part by which the estimated largest eigenvalue is raised before stages are counted.")
      .defaultTo(0.05)
      .between(0.0, 1.0);
}

StabilizedRungeKutta::StabilizedRungeKutta(const Teuchos::ParameterList& given, const std::string& name,
                                           StabilizedFamily family)
    : name_(name), family_(family) {
  const auto parameters = completed<StabilizedRungeKutta>(given, name);
  if (parameters.isParameter("Sub Steps")) nSubSteps_ = parameters.get<int>("Sub Steps");
  if (parameters.isParameter("Time Step")) timeStep_ = parameters.get<double>("Time Step");
  relativeTolerance_ =
      parameters.isParameter("Relative Tolerance") ? parameters.get<double>("Relative Tolerance") : 1.0e-4;
  if (parameters.isParameter("Absolute Tolerance")) absoluteTolerance_ = parameters.get<double>("Absolute Tolerance");
  stabilityMargin_ = parameters.get<double>("Stability Margin");
  maximumStages_ = parameters.get<int>("Maximum Stages");
}

RestartState StabilizedRungeKutta::restartState() const {
  return {{"largest eigenvalue", largestEigenvalue_},
          {"proposed step", proposedStep_},
          {"error of the last step", previousError_},
          {"steps", static_cast<double>(nSteps_)},
          {"rejected steps", static_cast<double>(nRejected_)}};
}

void StabilizedRungeKutta::setRestartState(const RestartState& state) {
  largestEigenvalue_ = state["largest eigenvalue"];
  proposedStep_ = state["proposed step"];
  previousError_ = state["error of the last step"];
  nSteps_ = static_cast<long long>(state["steps"]);
  nRejected_ = static_cast<long long>(state["rejected steps"]);
}

const StabilizedScheme& StabilizedRungeKutta::scheme(double step) {
  const int nStages = requiredStages(family_, step * largestEigenvalue_);
  const auto it = schemes_.find(nStages);
  if (it != schemes_.end()) return it->second;
  return schemes_.emplace(nStages, stabilizedScheme(family_, nStages)).first->second;
}

double StabilizedRungeKutta::longestStableStep() const {
  if (!(largestEigenvalue_ > 0.0)) return std::numeric_limits<double>::infinity();
  const bool isEven = maximumStages_ % 2 == 0;
  const int nStages = family_ == StabilizedFamily::Legendre && isEven ? maximumStages_ - 1 : maximumStages_;
  return stabilizedScheme(family_, nStages).stability / largestEigenvalue_;
}

void StabilizedRungeKutta::estimateEigenvalue(ScalarRate& rate, double dt) {
  // The estimate lies a little high: it costs a stage, while one that is too low costs the run.
  largestEigenvalue_ = (1.0 + stabilityMargin_) * rate.largestEigenvalueBound(dt, 0.05, 60);
}

void StabilizedRungeKutta::evaluate(ScalarRate& rate, double step) {
  rate.evaluate(step);
  ++nEvaluations_;
}

void StabilizedRungeKutta::takeStep(Simulation& simulation, ScalarRate& rate, double t, double step) {
  const StabilizedScheme& method = scheme(step);
  const int n = rate.nOwned();
  double* values = rate.values();
  const double* before = values0_.data();  // Y_{j-2}
  for (std::size_t j = 0; j < method.stages.size(); ++j) {
    const StabilizedStage& stage = method.stages[j];
    if (j > 0) evaluate(rate, step);
    {
      const Timers::Scope timer(simulation.model.timers(), "diffusion update");
      const double keep = 1.0 - stage.mu - stage.nu, now = step * stage.muTilde, first = step * stage.gammaTilde;
      const double *rateNow = j > 0 ? rate.rate() : rate0_.data(), *values0 = values0_.data(), *rate0 = rate0_.data();
      double* older = valuesBefore_.data();
      for (int i = 0; i < n; ++i) {
        const double old = values[i];
        values[i] = stage.mu * old + stage.nu * before[i] + keep * values0[i] + now * rateNow[i] + first * rate0[i];
        older[i] = old;
      }
    }
    before = valuesBefore_.data();
    rate.hold(t + stage.c * step);
  }
  mostStages_ = std::max(mostStages_, static_cast<int>(method.stages.size()));
}

double StabilizedRungeKutta::error(ScalarRate& rate, double step) const {
  // Sommeijer, Shampine & Verwer (1998), eq. (3.1).
  const double *values = rate.values(), *rateNow = rate.rate();
  double sum = 0.0;
  auto held = rate.heldPoints().begin();
  for (int i = 0; i < rate.nOwned(); ++i) {
    if (held != rate.heldPoints().end() && *held == i) {
      ++held;
      continue;
    }
    const auto k = static_cast<std::size_t>(i);
    const double estimate = 0.8 * (values0_[k] - values[i]) + 0.4 * step * (rate0_[k] + rateNow[i]);
    const double tolerance =
        absoluteToleranceNow_ + relativeTolerance_ * std::max(std::abs(values0_[k]), std::abs(values[i]));
    sum += (estimate / tolerance) * (estimate / tolerance);
  }
  return std::sqrt(rate.comm().sum(sum) / static_cast<double>(std::max(1LL, rate.nFreePoints())));
}

void StabilizedRungeKutta::raiseTolerance(const ScalarRate& rate) {
  // A body that was empty when the increment began is filled from prescribed points: their values give the field's
  // size.
  if (absoluteTolerance_ <= 0.0)
    absoluteToleranceNow_ = std::max(absoluteToleranceNow_, relativeTolerance_ * rate.largestHeldValue());
}

double StabilizedRungeKutta::firstStep(ScalarRate& rate, double dt) const {
  // A change of 1 % of the field's size (Hairer, Norsett & Wanner, Solving ODEs I, II.4), but not less than a step
  // that forward Euler could take.
  double change = 0.0;
  for (int i = 0; i < rate.nOwned(); ++i) change = std::max(change, std::abs(rate0_[static_cast<std::size_t>(i)]));
  change = rate.comm().max(change);
  const double slow = change > 0.0 ? 0.01 * rate.largestValue() / change : dt;
  const double fast = largestEigenvalue_ > 0.0 ? 1.0 / largestEigenvalue_ : dt;
  return std::min(dt, std::max(slow, fast));
}

void StabilizedRungeKutta::advance(Simulation& simulation, const std::string& field, double t, double dt) {
  ScalarRate rate(simulation, field, t);
  if (largestEigenvalue_ < 0.0) estimateEigenvalue(rate, dt);
  absoluteToleranceNow_ = absoluteTolerance_ > 0.0 ? absoluteTolerance_ : relativeTolerance_ * rate.largestValue();
  absoluteToleranceNow_ = std::max(absoluteToleranceNow_, std::numeric_limits<double>::min());
  valuesBefore_.resize(static_cast<std::size_t>(rate.nOwned()));
  evaluate(rate, dt);
  const auto keep = [&] {
    values0_.assign(rate.values(), rate.values() + rate.nOwned());
    rate0_.assign(rate.rate(), rate.rate() + rate.nOwned());
  };
  keep();
  if (nSubSteps_ > 0 || timeStep_ > 0.0)
    advanceEqualSteps(simulation, rate, t, dt, keep);
  else
    advanceControlled(simulation, rate, t, dt, keep);
}

void StabilizedRungeKutta::advanceEqualSteps(Simulation& simulation, ScalarRate& rate, double t, double dt,
                                             const std::function<void()>& keep) {
  const int n = nSubSteps_ > 0 ? nSubSteps_ : equalSteps(dt, timeStep_);
  const double step = dt / n;
  if (step > longestStableStep())
    throw RunError(
        fmt::format("Diffusion: a step of {:.6g} s needs {} stages of {}, more than \"Maximum Stages: {}\". "
                    "Take shorter steps or allow more stages",
                    step, requiredStages(family_, step * largestEigenvalue_), name_, maximumStages_));
  for (int k = 0; k < n; ++k) {
    takeStep(simulation, rate, t + k * step, step);
    ++nSteps_;
    if (k + 1 == n) break;
    evaluate(rate, step);
    keep();
  }
}

void StabilizedRungeKutta::advanceControlled(Simulation& simulation, ScalarRate& rate, double t, double dt,
                                             const std::function<void()>& keep) {
  const double end = t + dt;
  if (proposedStep_ <= 0.0) proposedStep_ = firstStep(rate, dt);
  int nRejectedInARow = 0;
  while (t < end) {
    const double remaining = end - t;
    double step = std::min(proposedStep_, longestStableStep());
    // The last two steps of an increment are made equal, so that none is a sliver.
    if (step >= remaining * (1.0 - 1.0e-9))
      step = remaining;
    else if (step > 0.5 * remaining)
      step = 0.5 * remaining;
    takeStep(simulation, rate, t, step);
    evaluate(rate, step);
    raiseTolerance(rate);
    const double errorNow = error(rate, step);
    if (errorNow <= 1.0) {
      t = step == remaining ? end : t + step;
      ++nSteps_;
      nRejectedInARow = 0;
      propose(step, errorNow);
      if (t < end) keep();
      continue;
    }
    ++nRejected_;
    ++nRejectedInARow;
    proposedStep_ = step * (std::isfinite(errorNow) ? std::max(0.1, 0.8 * std::cbrt(1.0 / errorNow)) : 0.1);
    if (step < 1.0e-12 * dt)
      throw RunError(fmt::format("Diffusion: {} cannot meet its tolerance at t = {:.6g} s: the step fell to {:.3g} s",
                                 name_, t, step));
    std::copy(values0_.begin(), values0_.end(), rate.values());
    rate.hold(t);
    // Rejected twice: the rate may have become stiffer than it was.
    if (nRejectedInARow % 2 == 0) estimateEigenvalue(rate, dt);
  }
}

void StabilizedRungeKutta::propose(double step, double errorNow) {
  // PI controller of a second-order method with a third-order estimate (Hairer & Wanner, Solving ODEs II, IV.2).
  const double bounded = std::max(errorNow, 1.0e-8);
  const double factor = 0.8 * std::pow(bounded, -0.7 / 3.0) * std::pow(previousError_, 0.4 / 3.0);
  const double next = step * std::min(5.0, std::max(0.2, factor));
  // A step that was cut short to meet the end of an increment says nothing against a longer one.
  proposedStep_ = errorNow <= 0.5 ? std::max(next, proposedStep_) : next;
  previousError_ = bounded;
}

std::vector<std::string> StabilizedRungeKutta::summary() const {
  return {fmt::format(
      "{}: {} steps ({} rejected), {} evaluations, at most {} stages; largest eigenvalue {:.6g} 1/s "
      "(stages are counted for this, {:.0f} % above the estimate)",
      name_, nSteps_, nRejected_, nEvaluations_, mostStages_, largestEigenvalue_, 100.0 * stabilityMargin_)};
}

class RungeKuttaChebyshev : public StabilizedRungeKutta {
 public:
  explicit RungeKuttaChebyshev(const Teuchos::ParameterList& given)
      : StabilizedRungeKutta(given, "RKC", StabilizedFamily::Chebyshev) {}
};

class RungeKuttaLegendre : public StabilizedRungeKutta {
 public:
  explicit RungeKuttaLegendre(const Teuchos::ParameterList& given)
      : StabilizedRungeKutta(given, "RKL", StabilizedFamily::Legendre) {}
};

PD_REGISTER_RATE_INTEGRATOR(RungeKuttaChebyshev, "RKC",
                            "Stabilised explicit Runge-Kutta-Chebyshev; second order, error-controlled, fewest stages")
PD_REGISTER_RATE_INTEGRATOR(
    RungeKuttaLegendre, "RKL",
    "Stabilised explicit Runge-Kutta-Legendre; second order, error-controlled, damps fronts best")

}  // namespace pd
