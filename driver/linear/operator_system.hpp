// Linear systems whose matrix and preconditioner are functions, behind plain arrays.
#ifndef PD_OPERATOR_SYSTEM_HPP
#define PD_OPERATOR_SYSTEM_HPP

#include <functional>
#include <vector>

#include "../parallel/communicator.hpp"

namespace pd {

struct GmresReport {
  int iterations = 0;
  double relativeResidual = 0.0;  ///< true residual |b - A x| / |b|, computed after the solve
  bool hasConverged = false;
};

/// y = A x over the unknowns of this rank; `x` and `y` are different arrays. Collective.
using LinearMap = std::function<void(const double* x, double* y)>;

/// A x = b by GMRES, which begins anew every `nKept` iterations; `precondition`, on the right, is the same map in all
/// of them. `x` holds the first guess. Collective.
GmresReport solveByGmres(const Communicator& comm, const LinearMap& matrix, const LinearMap& precondition,
                         const std::vector<double>& b, std::vector<double>& x, double relativeTolerance,
                         int maximumIterations, int nKept);

}  // namespace pd

#endif
