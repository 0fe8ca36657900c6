// Solver of d(field)/dt = flux divergence, with the time integrator that the deck chooses.
#ifndef PD_DIFFUSION_SOLVER_HPP
#define PD_DIFFUSION_SOLVER_HPP

#include <Teuchos_RCP.hpp>
#include <string>
#include <vector>

#include "diffusion/rate_integrator.hpp"
#include "diffusion/scalar_fields.hpp"
#include "solver.hpp"

namespace pd {

/// Parameters: `Field`, `Method`, `Load Steps`, and those of the integrator that `Method` names.
class Diffusion : public Solver {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// Throws std::invalid_argument for a key of another method.
  explicit Diffusion(const Teuchos::ParameterList& given);

  using Fields = ScalarFields;
  const Fields& fields() const override { return fields_; }
  double leastSteps(double t0, double t1) const override;
  /// Throws RunError where no material of the run gives a flux divergence of the field.
  void initialize(Simulation& simulation) override;
  void rehearse(Simulation& simulation, double t, double dt) override {
    integrator_->rehearse(simulation, field_, t, dt);
  }
  int numberOfIncrements(Simulation&, double, double) override { return nIncrements_; }
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  RestartState restartState() const override;
  void checkpointWritten() override { integrator_->checkpointWritten(); }
  void setRestartState(const RestartState& state) override { integrator_->setRestartState(state.part(method_)); }
  void modelHasChanged() override { integrator_->modelHasChanged(); }

 private:
  const Teuchos::ParameterList parameters_;
  Fields fields_;
  std::string field_, method_;
  int nIncrements_;
  double nSubSteps_ = 1.0, timeStep_ = 0.0;  ///< as far as they are given; 0 s: not
  Teuchos::RCP<RateIntegrator> integrator_;
};

}  // namespace pd

#endif
