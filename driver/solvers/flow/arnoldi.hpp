// The outer eigenvalues of an operator that is not self-adjoint and known only by what it does to a vector.
#ifndef PD_ARNOLDI_HPP
#define PD_ARNOLDI_HPP

#include <complex>
#include <functional>
#include <vector>

#include "../../parallel/communicator.hpp"

namespace pd {

/// Ritz values of Arnoldi's iteration (Golub & Van Loan, Matrix Computations, 10.5), which finds the rim of the
/// spectrum first. `apply(x, y)`: y = A x of the owned part of a distributed vector; `start`: any vector with a part in
/// the wanted ones. Every ten iterations `isEnough` is asked of the values so far; it ends after `maximumIterations` at
/// the latest. Empty where `start` is zero. Collective.
std::vector<std::complex<double>> outerEigenvalues(
    const Communicator& comm, const std::function<void(const double*, double*)>& apply, std::vector<double> start,
    const std::function<bool(const std::vector<std::complex<double>>&)>& isEnough, int maximumIterations);

}  // namespace pd

#endif
