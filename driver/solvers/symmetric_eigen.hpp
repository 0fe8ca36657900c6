// Eigenvalues of symmetric matrices of a few rows.
#ifndef PD_SYMMETRIC_EIGEN_HPP
#define PD_SYMMETRIC_EIGEN_HPP

#include <vector>

namespace pd {

struct SymmetricEigen {
  std::vector<double> values;   ///< [n] ascending
  std::vector<double> vectors;  ///< [n n] eigenvector k is row k
};

/// Of the symmetric part of `matrix` [n n], by cyclic Jacobi rotations (G.H. Golub, C.F. Van Loan, Matrix
/// Computations, 4th ed., algorithm 8.5.3): accurate also for the smallest eigenvalues, and quick for n up to 10.
SymmetricEigen symmetricEigen(std::vector<double> matrix, int n);

}  // namespace pd

#endif
