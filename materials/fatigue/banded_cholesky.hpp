// Cholesky factors of a symmetric positive definite band matrix.
#ifndef PD_BANDED_CHOLESKY_HPP
#define PD_BANDED_CHOLESKY_HPP

#include <cstddef>
#include <vector>

namespace pd {

class BandedCholesky {
 public:
  /// Zero, of `n` unknowns, each coupled with the next `width` at most.
  BandedCholesky(int n, int width);
  /// Adds to entries (i, j) and (j, i). Before factor().
  void add(int i, int j, double value);
  /// Throws std::runtime_error where the matrix is not positive definite.
  void factor();
  /// The solution replaces the right-hand side.
  void solve(std::vector<double>& x) const;
  /// [unknowns][unknowns] of the inverse.
  std::vector<double> inverseAt(const std::vector<std::size_t>& unknowns) const;

 private:
  double* column(int j) { return values_.data() + static_cast<std::size_t>(j) * static_cast<std::size_t>(width_ + 1); }
  const double* column(int j) const { return const_cast<BandedCholesky*>(this)->column(j); }

  void solveSides(std::vector<double>& x, int first, int lowest) const;

  int n_, width_;
  std::vector<double> values_;  ///< by columns, from the diagonal down
};

}  // namespace pd

#endif
