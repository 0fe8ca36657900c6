// TR-BDF2: implicit, second order, L-stable, with an embedded error estimate.
#ifndef PD_TR_BDF2_HPP
#define PD_TR_BDF2_HPP

#include <string>
#include <vector>

#include "implicit_stage.hpp"

namespace pd {

/// R.E. Bank et al., IEEE Trans. CAD 4 (1985) 436; M.E. Hosea, L.F. Shampine, Appl. Numer. Math. 20 (1996) 21. With
/// gamma = 2 - sqrt(2) and d = gamma / 2, one matrix 1 - d h df/dc serves both stages:
///   c_g     = c_n + d h f_n + d h f(c_g)                                        (trapezoidal rule to t + gamma h)
///   c_{n+1} = [c_g - (1 - gamma)^2 c_n] / (gamma (2 - gamma)) + d h f(c_{n+1})  (backward differences)
class TrBdf2 : public RateIntegrator {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit TrBdf2(const Teuchos::ParameterList& given);

  void advance(Simulation& simulation, const std::string& field, double t, double dt) override;
  std::vector<std::string> summary() const override;
  RestartState restartState() const override;
  void checkpointWritten() override { stage_.forgetMatrix(); }
  void setRestartState(const RestartState& state) override;

 private:
  bool isControlled() const { return nSubSteps_ == 0 && timeStep_ == 0.0; }
  void takeStep(Simulation& simulation, ScalarRate& rate, double t, double end, double step);
  /// Root mean square over the free points of the estimated local error over its tolerance.
  double error(Simulation& simulation, ScalarRate& rate, const std::string& field, double step);
  void advanceControlled(Simulation& simulation, ScalarRate& rate, const std::string& field, double t, double dt);

  const Teuchos::ParameterList parameters_;
  ImplicitStage stage_;
  int nSubSteps_ = 0;               // 0: not given
  double timeStep_ = 0.0;           // 0: not given
  double absoluteTolerance_ = 0.0;  // 0: relative to the largest value of the field
  double relativeTolerance_ = 1e-4;
  double proposedStep_ = 0.0;  // 0: none yet
  std::vector<double> values0_, rate0_, valuesMiddle_, right_;
  long long nSteps_ = 0, nRejected_ = 0;
};

}  // namespace pd

#endif
