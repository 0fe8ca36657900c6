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
  /// `isRestart`: the log goes on where the restarted run stopped.
  Output(const Deck& deck, const Communicator& comm, bool isQuiet, bool isRestart = false);
  /// For a check: no file, no log, nothing on the terminal.
  Output(const Deck& deck, const Communicator& comm);
  ~Output();

  /// Fields that outputs and computes ask for. Creates the computes. Call after the Model is made, so that the fields
  /// of its plug-ins are known by name; hand the result to Model::allocateFields.
  std::vector<int> fieldIds();
  void initialize(Model& model);

  /// Tells that another solver goes on: its first state counts as an output in decks of Peridigm.
  void startSolver();

  /// Writes what is due at the end of increment `step` (0: the initial state). `isLast` writes everything. Where the
  /// first call is not for step 0, the files of the restarted run are continued from that step on.
  void write(Model& model, int step, int nSteps, double time, bool isLast);

  /// Evaluates the computes that write() would, and writes nothing.
  void evaluate(Model& model, int step);

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

}  // namespace pd

#endif
