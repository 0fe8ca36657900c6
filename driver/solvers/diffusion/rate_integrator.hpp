// Time integrators of one scalar point field whose rate is its flux divergence: what `Method` of the Diffusion solver
// chooses from.
#ifndef PD_RATE_INTEGRATOR_HPP
#define PD_RATE_INTEGRATOR_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "../../../materials/registry/registry.hpp"
#include "../../model/restart_state.hpp"
#include "../../model/simulation.hpp"

namespace pd {

/// Registered by the name that `Method` takes ("Euler", "RKL", ...). The keys that an integrator declares stand beside
/// `Method` in the deck's Diffusion list; those that several integrators declare ("Sub Steps") must mean the same. The
/// integrator's constructor gets its own keys only.
class RateIntegrator {
 public:
  virtual ~RateIntegrator() = default;

  /// Called once when the model is initialised. `field` exists, and so does fluxDivergenceField(field).
  virtual void initialize(Simulation&, const std::string& /*field*/) {}
  /// As Solver::rehearse().
  virtual void rehearse(Simulation&, const std::string& /*field*/, double /*t*/, double /*dt*/) {}
  /// Advances `field` at STEP_NP1, which holds the values at t, to t + dt, ghosts included. Prescribed points hold
  /// their values of the time of each evaluation. Throws RunError where the step is unstable or does not converge.
  virtual void advance(Simulation&, const std::string& field, double t, double dt) = 0;
  /// Lines for the closing report: steps, stages, rejected steps, the limit and the fraction used.
  virtual std::vector<std::string> summary() const { return {}; }

  /// Numbers that a bit-identical restart needs (the step that the controller proposes next). Point data (older levels
  /// of a multi-step method) belong in fields.
  virtual RestartState restartState() const { return {}; }
  virtual void setRestartState(const RestartState& /*state*/) {}
  /// As Solver::checkpointWritten().
  virtual void checkpointWritten() {}
  /// After setRestartState(), as Solver::modelHasChanged().
  virtual void modelHasChanged() {}
};

/// How many equal steps of this length or less an increment takes. Round-off in a step that divides it adds none.
/// Throws RunError where there are more than can be counted.
int equalSteps(double increment, double longestStep);

using RateIntegratorRegistry = PluginRegistry<RateIntegrator, const Teuchos::ParameterList&>;

}  // namespace pd

#define PD_REGISTER_RATE_INTEGRATOR(Class, Name, Brief) PD_REGISTER(pd::RateIntegratorRegistry, Class, Name, Brief)

#endif
