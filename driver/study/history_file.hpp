// The histories that a run has written. Private to this folder.
#ifndef PD_HISTORY_FILE_HPP
#define PD_HISTORY_FILE_HPP

#include <map>
#include <string>
#include <vector>

#include "study_file.hpp"

namespace pd {

/// Columns of the CSV file of a run by name, "time" among them. Throws RunError.
std::map<std::string, std::vector<double>> readHistory(const std::string& fileName);

/// What the rows of a column come to; values that are not finite do not count. Not a number where none are left.
double valueOf(const std::vector<double>& column, const std::vector<double>& time, HistoryValue::Kind kind);

}  // namespace pd

#endif
