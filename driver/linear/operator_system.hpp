// Linear systems whose matrix and preconditioner are functions, and multigrid for the latter, behind plain arrays.
#ifndef PD_OPERATOR_SYSTEM_HPP
#define PD_OPERATOR_SYSTEM_HPP

#include <functional>
#include <memory>
#include <vector>

#include "row_system.hpp"

namespace pd {

/// y = A x over the unknowns of this rank; `x` and `y` are different arrays. Collective.
using LinearMap = std::function<void(const double* x, double* y)>;

/// A x = b by GMRES, which begins anew every `nKept` iterations; `precondition`, on the right, is the same map in all
/// of them. `x` holds the first guess. Collective.
RowSolveReport solveByGmres(const Communicator& comm, const LinearMap& matrix, const LinearMap& precondition,
                            const std::vector<double>& b, std::vector<double>& x, double relativeTolerance,
                            int maximumIterations, int nKept);

/// One V-cycle of smoothed aggregation (MueLu) for a matrix with one unknown a point.
class Multigrid {
 public:
  /// Collective. Throws what MueLu throws.
  Multigrid(const Communicator& comm, const SparseRows& rows);
  ~Multigrid();

  /// x_k = about A^-1 b_k for `count` right sides, one after the other in the arrays, from nothing. Collective.
  void apply(const double* b, double* x, std::size_t count) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
