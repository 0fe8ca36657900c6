// The direction in which a symmetric tensor is largest.
#ifndef PD_PRINCIPAL_DIRECTION_HPP
#define PD_PRINCIPAL_DIRECTION_HPP

#include <array>

#include "rotation.hpp"

namespace pd::kernels {

/// Unit eigenvector of the largest eigenvalue of a symmetric tensor (9 values, row by row), by Jacobi's rotations
/// (Golub & Van Loan, Matrix Computations, 8.5). Any of them where the largest is not alone.
std::array<double, 3> principalDirection(Matrix3<double> tensor);

}  // namespace pd::kernels

#endif
