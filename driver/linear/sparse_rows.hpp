// A distributed matrix, row by row, in plain arrays.
#ifndef PD_SPARSE_ROWS_HPP
#define PD_SPARSE_ROWS_HPP

#include <cstddef>
#include <utility>
#include <vector>

namespace pd {

/// Rows of this rank. Columns are numbered over all ranks, those of each rank in sequence, as its rows are.
struct SparseRows {
  std::vector<std::size_t> start{0};
  std::vector<long long> columns;
  std::vector<double> values;

  std::size_t count() const { return start.size() - 1; }
  /// Sorts `entries` (column, value), adds up what has one column, and makes a row of it.
  void addRow(std::vector<std::pair<long long, double>>& entries);
};

/// Of a factor: one of single precision takes half of the memory and time, and preconditions as well where the matrix
/// is not nearly singular.
enum class FactorPrecision { Single, Double };

/// Factors of points in space grow fast: beyond some number of them what is incomplete, or multigrid, takes their
/// place.
inline bool isWorthFactoring(int dimension, long long nPoints) {
  constexpr long long mostInSpace = 2000;
  return dimension < 3 || nPoints <= mostInSpace;
}

}  // namespace pd

#endif
