// The largest eigenvalue of an operator that is known only by what it does to a vector: what explicit time steps are
// limited by.
#ifndef PD_LANCZOS_HPP
#define PD_LANCZOS_HPP

#include <functional>
#include <vector>

namespace pd {

struct LargestEigenvalue {
  double value = 0.0;         ///< Ritz value, which approaches the eigenvalue from below
  double upperBound = 0.0;    ///< Ritz value + residual: an eigenvalue lies between the two
  double smallestSeen = 0.0;  ///< smallest Ritz value: the smallest eigenvalue is no larger
  int iterations = 0;
};

/// Vectors are the owned part of a distributed one.
struct SelfAdjointOperator {
  /// y = A x.
  std::function<void(const double* x, double* y)> apply;
  /// The inner product, over all ranks, in which A is self-adjoint.
  std::function<double(const double* x, const double* y)> dot;
};

/// Lanczos iteration without reorthogonalisation (Golub & Van Loan, Matrix Computations, 10.1), which keeps three
/// vectors only and finds the ends of the spectrum first. Stops when the residual of the Ritz pair falls below
/// `relativeTolerance` of the Ritz value. `start`: any vector with a part in the wanted eigenvector. The answer is zero
/// where `start` is zero. Collective.
LargestEigenvalue largestEigenvalue(const SelfAdjointOperator& op, std::vector<double> start, double relativeTolerance,
                                    int maximumIterations);

/// Numbers in [-1, 1), `width` a point, that depend on the global ids alone, not on ranks or order.
std::vector<double> randomPointValues(const std::vector<int>& globalIds, int nOwned, int width);

}  // namespace pd

#endif
