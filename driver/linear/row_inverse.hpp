// The inverse, or about that, of a matrix that is given row by row, behind plain arrays.
#ifndef PD_ROW_INVERSE_HPP
#define PD_ROW_INVERSE_HPP

#include <memory>
#include <string>

#include "../parallel/communicator.hpp"
#include "sparse_rows.hpp"

namespace pd {

/// By an LU factor (MUMPS), or by what takes less memory in its place. With solveByGmres() it does for matrices that
/// have changed since, as long as that takes few iterations.
class RowInverse {
 public:
  explicit RowInverse(const Communicator& comm);
  ~RowInverse();

  /// Returns what stands in the way of a factor; empty where nothing does. Collective.
  std::string factor(const SparseRows& rows, FactorPrecision precision = FactorPrecision::Double);
  /// A preconditioner (krylov.hpp), of a matrix that has one unknown a point. Collective. Throws what the packages
  /// throw.
  void precondition(const std::string& name, const SparseRows& rows);
  /// Whether it has been made, of a matrix with so many rows on this rank. Collective.
  bool isMadeFor(std::size_t count) const;
  double factorEntries() const;  ///< of all ranks; 0 without a factor

  /// x_k = A^-1 b_k, about, for `count` right sides over the rows of this rank, one after the other in the arrays,
  /// which differ. Collective. Throws std::logic_error where nothing has been made.
  void apply(const double* b, double* x, std::size_t count = 1) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
