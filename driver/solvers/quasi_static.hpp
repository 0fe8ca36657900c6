// Static equilibrium, load step by load step, by Newton's method; bonds break between equilibria.
#ifndef PD_QUASI_STATIC_HPP
#define PD_QUASI_STATIC_HPP

#include <memory>
#include <string>
#include <vector>

#include "damage_watch.hpp"
#include "load_steps.hpp"
#include "loose_parts.hpp"
#include "newton.hpp"
#include "solver.hpp"

namespace pd {

/// A load step: equilibrium at constant damage, then all bonds break that exceed their limit in it, then equilibrium
/// again, until no bond breaks any more. A load step without equilibrium is halved.
///
/// Points without bonds and parts that nothing holds (loose fragments, supports that are too few) stay where they are
/// as far as they could move as rigid bodies; the log says which. A load that only this would carry ends the run.
class QuasiStatic : public Solver {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit QuasiStatic(const Teuchos::ParameterList& given);

  struct Fields : Newton::Fields {
    FieldHandle increment = writes(pd::fields::pointVector(
        "Displacement_Increment", "m", "Displacement in the load step before, from which the next is predicted."));
    FieldHandle velocity;
    explicit Fields(const Teuchos::ParameterList& parameters) {
      if (parameters.get<bool>("Velocity From Increments")) velocity = writes(pd::fields::velocity());
    }
  };
  const Fields& fields() const override { return fields_; }
  double leastSteps(double t0, double t1) const override { return loadSteps_.count(t0, t1); }
  void initialize(Simulation& simulation) override;
  void rehearse(Simulation& simulation, double t, double dt) override;
  int numberOfIncrements(Simulation& simulation, double t0, double t1) override;
  double incrementEnd(int increment, int nIncrements, double t0, double t1) const override;
  void advance(Simulation& simulation, double t, double dt) override;
  std::vector<std::string> summary() const override;
  RestartState restartState() const override;
  void checkpointWritten() override { newton_.forgetHistory(); }
  void setRestartState(const RestartState& state) override;
  void modelHasChanged() override { mustRestoreTangent_ = false; }
  void fieldsHaveChanged() override { looksForBreakage_ = true; }

 private:
  void findLooseParts(Simulation& simulation);
  /// Finds loose parts, anew where other solvers have broken bonds since the last load step.
  void takeUpBreakage(Simulation& simulation);
  /// Throws RunError where a load acts on parts that nothing but held_ holds.
  void requireHeldLoads(Simulation& simulation, double t) const;
  /// Adds the increment of the load step before, in proportion to the length.
  void extrapolate(Simulation& simulation, double dt);
  /// Equilibrium at constant damage, from the present displacements. False where there is none.
  bool reachEquilibrium(Simulation& simulation, double dt);
  void advanceInParts(Simulation& simulation, double t, double dt, int nHalvings);
  void breakBonds(Simulation& simulation, double t, double dt);
  [[noreturn]] void fail(double t, const std::string& when) const;

  const Teuchos::ParameterList parameters_;
  Fields fields_;
  LoadSteps loadSteps_;
  int maximumBreakagePasses_, maximumHalvings_;
  Newton newton_;
  HeldInPlace held_;
  bool hasLookedForParts_ = false;  ///< held_ has been found
  NewtonOutcome outcome_;
  std::vector<double> externalForce_;  ///< [3 nOwned] N/m3

  int loadStep_ = 0;
  double largestScale_ = 0.0;  ///< N
  double lastLength_ = 0.0;    ///< of the increment that the next one is predicted from, s; 0: none
  BondDamageSum bondDamageSum_;
  double bondDamage_ = 0.0;  ///< sum over all bonds after the last load step
  bool mustRestoreTangent_ = false, looksForBreakage_ = false;
  long long nPasses_ = 0, nHalvings_ = 0, mostPasses_ = 0;
};

}  // namespace pd

#endif
