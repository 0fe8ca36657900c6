// Values for the whole body over time, as a CSV file.
#ifndef PD_HISTORY_HPP
#define PD_HISTORY_HPP

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace pd {

/// Columns step, time and those given. Each row is on disk when row() returns. Used by the root rank alone; throws
/// RunError with the path.
class History {
 public:
  /// Rows of an earlier run before `firstStep` are kept where the columns are the same; 0 starts afresh. A file with
  /// other columns is renamed to <path>.old on a restart (.old2 where that is there).
  History(const std::string& path, const std::vector<std::string>& columns, int firstStep);
  void row(int step, double time, const std::vector<double>& values);

 private:
  void takeOver(const std::string& header, int firstStep);

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::string path_;
  std::unique_ptr<std::FILE, Close> file_;
};

/// Writes what the columns of <base>.csv are measured in (empty: only the deck knows) into <base>.csv-metadata.json,
/// the place and form that the W3C's "Metadata Vocabulary for Tabular Data" gives it. Throws RunError.
void writeColumnUnits(const std::string& base, const std::vector<std::string>& columns,
                      const std::vector<std::string>& units, const std::string& timeUnit = "s");

/// Names of the columns of a field with `width` values: the label; with X, Y, Z; XX, XY .. ZZ; or _1, _2 ...
std::vector<std::string> columnNames(const std::string& label, int width);

}  // namespace pd

#endif
