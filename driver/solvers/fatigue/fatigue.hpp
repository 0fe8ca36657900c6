// Fatigue: cycles of load take life of bonds, from one failure to the next.
#ifndef PD_FATIGUE_HPP
#define PD_FATIGUE_HPP

#include <string>
#include <vector>

#include "../damage_watch.hpp"
#include "../event_solver.hpp"
#include "crack_control.hpp"
#include "cycle_fields.hpp"
#include "equilibrium.hpp"
#include "load_blocks.hpp"

namespace pd {

/// The time of the solver is counted in cycles: a second of the run is one. Conditions give the largest load of a
/// cycle. A step finds how long the next bond lives at the present strains, lets so many cycles pass, breaks the bonds
/// whose life is over, and finds equilibrium again, also after bonds that break at once by the damage model's static
/// limit. With `Cycles Per Block` steps have that length, and are halved where bonds would live on for more than a
/// tenth of a life after their end.
class Fatigue : public EventSolver {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  explicit Fatigue(const Teuchos::ParameterList& given);

  struct Fields : Equilibrium::Fields {
    FieldHandle cycles = writes(pd::fields::cycleIncrement());
    FieldHandle range = writes(pd::fields::loadRange());
    FieldHandle peak = writes(pd::fields::peakLoad());
    FieldHandle lossRate = reads(pd::fields::lifeLossRate());
    FieldHandle overdrawn = reads(pd::fields::overdrawnLife());
    FieldHandle lifeLeft = reads(pd::fields::lifeLeft());
    FieldHandle rateOfFailed = reads(pd::fields::rateOfFailed());
    FieldHandle overdrawRate = reads(pd::fields::overdrawRate());
    FieldHandle firstBreak =
        writes(pd::fields::pointScalar("Cycles_To_First_Break", "1",
                                       "Cycles until the first bond of the point broke; 0 where none has.")
                   .state());
    explicit Fields(const CrackControl& control) { include(control.fields()); }
  };
  static FieldTable describeFields();
  const Fields& fields() const override { return fields_; }
  double leastSteps(double t0, double t1) const override;
  void initialize(Simulation& simulation) override;
  void rehearse(Simulation& simulation, double t, double dt) override;
  int numberOfIncrements(Simulation& simulation, double t0, double t1) override;
  double incrementEnd(int increment, int nIncrements, double t0, double t1) const override;
  double advanceToEvent(Simulation& simulation, double t, double end) override;
  bool fieldsAreComplete() const override { return equilibrium_.isComplete(); }
  void completeFields(Simulation& simulation, double t) override;
  std::string reasonToStop() const override { return reasonToStop_; }
  const char* timeUnit() const override { return "cycles"; }
  std::vector<std::string> summary() const override;
  RestartState restartState() const override;
  void checkpointWritten() override { equilibrium_.forgetHistory(); }
  void setRestartState(const RestartState& state) override;
  void fieldsHaveChanged() override { isSettled_ = ratesAreKnown_ = false; }

 private:
  struct Worst {
    double lossRate, overdrawn;
  };
  /// Damage, and lost lives, after so many cycles at the present strains. Returns whether bonds have broken.
  bool passCycles(Simulation& simulation, double cycles);
  bool breakAtOnce(Simulation& simulation, double t);
  Worst worst(Model& model) const;
  double passBlock(Simulation& simulation, double cycles, bool& hasBroken);
  double passToFailure(Simulation& simulation, double cycles, double most, bool& hasBroken);
  void start(Simulation& simulation, double t);
  /// Equilibrium at the load of time t; bonds break and it is found again until none breaks.
  void settle(Simulation& simulation, double t, bool fromRest);
  bool findEquilibrium(Simulation& simulation, double t, bool fromRest);
  void noteBreakage(Simulation& simulation, double t);
  void watchLoad(Simulation& simulation, double rateBefore, double cycles, double reached);
  /// Load of the cycles after t, by blocks and by what the crack asks for.
  void setLoad(Simulation& simulation, double t);

  CrackControl control_;
  Fields fields_;
  LoadBlocks loads_;
  Equilibrium equilibrium_;
  double cyclesPerBlock_ = 0.0;  ///< 0: from event to event
  int nIntervals_, maximumPasses_;
  std::string reasonToStop_;

  bool hasStarted_ = false, isSettled_ = false;
  bool ratesAreKnown_ = false;     ///< Life_Loss_Rate is that of the present strains and loads
  bool hasBrokenOutside_ = false;  ///< at once, at strains that were estimates
  int nLoadedParts_ = 0;
  BondDamageSum bondDamageSum_;
  double bondDamage_ = 0.0;  ///< sum over all bonds
  double firstBreak_ = 0.0;  ///< cycles
  std::array<double, 3> firstPlace_{};
  double misjudgedLife_ = 0.0;  ///< of the worst bonds, by loads that changed within steps; parts of a life
  long long nEvents_ = 0, nBroken_ = 0, nHalved_ = 0, nPasses_ = 0;
};

}  // namespace pd

#endif
