// The table of a study: a row a run, on the terminal and in a CSV file. Private to this folder.
#ifndef PD_STUDY_TABLE_HPP
#define PD_STUDY_TABLE_HPP

#include <string>
#include <vector>

#include "study_file.hpp"

namespace pd {

/// What a run has come to.
struct StudyResult {
  double error = 0.0;  ///< where the study asks for one
  double seconds = 0.0;
  long long bondUpdates = 0;
  std::vector<double> historyValues;  ///< each value of each column of each history, in this order
};

class StudyTable {
 public:
  explicit StudyTable(const Study& study);

  /// The heading, and a row, on the terminal: series, values that are swept, results. A run that has failed has no
  /// result.
  std::string heading() const;
  std::string row(const StudyRun& run, const StudyResult* result) const;

  /// The same as CSV (RFC 4180), with all overrides, and the names of the result files.
  std::string csvHeading() const;
  std::string csvRow(const StudyRun& run, const StudyResult* result) const;

 private:
  std::vector<std::string> sweptValues(const StudyRun& run) const;  ///< empty where its series does not sweep the path

  const Study& study_;
  std::vector<std::string> sweptPaths_;  ///< of all series
  std::vector<std::string> valueNames_;  ///< "Maximum Top_ReactionY"
  std::size_t labelWidth_ = 0;
  std::vector<std::size_t> sweptWidths_;
};

}  // namespace pd

#endif
