// Forward Euler: first order, stable up to 2 / (largest eigenvalue of the rate).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rate_integrator.hpp"
#include "scalar_rate.hpp"

namespace pd {

class Euler : public RateIntegrator {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.integer("Sub Steps", "Equal time steps an increment is cut into.").atLeast(1);
    declare
        .real("Time Step", "s", "Length of a time step; an increment is cut into equal steps of this length or less.")
        .positive();
    declare.atMostOneOf({"Sub Steps", "Time Step"});
    declare
        .real("Safety Factor", "1",
              "Part of the stability limit used where neither \"Sub Steps\" nor \"Time Step\" is given.")
        .defaultTo(0.9)
        .strictlyBetween(0.0, 1.0);
    declare.flag("Allow Unstable Step", "Run even where the time step is above the stability limit.").defaultTo(false);
  }

  explicit Euler(const Teuchos::ParameterList& given) {
    const auto parameters = completed<Euler>(given, "Euler");
    if (parameters.isParameter("Sub Steps")) nSubSteps_ = parameters.get<int>("Sub Steps");
    if (parameters.isParameter("Time Step")) timeStep_ = parameters.get<double>("Time Step");
    safetyFactor_ = parameters.get<double>("Safety Factor");
    allowUnstableStep_ = parameters.get<bool>("Allow Unstable Step");
  }

  void rehearse(Simulation& simulation, const std::string& field, double t, double dt) override {
    ScalarRate rate(simulation, field, t);
    stableSteps(rate, field, dt);
  }
  void advance(Simulation& simulation, const std::string& field, double t, double dt) override;
  std::vector<std::string> summary() const override;
  RestartState restartState() const override {
    return {{"largest eigenvalue", largestEigenvalue_}, {"steps", static_cast<double>(nSteps_)}};
  }
  void setRestartState(const RestartState& state) override {
    largestEigenvalue_ = state["largest eigenvalue"];
    nSteps_ = static_cast<long long>(state["steps"]);
  }
  void modelHasChanged() override { largestEigenvalue_ = -1.0; }

 private:
  int numberOfSteps(double dt) const;
  /// The same. Throws RunError where the steps are too long to be stable.
  int stableSteps(ScalarRate& rate, const std::string& field, double dt);
  double limit() const {
    return largestEigenvalue_ > 0.0 ? 2.0 / largestEigenvalue_ : std::numeric_limits<double>::infinity();
  }

  int nSubSteps_ = 0;      // 0: not given
  double timeStep_ = 0.0;  // 0: not given
  double safetyFactor_;
  bool allowUnstableStep_;
  double largestEigenvalue_ = -1.0;  // negative: not known yet
  double longestStep_ = 0.0;
  long long nSteps_ = 0;
};

int Euler::numberOfSteps(double dt) const {
  if (nSubSteps_ > 0) return nSubSteps_;
  const double step = timeStep_ > 0.0 ? timeStep_ : safetyFactor_ * limit();
  return equalSteps(dt, step);
}

int Euler::stableSteps(ScalarRate& rate, const std::string& field, double dt) {
  // Holding further points or cutting bonds only lowers the eigenvalue: one estimate serves the whole run.
  if (largestEigenvalue_ < 0.0) largestEigenvalue_ = rate.largestEigenvalueBound(dt, 1.0e-3, 200);
  const int n = numberOfSteps(dt);
  const double step = dt / n;
  if (step > limit() && !allowUnstableStep_)
    throw RunError(fmt::format(
        "Diffusion: the time step {:.6g} s of \"{}\" is above the stability limit {:.6g} s of forward Euler "
        "(2 / largest eigenvalue {:.6g} 1/s). Use at least {} sub-steps an increment, Method: RKL or an implicit one, "
        "or set \"Allow Unstable Step: true\"",
        step, field, limit(), largestEigenvalue_, static_cast<long long>(std::ceil(dt / limit()))));

  return n;
}

void Euler::advance(Simulation& simulation, const std::string& field, double t, double dt) {
  ScalarRate rate(simulation, field, t);
  const int n = stableSteps(rate, field, dt);
  const double step = dt / n;
  longestStep_ = std::max(longestStep_, step);
  double* values = rate.values();
  for (int k = 1; k <= n; ++k) {
    rate.evaluate(step);
    {
      const Timers::Scope timer(simulation.model.timers(), "diffusion update");
      const double* change = rate.rate();
      for (int i = 0; i < rate.nOwned(); ++i) values[i] += step * change[i];
    }
    rate.hold(k == n ? t + dt : t + k * step);
  }
  nSteps_ += n;
}

std::vector<std::string> Euler::summary() const {
  return {
      fmt::format("Euler: {} steps; stability limit {:.6g} s (largest eigenvalue {:.6g} 1/s), longest step {:.6g} s "
                  "= {:.3g} of it",
                  nSteps_, limit(), largestEigenvalue_, longestStep_, longestStep_ / limit())};
}

PD_REGISTER_RATE_INTEGRATOR(Euler, "Euler", "Forward Euler; first order, steps below a stability limit")

}  // namespace pd
