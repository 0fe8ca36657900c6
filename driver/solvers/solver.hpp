// The base class of solvers. A solver advances fields through the plug-in calls; it knows no material by name.
#ifndef PD_SOLVER_HPP
#define PD_SOLVER_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "../../materials/registry/registry.hpp"
#include "../model/restart_state.hpp"
#include "../model/simulation.hpp"

namespace pd {

/// Registered by the name of its list in the deck's Solver section ("Verlet", "Staggered", ...).
class Solver : public FieldUser {
 public:
  /// Fields of points that this solver needs, the plug-ins' among them.
  const FieldTable& fields() const override = 0;
  /// Fields whose far field (BoundaryConditions::farField) this solver takes into account.
  virtual std::vector<std::string> fieldsWithFarField() const { return {}; }
  /// Whether it asks materials for their mass density.
  virtual bool needsDensity() const { return false; }
  /// How many steps it takes from t0 to t1 at least, as far as its parameters alone tell. Throws RunError where they
  /// cannot divide that time.
  virtual double leastSteps(double /*t0*/, double /*t1*/) const { return 1.0; }
  /// Called once when the model is initialised.
  virtual void initialize(Simulation&) {}
  /// For a check, after initialize(): throws RunError where advance() could not take the first increment, as far as
  /// that is quick to see. The state stays as it is.
  virtual void rehearse(Simulation&, double /*t*/, double /*dt*/) {}
  /// Number of increments from t0 to t1 (a load step, a time step: what output frequencies count).
  virtual int numberOfIncrements(Simulation&, double t0, double t1) = 0;
  /// End of increment 1 ... nIncrements between t0 and t1; of increment 0, the start. Equal lengths unless a solver
  /// says otherwise.
  virtual double incrementEnd(int increment, int nIncrements, double t0, double t1) const {
    return t0 + (t1 - t0) * increment / nIncrements;
  }
  /// Advances all fields from t to t + dt, in one step or several, each of which it accepts (Model::acceptStep). Throws
  /// RunError where it cannot.
  virtual void advance(Simulation&, double t, double dt) = 0;
  /// Lines for the log at the end of the run ("critical time step 1.2e-8 s, used 0.85 of it").
  virtual std::vector<std::string> summary() const { return {}; }

  /// State beyond the fields that a bit-identical restart needs.
  virtual RestartState restartState() const { return {}; }
  /// A checkpoint has been written: what follows must not depend on more than it holds, so that a run that is taken up
  /// from it is the same to the last bit. Caches of what the past has been are renewed here.
  virtual void checkpointWritten() {}
  /// After initialize(); `state` has the names of restartState(). The increments that follow may be others than before.
  virtual void setRestartState(const RestartState& /*state*/) {}
  /// After setRestartState(): materials, conditions or bonds of the deck are others now. What was estimated from them
  /// (a critical step, an eigenvalue, a tangent) is to be found anew.
  virtual void modelHasChanged() {}
  /// Other solvers have worked on the fields since this one last advanced.
  virtual void fieldsHaveChanged() {}
};

using SolverRegistry = PluginRegistry<Solver, const Teuchos::ParameterList&>;

}  // namespace pd

#define PD_REGISTER_SOLVER(Class, Name, Brief) PD_REGISTER(pd::SolverRegistry, Class, Name, Brief)

#endif
