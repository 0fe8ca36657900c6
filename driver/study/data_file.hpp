// Measured series: CSV files with a line of names. Private to this folder.
#ifndef PD_DATA_FILE_HPP
#define PD_DATA_FILE_HPP

#include <optional>
#include <string>
#include <vector>

#include "../deck/deck.hpp"

namespace pd {

/// Cells as text. Lines that are empty or begin with # do not count; the first other one has the names.
struct DataFile {
  std::string fileName;
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;  ///< as many cells as names
  std::vector<int> lines;                      ///< of the rows in the file

  /// Throws DeckError, with all mistakes.
  static DataFile read(const std::string& fileName);

  /// Nothing where no column has the name.
  std::optional<std::size_t> column(const std::string& name) const;
  std::string place(std::size_t row) const { return fileName + ":" + std::to_string(lines[row]); }
  /// Nothing, with a mistake, where the cell is no finite number.
  std::optional<double> number(std::size_t row, std::size_t column, Mistakes& mistakes) const;
};

}  // namespace pd

#endif
