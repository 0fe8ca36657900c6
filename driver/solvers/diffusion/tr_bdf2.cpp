#include "tr_bdf2.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd {

namespace {

const double root2 = std::sqrt(2.0);
const double gamma = 2.0 - root2;
const double d = 1.0 - 0.5 * root2;

}  // namespace

void TrBdf2::declareParameters(ParameterDeclarations& declare) {
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
  ImplicitStage::declareParameters(declare);
}

TrBdf2::TrBdf2(const Teuchos::ParameterList& given)
    : parameters_(completed<TrBdf2>(given, "TR-BDF2")), stage_(parameters_) {
  if (parameters_.isParameter("Sub Steps")) nSubSteps_ = parameters_.get<int>("Sub Steps");
  for (const auto& [key, value] :
       {std::pair("Time Step", &timeStep_), std::pair("Relative Tolerance", &relativeTolerance_),
        std::pair("Absolute Tolerance", &absoluteTolerance_)})
    if (parameters_.isParameter(key)) *value = parameters_.get<double>(key);
}

RestartState TrBdf2::restartState() const {
  return {{"step of the matrix", stage_.matrixStep()},
          {"proposed step", proposedStep_},
          {"steps", static_cast<double>(nSteps_)},
          {"rejected steps", static_cast<double>(nRejected_)}};
}

void TrBdf2::setRestartState(const RestartState& state) {
  stage_.setMatrixStep(state["step of the matrix"]);
  proposedStep_ = state["proposed step"];
  nSteps_ = static_cast<long long>(state["steps"]);
  nRejected_ = static_cast<long long>(state["rejected steps"]);
}

/// From the present values at t to `end` = t + step.
void TrBdf2::takeStep(Simulation& simulation, ScalarRate& rate, double t, double end, double step) {
  const auto n = static_cast<std::size_t>(rate.nOwned());
  const double h = d * step, middle = t + gamma * step;
  rate.evaluate(h);
  values0_.assign(rate.values(), rate.values() + n);
  rate0_.assign(rate.rate(), rate.rate() + n);
  right_.resize(n);
  for (std::size_t i = 0; i < n; ++i) right_[i] = values0_[i] + h * rate0_[i];
  rate.hold(middle);
  stage_.solve(simulation, rate, middle, h, right_);
  valuesMiddle_.assign(rate.values(), rate.values() + n);
  const double share = 1.0 / (gamma * (2.0 - gamma)), earlier = (1.0 - gamma) * (1.0 - gamma);
  for (std::size_t i = 0; i < n; ++i) right_[i] = share * (valuesMiddle_[i] - earlier * values0_[i]);
  rate.hold(end);
  stage_.solve(simulation, rate, end, h, right_);
}

double TrBdf2::error(Simulation& simulation, ScalarRate& rate, const std::string& field, double step) {
  // Hosea & Shampine (1996): the difference to an embedded third-order formula, with the rates as the stages define
  // them, filtered by the matrix so that it stays bounded for stiff parts.
  const double w = 0.25 * root2, h = d * step;
  const double first = w - (1.0 - w) / 3.0, second = w - (3.0 * w + 1.0) / 3.0, third = d - d / 3.0;
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed(field);
  const double *volume = simulation.model.field("Volume"), *values = rate.values();
  std::vector<double> estimate(values0_.size(), 0.0);
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    if (isHeld[i]) continue;
    const double rateMiddle = (valuesMiddle_[i] - values0_[i]) / h - rate0_[i], rateEnd = (values[i] - right_[i]) / h;
    estimate[i] = volume[i] * step * (first * rate0_[i] + second * rateMiddle + third * rateEnd);
  }
  stage_.smooth(estimate);
  double absolute = absoluteTolerance_ > 0.0 ? absoluteTolerance_ : relativeTolerance_ * rate.largestValue();
  absolute = std::max(absolute, std::numeric_limits<double>::min());
  double sum = 0.0;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const double tolerance = absolute + relativeTolerance_ * std::max(std::abs(values0_[i]), std::abs(values[i]));
    sum += (estimate[i] / tolerance) * (estimate[i] / tolerance);
  }
  return std::sqrt(rate.comm().sum(sum) / static_cast<double>(std::max(1LL, rate.nFreePoints())));
}

void TrBdf2::advanceControlled(Simulation& simulation, ScalarRate& rate, const std::string& field, double t,
                               double dt) {
  const double end = t + dt;
  if (proposedStep_ <= 0.0) proposedStep_ = dt;
  while (t < end) {
    // Equal steps to the end of the increment, so that they share a matrix.
    const int nLeft = std::max(1, static_cast<int>(std::ceil((end - t) / proposedStep_ * (1.0 - 1e-9))));
    const double step = (end - t) / nLeft, next = nLeft == 1 ? end : t + step;
    takeStep(simulation, rate, t, next, step);
    const double errorNow = error(simulation, rate, field, step);
    const double factor = std::isfinite(errorNow) ? 0.9 / std::cbrt(std::max(errorNow, 1e-3)) : 0.1;
    if (errorNow <= 1.0) {
      t = next;
      ++nSteps_;
      // A longer step must be worth a new matrix.
      if (factor > 2.0) proposedStep_ = std::max(proposedStep_, step * factor);
      continue;
    }
    ++nRejected_;
    proposedStep_ = step * std::max(0.1, factor);
    if (step < 1e-12 * dt)
      throw RunError(fmt::format(
          "Diffusion: TR-BDF2 cannot meet its tolerance at t = {:.6g} s: the step fell to {:.3g} s", t, step));
    std::copy(values0_.begin(), values0_.end(), rate.values());
    rate.hold(t);
  }
}

void TrBdf2::advance(Simulation& simulation, const std::string& field, double t, double dt) {
  ScalarRate rate(simulation, field, t);
  stage_.begin(simulation, field);
  if (isControlled()) {
    advanceControlled(simulation, rate, field, t, dt);
    return;
  }
  const int n = timeStep_ > 0.0 ? equalSteps(dt, timeStep_) : nSubSteps_;
  for (int k = 0; k < n; ++k)
    takeStep(simulation, rate, t + k * (dt / n), k + 1 == n ? t + dt : t + (k + 1) * (dt / n), dt / n);
  nSteps_ += n;
}

std::vector<std::string> TrBdf2::summary() const {
  return {fmt::format("TR-BDF2: {} steps ({} rejected); {}", nSteps_, nRejected_, stage_.summary())};
}

PD_REGISTER_RATE_INTEGRATOR(TrBdf2, "TR-BDF2",
                            "Implicit trapezoidal rule and backward differences; second order, L-stable, "
                            "error-controlled")

}  // namespace pd
