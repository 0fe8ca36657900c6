// Where a run goes on from the time of a checkpoint.
#ifndef PD_RESTART_HPP
#define PD_RESTART_HPP

#include <set>
#include <string>
#include <vector>

#include "../output/checkpoint.hpp"
#include "stage.hpp"

namespace pd {

class Restart {
 public:
  /// Reads `fileName` into the model; where its materials, conditions or bonds are not those of this deck, what
  /// plug-ins make of the deck stays. `deck`: text of the resolved deck; `timeUnit`: of its times, for messages. Throws
  /// RunError as readCheckpoint() does. Collective.
  Restart(Model& model, const std::string& fileName, const std::string& deck, std::string timeUnit);

  int step() const { return checkpoint_.step; }
  double time() const { return checkpoint_.time; }
  /// What the log is to say of it, after findStage(): step and time, in what the deck differs from the one that wrote
  /// it, and which state the checkpoint does not have.
  std::vector<std::string> notes() const;
  /// What the report is to say of the numbers that follow.
  std::string whatCounts() const;

  /// Finds the stage that goes on: the one whose times contain that of the checkpoint. A stage that begins at that time
  /// begins as after another stage. Throws RunError with a remedy where there is none, or where it needs what the
  /// checkpoint has not: the state of its solver, the solver's fields, those in `ofPlugins`, or, where conditions are
  /// what they were, those in `ofConditions`.
  std::size_t findStage(const std::vector<Stage>& stages, const std::set<std::string>& ofPlugins,
                        const std::set<std::string>& ofConditions);
  /// Hands the state to the solver of the stage found, after it was initialised; nothing where the stage only begins.
  void setState(Solver& solver) const;
  /// How many of the increments of the stage found, as the deck now has them, end by the time of the checkpoint. Throws
  /// RunError where all do and the stage `isLast`.
  int incrementsDone(const Stage& stage, int nIncrements, bool isLast) const;
  /// When the first increment that is left begins: the time of the checkpoint.
  double startTime(const Stage& stage) const { return beginsStage_ ? stage.startTime : time(); }

 private:
  bool isReached(double end, double margin) const;
  void requireFields(const Stage& stage, std::set<std::string> needed) const;
  void requireState(const Stage& stage) const;
  [[noreturn]] void refuseAsOver(const Stage& last) const;
  std::string name() const;

  std::string fileName_, timeUnit_;
  Checkpoint checkpoint_;
  std::vector<std::string> differences_;
  std::set<std::string> startsAfresh_;  ///< labels of fields
  bool isSameDeck_ = true, isSameModel_ = true;
  bool beginsStage_ = false;
};

/// Labels of all fields that some block of the model has.
std::set<std::string> fieldLabels(Model& model);

}  // namespace pd

#endif
