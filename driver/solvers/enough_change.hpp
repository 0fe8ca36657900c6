// How much change is enough for a solver to run again.
#ifndef PD_ENOUGH_CHANGE_HPP
#define PD_ENOUGH_CHANGE_HPP

#include <array>
#include <string>

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

  /// Throws RunError where no compute gives the value, or one that keeps what its last evaluation found.
  void initialize(Simulation& simulation, const std::string& owner);
  double amount() const { return amount_; }  ///< unit of the field, or that times m3
  bool isControlled() const { return !label_.empty(); }
  /// The solver has run after that change.
  void solverHasRun(double change);
  /// Before the next load step, when computes see a whole step: takes up what the last run has made of the value.
  /// Changes of it that are rounding or no numbers teach nothing. Collective.
  void look(Simulation& simulation, const std::string& owner);
  /// Of the value from run to run, over its size; without that of the last run, after which nobody looks.
  double largestChange() const { return largestChange_; }
  const std::string& label() const { return label_; }  ///< of the value

  RestartState restartState() const;
  void setRestartState(const RestartState& state);

 private:
  double amount_ = 0.0, wanted_ = 0.0;
  double largestChange_ = 0.0;
  std::string label_;    ///< empty: the amount stays
  bool hasRun_ = false;  ///< since the last look()
  double change_ = 0.0;  ///< before that run
  bool hasValue_ = false, hasWarned_ = false;
  std::array<double, 3> value_{};  ///< of the run before, where hasValue_; of a scalar the first
};

}  // namespace pd

#endif
