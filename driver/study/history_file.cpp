#include "history_file.hpp"

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <sstream>

#include "../output/atomic_file.hpp"

namespace pd {

std::map<std::string, std::vector<double>> readHistory(const std::string& fileName) {
  std::ifstream file(fileName);
  if (!file) throwFileError("read", fileName, errno);
  std::string line, word;
  std::vector<std::string> names;
  std::getline(file, line);
  for (std::istringstream header(line); std::getline(header, word, ',');) names.push_back(word);
  std::map<std::string, std::vector<double>> columns;
  while (std::getline(file, line)) {
    std::istringstream row(line);
    for (const std::string& name : names)
      if (std::getline(row, word, ',')) columns[name].push_back(std::strtod(word.c_str(), nullptr));
  }
  return columns;
}

double valueOf(const std::vector<double>& column, const std::vector<double>& time, HistoryValue::Kind kind) {
  double value = std::numeric_limits<double>::quiet_NaN(), timeOfValue = value;
  for (std::size_t row = 0; row < column.size(); ++row) {
    const double here = column[row];
    if (!std::isfinite(here)) continue;
    const bool isNew = std::isnan(value) || kind == HistoryValue::Final ||
                       (kind == HistoryValue::Minimum ? here < value : here > value);
    if (!isNew) continue;
    value = here;
    timeOfValue = time[row];
  }
  return kind == HistoryValue::TimeOfMaximum ? timeOfValue : value;
}

}  // namespace pd
