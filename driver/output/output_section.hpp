// One `Output` section of a deck: what is written, when, under which name.
#ifndef PD_OUTPUT_SECTION_HPP
#define PD_OUTPUT_SECTION_HPP

#include <set>
#include <string>
#include <vector>

#include "../deck/deck.hpp"

namespace pd {

struct OutputVariable {
  std::string label;
  std::string place;  ///< in the deck
};

struct OutputSection {
  std::string fileName;      ///< path of the files without their endings
  std::string place;         ///< of that name in the deck
  int frequency = -1;        ///< of fields, in increments; -1: none
  std::set<int> steps;       ///< further increments whose fields are written
  int firstStep = 0;         ///< nothing is written before
  int lastStep = 0;          ///< or after
  int historyFrequency = 1;  ///< of values for the whole body; -1: none
  int checkpointFrequency = -1;
  bool countsStarts = false;  ///< the initial state of each solver is an output of its own, as in Peridigm
  int nStarts = 0;            ///< of solvers after the first so far, where they count
  std::vector<OutputVariable> variables;

  bool writesFields() const { return frequency > 0 || !steps.empty(); }
  bool areFieldsDue(int step, bool isLast) const;
  bool isHistoryDue(int step, bool isLast) const;
  /// Tells that another solver goes on.
  void startSolver() { nStarts += countsStarts ? 1 : 0; }
  bool isCheckpointDue(int step, bool isLast) const;

 private:
  bool isInRange(int step) const;
};

/// All sections whose name contains "Output", as in Peridigm, in the order of the deck. The deck has been checked.
///
/// Peridigm counts the initial state as output 1, so its `Initial Output Step` n is our step n - 1, counts the state
/// from which each further solver starts again, and writes values for the whole body as often as fields; all this holds
/// for decks of Peridigm.
/// Results lie below `folder` (empty: the working folder).
std::vector<OutputSection> readOutputSections(const Deck& deck, const std::string& folder = "");

/// Path of the files of the first section without their endings; where the deck has no section, the name of the deck.
std::string mainOutputName(const Deck& deck, const std::vector<OutputSection>& sections,
                           const std::string& folder = "");

}  // namespace pd

#endif
