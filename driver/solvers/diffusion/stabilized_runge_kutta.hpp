// RKC and RKL: explicit, second order, with as many stages as the stiffness asks for and an embedded error estimate.
#ifndef PD_STABILIZED_RUNGE_KUTTA_HPP
#define PD_STABILIZED_RUNGE_KUTTA_HPP

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "rate_integrator.hpp"
#include "scalar_rate.hpp"
#include "stabilized_scheme.hpp"

namespace pd {

/// The real stability interval grows with the square of the number of stages s, so that a step costs s evaluations
/// where forward Euler needs s^2 / 2 (RKL) to s^2 / 3 (RKC).
class StabilizedRungeKutta : public RateIntegrator {
 public:
  static void declareParameters(ParameterDeclarations& declare);

  void advance(Simulation& simulation, const std::string& field, double t, double dt) override;
  std::vector<std::string> summary() const override;
  RestartState restartState() const override;
  void setRestartState(const RestartState& state) override;
  void modelHasChanged() override { largestEigenvalue_ = -1.0; }

 protected:
  StabilizedRungeKutta(const Teuchos::ParameterList& given, const std::string& name, StabilizedFamily family);

 private:
  const StabilizedScheme& scheme(double step);
  double longestStableStep() const;
  void estimateEigenvalue(ScalarRate& rate, double dt);
  double firstStep(ScalarRate& rate, double dt) const;
  /// `keep` makes the present values and their rate the start of the next step.
  void advanceEqualSteps(Simulation& simulation, ScalarRate& rate, double t, double dt,
                         const std::function<void()>& keep);
  void advanceControlled(Simulation& simulation, ScalarRate& rate, double t, double dt,
                         const std::function<void()>& keep);
  void evaluate(ScalarRate& rate, double step);
  /// From (values0_, rate0_) at t; leaves the new values in the field.
  void takeStep(Simulation& simulation, ScalarRate& rate, double t, double step);
  /// Root mean square over the free points of the estimated local error over its tolerance.
  double error(ScalarRate& rate, double step) const;
  void raiseTolerance(const ScalarRate& rate);
  void propose(double step, double errorNow);

  std::string name_;
  StabilizedFamily family_;
  int nSubSteps_ = 0;      // 0: not given
  double timeStep_ = 0.0;  // 0: not given
  double relativeTolerance_;
  double absoluteTolerance_ = 0.0;  // 0: relative to the largest value of the field
  double stabilityMargin_;
  int maximumStages_;

  double largestEigenvalue_ = -1.0;  // negative: not known yet
  double proposedStep_ = 0.0;        // 0: none yet
  double previousError_ = 1.0;
  double absoluteToleranceNow_ = 0.0;
  std::map<int, StabilizedScheme> schemes_;
  std::vector<double> values0_, rate0_, valuesBefore_;
  long long nSteps_ = 0, nRejected_ = 0, nEvaluations_ = 0;
  int mostStages_ = 0;
};

}  // namespace pd

#endif
