// How much change is enough for a solver to run again.
#ifndef PD_ENOUGH_CHANGE_HPP
#define PD_ENOUGH_CHANGE_HPP

#include <string>
#include <vector>

#include "solver.hpp"

namespace pd {

/// Of what a part of Staggered watches (`When`): an amount that the deck gives, or, with a `Value` that a compute makes
/// of the solver's result, such as the drag of a flow, the amount that changes it by `Value Change`. After each run the
/// amount becomes what would have changed the value by that part of it, were both proportional.
class EnoughChange {
 public:
  static void declareParameters(ParameterDeclarations& when);
  EnoughChange() = default;
  explicit EnoughChange(const Teuchos::ParameterList& when);

  /// Throws RunError where no compute gives the value.
  void initialize(Model& model, const std::string& owner) const;
  double amount() const { return amount_; }  ///< unit of the field, or that times m3
  bool isControlled() const { return !label_.empty(); }
  /// The solver has run after that change.
  void solverHasRun(double change);
  /// Before the next load step, when computes see a whole step: takes up what the last run has made of the value.
  /// Collective.
  void look(Simulation& simulation, const std::string& owner);

  RestartState restartState() const;
  void setRestartState(const RestartState& state);

 private:
  double amount_ = 0.0, wanted_ = 0.0;
  std::string label_;          ///< empty: the amount stays
  bool hasRun_ = false;        ///< since the last look()
  double change_ = 0.0;        ///< before that run
  std::vector<double> value_;  ///< of the run before; empty: there is none
};

}  // namespace pd

#endif
