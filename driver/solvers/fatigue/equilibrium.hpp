// Static equilibrium of a body whose bonds break from time to time, for solvers that do not load it step by step.
#ifndef PD_EQUILIBRIUM_HPP
#define PD_EQUILIBRIUM_HPP

#include <string>
#include <vector>

#include "../loose_parts.hpp"
#include "../newton.hpp"
#include "event_window.hpp"

namespace pd {

/// Says why no displacements were found in which all forces balance.
struct NoEquilibrium : RunError {
  NoEquilibrium(const std::string& message, const NewtonOutcome& outcome)
      : RunError(message), trouble(outcome.trouble), iterationsAreUsedUp(outcome.iterationsAreUsedUp) {}
  std::string trouble;       ///< Newton's
  bool iterationsAreUsedUp;  ///< more of them might find it
};

/// Newton's method with what it needs around it: parts that nothing holds stay in place, loads on them are refused.
/// Between checkpoints the tangent of springs is kept as long as it is good.
class Equilibrium {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// From a completed list; `solver`: for messages.
  Equilibrium(const Teuchos::ParameterList& parameters, std::string solver);

  struct Fields : Newton::Fields {
    FieldHandle firstDisplacement = writes(pd::fields::pointVector(
        "First_Loaded_Displacement", "m", "In the first equilibrium under loads: what bears them yields beside it."));
  };

  /// Finds what holds which part of the body. Collective.
  void findSupports(Simulation& simulation);
  bool hasSupports() const { return hasSupports_; }
  /// For when bonds may have broken: whether what has broken is known to have parted nothing, so that supports are as
  /// they were. Collective.
  bool keepsTogether();
  /// Throws RunError where the deck asks for springs, and the materials have none.
  void requireSprings(Model& model) const { newton_.requireSprings(model); }
  /// As Newton's.
  void startIncrement(Simulation& simulation) { newton_.startIncrement(simulation.model); }
  void forgetHistory();
  /// Throws RunError where the deck asks for a window that the run can have none of.
  void requireWindow(Simulation& simulation);
  /// Parts of more than 1 % of the points that loads or prescribed displacements act on at time t. Collective.
  int countLoadedParts(Simulation& simulation, double t);
  /// Loads at time t on parts that nothing holds; empty where there are none. Collective.
  std::string loadsNothingHolds(Simulation& simulation, double t);
  /// Throws RunError where there are such.
  void requireHeldLoads(Simulation& simulation, double t);
  /// Whether the last equilibrium carries next to nothing of the largest load or reaction so far.
  bool carriesNothing() const { return carried_ < 1e-3 * largestScale_; }
  /// After a search at time t that has failed: how many times as far as in the first equilibrium that of the loads had
  /// moved, per newton, in the one before which has moved most; 0: there are none. Collective.
  double yielded(Simulation& simulation, double t) const;
  /// From the undeformed body, loads and prescribed displacements of time t. Throws NoEquilibrium where there is none.
  void findFromRest(Simulation& simulation, double t);
  /// From the present displacements; with a window perhaps around the tip alone. Throws NoEquilibrium where there is
  /// none.
  void find(Simulation& simulation, double t);
  bool isComplete() const { return isComplete_; }
  /// Finds the displacements of all points, where find() has not. Returns whether they have changed.
  bool complete(Simulation& simulation, double t);
  /// Whether Damage has changed, in the present step, where find() has but estimated displacements.
  bool breaksOutsideWindow(Model& model) const;
  /// The same where computes of whole bodies look at points that find() has left out. `areEvaluated`: in this state.
  bool completeForComputes(Simulation& simulation, double t, bool areEvaluated);

  std::vector<std::string> summary() const;
  RestartState restartState() const;
  void setRestartState(const RestartState& state);

 private:
  void solve(Simulation& simulation, double t);
  /// Of loads or reactions, N; writes workOfReactions_.
  double carriedForce(Simulation& simulation);
  /// For the first equilibrium under loads: remembers it.
  void noteFirstLoads(Model& model, double t);
  bool wholeIsDue() const;

  Fields fields_;
  std::string solver_;
  Newton newton_;
  HeldInPlace held_;
  bool hasSupports_ = false;
  std::unique_ptr<EventWindow> window_;  ///< null: none is asked for
  bool isComplete_ = true;               ///< displacements are those of all points
  bool isOfTheseBonds_ = true;           ///< they are those of the bonds that there are
  std::vector<double> externalForce_;    ///< [3 nOwned] N/m3
  double largestScale_ = 0.0;            ///< N
  double carried_ = 0.0;                 ///< N, norm of loads or reactions of the last equilibrium of the whole body
  double carriedBefore_ = 0.0;           ///< N, of the one before; 0: none
  double workOfReactions_ = 0.0;         ///< J, the energy of a body without other loads
  bool hasBeenLoaded_ = false;
  double firstLoadedAt_ = 0.0;  ///< cycles: of the first equilibrium under loads
  long long nSolutions_ = 0;
  double largestResidual_ = 0.0;  ///< relative
};

}  // namespace pd

#endif
