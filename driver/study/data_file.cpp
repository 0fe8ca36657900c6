#include "data_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "../deck/deck_data.hpp"

namespace pd {

namespace {

/// Without blanks around it, and without the quotes of a text.
std::string bareCell(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
  if (first == std::string::npos) return "";
  const std::string cell = text.substr(first, last - first + 1);
  const bool isQuoted = cell.size() > 1 && cell.front() == '"' && cell.back() == '"';
  return isQuoted ? cell.substr(1, cell.size() - 2) : cell;
}

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream stream(line + ",");
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(bareCell(cell));
  return cells;
}

}  // namespace

DataFile DataFile::read(const std::string& fileName) {
  DataFile data;
  data.fileName = fileName;
  std::ifstream file(fileName);
  if (!file) throw DeckError(fileName + ": cannot be read (" + std::strerror(errno) + ")");
  Mistakes mistakes;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (number == 1 && line.compare(0, 3, "\xef\xbb\xbf") == 0) line.erase(0, 3);  // as spreadsheets mark UTF-8
    const std::string bare = bareCell(line);
    if (bare.empty() || bare[0] == '#') continue;
    std::vector<std::string> cells = cellsOf(line);
    const std::string place = fileName + ":" + std::to_string(number);
    if (data.names.empty()) {
      data.names = cells;
      for (const std::string& name : cells)
        if (name.empty() || parseReal(name))
          mistakes.add(place, "the first line must have the names of the columns, and one is \"" + name + "\"");
    } else if (cells.size() != data.names.size()) {
      mistakes.add(place, "has " + std::to_string(cells.size()) + " cells, but there are " +
                              std::to_string(data.names.size()) + " columns (separated by commas)");
    } else {
      data.rows.push_back(std::move(cells));
      data.lines.push_back(number);
    }
  }
  if (mistakes.empty() && data.rows.empty())
    mistakes.add(fileName, "has no rows of numbers below a line of names of columns");
  mistakes.report();
  return data;
}

std::optional<std::size_t> DataFile::column(const std::string& name) const {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

std::optional<double> DataFile::number(std::size_t row, std::size_t column, Mistakes& mistakes) const {
  const std::optional<double> value = parseReal(rows[row][column]);
  if (!value)
    mistakes.add(place(row), "\"" + rows[row][column] + "\" in column \"" + names[column] + "\" is no finite number");
  return value;
}

}  // namespace pd
