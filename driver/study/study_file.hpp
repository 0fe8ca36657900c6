// A study: one deck, many runs, and what is asked of each.
#ifndef PD_STUDY_FILE_HPP
#define PD_STUDY_FILE_HPP

#include <string>
#include <utility>
#include <vector>

#include "../../materials/registry/parameters.hpp"
#include "../deck/deck.hpp"

namespace pd {

/// A value of the deck that is another in a run.
struct StudyOverride {
  std::string path, value;  ///< the value on one line, in YAML
  std::string place;        ///< of the value in the file of the study; empty where the command line gives it

  std::string text() const { return path + "=" + value; }  ///< as on the command line
};

struct StudyRun {
  std::string label;  ///< of its series
  std::string place;  ///< of its series in the file
  std::vector<StudyOverride> overrides;
  std::vector<std::pair<std::string, std::string>> swept;  ///< path and value of what differs within its series; once
                                                           ///< checked, numbers are in the units of their keys
  std::string outputName;                                  ///< of its result files, "<study>.study/<series>_<run>"
};

/// A result for the whole body over time, which each run writes into its CSV file.
struct StudyHistory {
  std::string name, place;           ///< as the study has it
  std::vector<std::string> columns;  ///< of the CSV file: the name itself, or the components of the vector
};

/// What the table tells of a history.
struct HistoryValue {
  enum Kind { Final, Maximum, Minimum, TimeOfMaximum };
  static const std::vector<std::string>& names();  ///< in the order of Kind, as studies write them
};

/// A file of this form:
///   Deck: plate.yaml          # seen from the folder of the study
///   Name: plate               # of the results; the name of the file by default
///   Reference: exact solution # what the error is taken against, for table and picture
///   Error: L2                 # part of the name of one error norm of the deck's Exact Solution
///   Histories: [Top_Reaction] # columns of the CSV files of the runs
///   History Values: [Maximum] # what the table tells of each
///   Series:
///     - Label: Euler
///       Overrides: {Solver/Diffusion/Method: Euler}
///       Sweep: {Solver/Diffusion/Sub Steps: [80, 160, 320]}    # one run for each; several lists go side by side
/// with Error and Reference, or Histories, or both.
struct Study {
  std::string fileName, deckFile, name;
  std::string errorNorm, errorPlace, reference;  ///< empty where no error is asked for
  std::vector<StudyHistory> histories;
  std::vector<HistoryValue::Kind> historyValues;
  std::vector<StudyRun> runs;
};

const ParameterDeclarations& studyDeclarations();        ///< but for its Series
const ParameterDeclarations& studySeriesDeclarations();  ///< an entry of Series; Overrides and Sweep hold deck paths

/// Reads the study, with `overrides` (path=value) added to each run, and adds all mistakes of the file; what they leave
/// can be checked further. The columns of its histories are known once its runs have been checked. Throws DeckError
/// where the file is no YAML.
Study readStudy(const std::string& fileName, const std::vector<std::string>& overrides, Mistakes& mistakes);

}  // namespace pd

#endif
