// Cholesky factors of the stiffness among the modes of a coarse space.
#ifndef PD_COARSE_FACTOR_HPP
#define PD_COARSE_FACTOR_HPP

#include <vector>

#include "coarse_matrix.hpp"

namespace pd {

/// L L^T of a CoarseMatrix: the multifrontal method (Duff and Reid, ACM Trans. Math. Softw. 9 (1983) 302) over its
/// blocks in an order of least degree. Blocks have a few unknowns each and a dozen neighbours, too few for what
/// libraries of sparse factors gain with larger ones. Found in double precision and kept in single, which is what a
/// preconditioner in single precision needs of it: a solve reads it twice. A displacement that nothing resists to
/// within rounding is held at 0, so that L L^T is always positive definite on the rest.
class CoarseFactor {
 public:
  explicit CoarseFactor(const CoarseMatrix& matrix);

  /// x = (L L^T)^-1 b, [unknowns] each.
  void solve(const double* b, double* x) const;

  std::size_t nEntries() const { return values_.size(); }

 private:
  /// Unknowns `first` ... `first + width - 1` in the order of elimination, and those that they change.
  struct Front {
    int first, width;
    std::size_t rows, values;  ///< starts in rows_ and values_
    int nBelow;
  };
  class Elimination;

  std::vector<int> place_;     ///< [unknowns] in the order of elimination
  std::vector<Front> fronts_;  ///< in that order
  std::vector<int> rows_;      ///< below each front
  std::vector<float> values_;  ///< of each front [width][width + nBelow], column by column; inverse on the diagonal
  mutable std::vector<float> work_, below_;
};

}  // namespace pd

#endif
