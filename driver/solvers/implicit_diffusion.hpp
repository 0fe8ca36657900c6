// The steady state of a diffusing scalar, load step by load step.
#ifndef PD_IMPLICIT_DIFFUSION_HPP
#define PD_IMPLICIT_DIFFUSION_HPP

#include <memory>
#include <string>
#include <vector>

#include "../linear/linear_system.hpp"
#include "damage_watch.hpp"
#include "diffusion/scalar_fields.hpp"
#include "flow_fields.hpp"
#include "linear_solver_settings.hpp"
#include "load_steps.hpp"
#include "solver.hpp"

namespace pd {

/// At the end of each load step the flux divergence vanishes at all points whose value is not prescribed, by Newton's
/// method: one linear solve where the flux is linear in the field. Times only say which values are prescribed.
///
/// Points that exchange nothing with a prescribed one, on however long a way, keep their values; the log counts them.
/// After a load step the flux divergence is complete at prescribed points too: times the volume it is what flows in
/// there.
class ImplicitDiffusion : public Solver {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit ImplicitDiffusion(const Teuchos::ParameterList& given);

  struct Fields : ScalarFields {
    FieldHandle limitedAt;
    explicit Fields(const Teuchos::ParameterList& parameters) : ScalarFields(parameters) {
      limitedAt = writes(pd::fields::limitedAt(parameters.get<std::string>("Field")));
    }
  };
  const Fields& fields() const override { return fields_; }
  /// Throws RunError where no material of the run gives a flux divergence of the field.
  double leastSteps(double t0, double t1) const override { return loadSteps_.count(t0, t1); }
  void initialize(Simulation& simulation) override;
  void rehearse(Simulation& simulation, double t, double dt) override;
  int numberOfIncrements(Simulation&, double t0, double t1) override { return loadSteps_.count(t0, t1); }
  double incrementEnd(int increment, int nIncrements, double t0, double t1) const override {
    return loadSteps_.end(increment, nIncrements, t0, t1);
  }
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  /// A matrix of values that the checkpoint has no more leads to others in the last digits.
  void checkpointWritten() override { hasMatrix_ = false; }
  RestartState restartState() const override { return {{"load steps", static_cast<double>(nLoadSteps_)}}; }
  void setRestartState(const RestartState& state) override {
    nLoadSteps_ = static_cast<long long>(state["load steps"]);
  }

 private:
  struct Balance {
    double free = 0.0, held = 0.0;  ///< norms of what flows into free and into prescribed points, per second
  };
  void findHeldPoints(Simulation& simulation);
  void requireNoFluxOutOfReach(Simulation& simulation, double t) const;
  void evaluateFlux(Model& model, double dt);
  Balance evaluate(Simulation& simulation, double dt);
  bool keepsToLimits(Simulation& simulation, double dt, double target);
  [[noreturn]] void giveUp(Simulation& simulation, double t, int iterations, const Balance& balance,
                           double target) const;
  void assemble(Simulation& simulation, double dt);
  void solveLinear(Simulation& simulation, double tolerance);
  double largestValue(Simulation& simulation) const;

  const Teuchos::ParameterList parameters_;
  Fields fields_;
  std::string field_, fluxField_;
  LoadSteps loadSteps_;
  LinearSolverSettings linear_;
  int maximumIterations_;
  double relativeTolerance_ = 1e-6, absoluteTolerance_ = 0.0;

  std::unique_ptr<LinearSystem> system_;
  std::vector<char> isPrescribed_, isHeld_;  ///< [points] isHeld_: prescribed, or out of reach
  BondDamageSum bondDamageSum_;
  double bondDamage_ = -1.0;  ///< sum over all bonds when isHeld_ was found
  bool hasMatrix_ = false;
  /// Slopes of what a flow carries are limited at other values than the present ones, and how often these have been
  /// moved in a load step.
  bool holdsLimits_ = false;
  int nHolds_ = 0;
  double stiffness_ = 0.0;               ///< norm of the diagonal of the matrix over free points
  std::vector<double> residual_, step_;  ///< [nOwned]
  long long nLoadSteps_ = 0, nSolves_ = 0, nLinearIterations_ = 0, nMatrices_ = 0, nOutOfReach_ = 0;
  double largestResidual_ = 0.0, largestByLimits_ = 0.0;  ///< relative
};

}  // namespace pd

#endif
