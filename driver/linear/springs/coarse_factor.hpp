// Cholesky factors of the stiffness among the modes of a coarse space.
#ifndef PD_COARSE_FACTOR_HPP
#define PD_COARSE_FACTOR_HPP

#include <cstddef>
#include <vector>

#include "../../parallel/communicator.hpp"
#include "coarse_matrix.hpp"

namespace pd {

/// L L^T of a CoarseMatrix: the multifrontal method (Duff and Reid, ACM Trans. Math. Softw. 9 (1983) 302) over its
/// blocks in an order of least degree. Blocks have a few unknowns each and a dozen neighbours, too few for what
/// libraries of sparse factors gain with larger ones. Found in double precision and kept in single, which is what a
/// preconditioner in single precision needs of it: a solve reads it twice. A displacement that nothing resists to
/// within rounding is held at 0, so that L L^T is always positive definite on the rest.
///
/// On several ranks the blocks of one that have no neighbours on others come before those that have: a rank eliminates
/// its own, and all of them what is left, which is little.
class CoarseFactor {
 public:
  /// `matrix`: whole on all ranks; `nOwn` of its unknowns are this rank's, rank after rank. Refers to `comm`.
  /// Collective, as the rest.
  CoarseFactor(const Communicator& comm, const CoarseMatrix& matrix, int nOwn);

  /// x = (L L^T)^-1 b, this rank's unknowns of each.
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

  void eliminate(std::size_t firstFront, std::size_t lastFront) const;
  void substitute(std::size_t firstFront, std::size_t lastFront) const;

  const Communicator& comm_;
  int first_, nOwn_;            ///< this rank's unknowns
  std::vector<int> place_;      ///< [unknowns] in the order of elimination
  int firstShared_ = 0;         ///< place of the first of those with neighbours on several ranks
  std::vector<Front> fronts_;   ///< in that order, without those of other ranks
  std::size_t nOwnFronts_ = 0;  ///< the rest are shared
  std::vector<int> rows_;       ///< below each front
  std::vector<float> values_;   ///< of each front [width][width + nBelow], column by column; inverse on the diagonal
  mutable std::vector<float> work_, below_;
};

}  // namespace pd

#endif
