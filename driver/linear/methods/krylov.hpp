// Preconditioners (Ifpack2; MueLu through multigrid.hpp) and Krylov methods (Belos).
// No header of the plug-in interface here: Amesos2 and MueLu include Epetra's headers, with which its Epetra_Comm.h
// does not go together.
#ifndef PD_KRYLOV_HPP
#define PD_KRYLOV_HPP

#include <string>
#include <vector>

#include "tpetra_types.hpp"

namespace pd {

/// `nullspace`: what the unconstrained operator maps to zero (constants, rigid-body motions), for multigrid.
/// `width`: degrees of freedom a point. Throws std::invalid_argument for an unknown name, and whatever the packages
/// throw where the matrix does not allow the preconditioner. Null for "None".
Teuchos::RCP<tpetra::Operator> makePreconditioner(const std::string& name, const Teuchos::RCP<tpetra::Matrix>& matrix,
                                                  int width, const Teuchos::RCP<tpetra::MultiVector>& nullspace);

struct KrylovResult {
  int iterations = 0;
  bool hasBrokenDown = false;  ///< not positive definite, or not a number
};

/// Vectors that GMRES keeps before it begins anew.
constexpr int krylovSpaceSize = 200;

/// Runs "CG" or "GMRES" from the first guess `x` until |b - A x| <= tolerance |b| as the recurrence sees it.
KrylovResult runKrylov(const std::string& method, const Teuchos::RCP<const tpetra::Operator>& matrix,
                       const Teuchos::RCP<const tpetra::Operator>& preconditioner,
                       const Teuchos::RCP<const tpetra::MultiVector>& b, const Teuchos::RCP<tpetra::MultiVector>& x,
                       double tolerance, int maximumIterations, int nKept = krylovSpaceSize);

}  // namespace pd

#endif
