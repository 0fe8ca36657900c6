// Backward Euler: first order, stable and without overshoot for any step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "implicit_stage.hpp"

namespace pd {

class ImplicitEuler : public RateIntegrator {
 public:
  static void declareParameters(ParameterDeclarations& declare) {
    declare.integer("Sub Steps", "Equal time steps an increment is cut into.").atLeast(1);
    declare
        .real("Time Step", "s", "Length of a time step; an increment is cut into equal steps of this length or less.")
        .positive();
    declare.atMostOneOf({"Sub Steps", "Time Step"});
    ImplicitStage::declareParameters(declare);
  }

  explicit ImplicitEuler(const Teuchos::ParameterList& given)
      : parameters_(completed<ImplicitEuler>(given, "Implicit Euler")), stage_(parameters_) {
    if (parameters_.isParameter("Sub Steps")) nSubSteps_ = parameters_.get<int>("Sub Steps");
    if (parameters_.isParameter("Time Step")) timeStep_ = parameters_.get<double>("Time Step");
  }

  void advance(Simulation& simulation, const std::string& field, double t, double dt) override {
    ScalarRate rate(simulation, field, t);
    stage_.begin(simulation, field);
    const int n = timeStep_ > 0.0 ? equalSteps(dt, timeStep_) : nSubSteps_;
    for (int k = 1; k <= n; ++k) {
      const double end = k == n ? t + dt : t + k * (dt / n);
      const std::vector<double> before(rate.values(), rate.values() + rate.nOwned());
      rate.hold(end);
      stage_.solve(simulation, rate, end, dt / n, before);
    }
    nSteps_ += n;
  }

  std::vector<std::string> summary() const override {
    return {fmt::format("Implicit Euler: {} steps; {}", nSteps_, stage_.summary())};
  }
  RestartState restartState() const override {
    return {{"step of the matrix", stage_.matrixStep()}, {"steps", static_cast<double>(nSteps_)}};
  }
  void checkpointWritten() override { stage_.forgetMatrix(); }
  void setRestartState(const RestartState& state) override {
    stage_.setMatrixStep(state["step of the matrix"]);
    nSteps_ = static_cast<long long>(state["steps"]);
  }

 private:
  const Teuchos::ParameterList parameters_;
  ImplicitStage stage_;
  int nSubSteps_ = 1;
  double timeStep_ = 0.0;  // 0: not given
  long long nSteps_ = 0;
};

PD_REGISTER_RATE_INTEGRATOR(ImplicitEuler, "Implicit Euler", "Backward Euler; first order, stable for any step")

}  // namespace pd
