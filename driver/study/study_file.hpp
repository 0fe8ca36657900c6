// A study: one deck, many runs, and the error of each.
#ifndef PD_STUDY_FILE_HPP
#define PD_STUDY_FILE_HPP

#include <string>
#include <vector>

namespace pd {

struct StudyRun {
  std::string label;                   ///< of its series
  std::string place;                   ///< of its series in the file
  std::vector<std::string> overrides;  ///< "path=value", as on the command line
  std::string outputName;              ///< of its result files, "<study>.study/<series>_<run>"
};

/// A file of this form:
///   Deck: plate.yaml          # seen from the folder of the study
///   Name: plate               # of the results; the name of the file by default
///   Reference: exact solution # what the error is taken against, for table and picture
///   Error: L2                 # part of the name of one error norm of the deck's Exact Solution
///   Series:
///     - Label: Euler
///       Overrides: {Solver/Diffusion/Method: Euler}
///       Sweep: {Solver/Diffusion/Sub Steps: [80, 160, 320]}    # one run for each; several lists go side by side
struct Study {
  std::string deckFile, name, reference, errorNorm;
  std::vector<StudyRun> runs;
};

/// Reads the study and checks the deck of every run, with `overrides` added to each; throws DeckError with all
/// mistakes.
Study readStudy(const std::string& fileName, const std::vector<std::string>& overrides);

}  // namespace pd

#endif
