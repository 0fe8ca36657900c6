// Explicit dynamics: central differences in the form of velocity Verlet.
#ifndef PD_VERLET_HPP
#define PD_VERLET_HPP

#include <string>
#include <vector>

#include "mechanics.hpp"
#include "solver.hpp"

namespace pd {

/// v += dt/2 (a - c v), u += dt v, a from the new u, v = (v + dt/2 a) / (1 + c dt/2). Stable for dt < 2 / omega_max.
class Verlet : public Solver {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit Verlet(const Teuchos::ParameterList& given);

  struct Fields : MechanicsFields {
    FieldHandle velocity = writes(pd::fields::velocity());
  };
  const Fields& fields() const override { return fields_; }
  bool needsDensity() const override { return true; }
  double leastSteps(double t0, double t1) const override { return fixedStep_ > 0.0 ? (t1 - t0) / stepToUse() : 1.0; }
  /// Estimates the critical time step. Throws RunError where "Fixed dt" is above it.
  void initialize(Simulation& simulation) override;
  int numberOfIncrements(Simulation& simulation, double t0, double t1) override;
  /// Equal steps that meet t1; Peridigm's rule keeps the step and stops at or before t1.
  double incrementEnd(int increment, int nIncrements, double t0, double t1) const override;
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  RestartState restartState() const override;
  void setRestartState(const RestartState& state) override;
  void modelHasChanged() override { criticalStep_ = estimatedStep_; }
  void fieldsHaveChanged() override;

 private:
  void estimateCriticalStep(Simulation& simulation);
  void updateMasses(Simulation& simulation);
  void evaluateForce(Simulation& simulation, double t, double dt);
  double stepToUse() const;

  Fields fields_;
  double fixedStep_ = 0.0;  ///< 0: not given
  double safetyFactor_, damping_;
  bool allowUnstableStep_, usesBulkModulus_;
  double criticalStep_ = 0.0, usedStep_ = 0.0;
  double estimatedStep_ = 0.0;  ///< critical step as it was found in this process
  std::string warning_;         ///< of a body that is unstable at the start; empty otherwise
  int step_ = 0;
  bool forceIsCurrent_ = false;
  bool damageIsCurrent_ = false;        ///< that of the end of the last step
  std::vector<double> inverseDensity_;  ///< [3 nOwned] 0 where held
  std::vector<double> externalForce_;   ///< [3 nOwned]
};

}  // namespace pd

#endif
