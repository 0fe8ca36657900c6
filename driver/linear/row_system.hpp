// Linear systems whose matrix is given row by row, without any symmetry, behind plain arrays.
#ifndef PD_ROW_SYSTEM_HPP
#define PD_ROW_SYSTEM_HPP

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "../parallel/communicator.hpp"

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

/// Factors of points in space grow fast: beyond some number of them what is incomplete, or multigrid, takes their
/// place.
inline bool isWorthFactoring(int dimension, long long nPoints) {
  constexpr long long mostInSpace = 2000;
  return dimension < 3 || nPoints <= mostInSpace;
}

struct RowSolveReport {
  int iterations = 0;
  double relativeResidual = 0.0;  ///< true residual |b - A x| / |b|, computed after the solve
  bool hasConverged = false;
};

/// A x = b by GMRES with the LU factor (MUMPS) of a matrix that A once was: one iteration where it still is. Or with
/// what takes less memory in its place, where factors grow fast, as those of points in space do.
class RowSystem {
 public:
  explicit RowSystem(const Communicator& comm);
  ~RowSystem();

  /// Replaces the matrix; the factor stays if it has as many rows on each rank. Collective.
  void setMatrix(const SparseRows& rows);
  /// Factors the present matrix. Returns what stands in the way; empty where nothing does. Collective.
  std::string factor();
  /// In place of a factor a preconditioner of the present matrix (krylov.hpp), which has one unknown a point.
  /// Collective. Throws what the packages throw.
  void precondition(const std::string& name);
  bool hasFactor() const;        ///< or a preconditioner
  double factorEntries() const;  ///< of all ranks

  /// `x` holds the first guess. Needs a factor, or a preconditioner. Collective.
  RowSolveReport solve(const std::vector<double>& b, std::vector<double>& x, double relativeTolerance,
                       int maximumIterations) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
