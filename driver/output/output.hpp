// What a run writes: fields (HDF5 + XDMF), histories (CSV), checkpoints, progress, log and the closing report.
#ifndef PD_OUTPUT_HPP
#define PD_OUTPUT_HPP

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../deck/deck.hpp"
#include "../model/model.hpp"
#include "checkpoint.hpp"

namespace pd {

/// Writes the `Output` sections of a deck, evaluates its computes. All calls are collective.
class Output {
 public:
  /// Results go below `folder` (empty: the working folder). Touches no file.
  Output(const Deck& deck, const Communicator& comm, bool isQuiet, const std::string& folder = "");
  ~Output();

  /// Takes the names of the results for this run alone, as long as it lives (ResultLock). Throws DeckError as
  /// checkResults(), RunError where another run has one of them.
  void claim();

  /// Fields that outputs and computes ask for. Creates the computes. Call after the Model is made, so that the fields
  /// of its plug-ins are known by name; hand the result to Model::allocateFields.
  std::vector<int> fieldIds();
  void initialize(Model& model);

  /// Begins with results: those of an earlier run are removed as a whole, or, where `firstStep` is not 0, go on from
  /// that step. What log() has kept so far is written, and the text of the resolved deck.
  void begin(int firstStep, const std::string& resolvedDeck);

  /// What the times of the run are counted in, where that is not "s". Before begin().
  void setTimeUnit(const std::string& unit);

  /// Tells that another solver goes on: its first state counts as an output in decks of Peridigm.
  void startSolver();

  /// After begin(): writes what is due at the end of increment `step` (0: the initial state). `isLast` writes
  /// everything.
  void write(Model& model, int step, int nSteps, double time, bool isLast);

  /// Mesh, bonds and displacements stay as they are up to the next write(), or until the state is said to have changed:
  /// values for the whole body that follow from these alone are evaluated once.
  void stateIsSettled();
  void stateHasChanged();
  /// Evaluates the computes that write() would, and writes nothing.
  void evaluate(Model& model, int step);
  /// Evaluates the computes of whole bodies, whether or not they are due, and writes nothing.
  void evaluateGlobals(Model& model);
  /// Evaluates the compute that makes this value for the whole body, and those whose values that one reads. Others may
  /// count from their last evaluation.
  void evaluateGlobal(Model& model, const std::string& label);
  /// Does a compute make it?
  bool makesGlobal(const std::string& label) const;
  /// As ComputeSet's.
  bool keepsEvaluations(const std::string& label) const;
  /// As ComputeSet's.
  std::string markRead(Model& model, std::vector<char>& isRead) const;
  /// Whether what is written at the end of increment `step` takes the displacements of all points.
  bool needsDisplacements(Model& model, int step, bool isLast) const;
  /// What computes have found out so far; the log has it too.
  const std::vector<std::string>& warnings() const;

  bool isCheckpointDue(int step, bool isLast) const;
  /// Writes the checkpoint of the files that are due (Output key "Checkpoint Frequency").
  void checkpoint(Model& model, const Checkpoint& checkpoint, bool isLast);

  /// A line in the log (and on the terminal unless quiet). Root rank only.
  void log(const std::string& line);
  /// Progress of the increment: a terminal line that replaces itself, at most a few times a second.
  void progress(int step, int nSteps, double time, const std::string& what);

  /// The closing table and <name>.report.json. `errorNorms`: (name, value) of the deck's `Exact Solution`.
  void report(Model& model, const std::vector<std::string>& solverSummary,
              const std::vector<std::pair<std::string, double>>& errorNorms);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Adds to deck.mistakes() why its results cannot be written below `folder`: links that lead elsewhere, files of others
/// that are in the way, folders that cannot be written to. Looks only. Collective.
void checkResults(const Deck& deck, const std::string& folder, const Communicator& comm);

}  // namespace pd

#endif
