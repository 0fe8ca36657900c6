// Sparse LU (Amesos2's KLU2) of a distributed matrix.
// No header of the plug-in interface here: Amesos2 and MueLu include Epetra's headers, with which its Epetra_Comm.h
// does not go together.
#ifndef PD_DIRECT_SOLVER_HPP
#define PD_DIRECT_SOLVER_HPP

#include <mpi.h>

#include <memory>

#include "tpetra_types.hpp"

namespace pd {

/// The matrix is gathered on the root rank and factored there: Amesos2's KLU2 of Trilinos 13.2 gives wrong answers,
/// without an error, where its matrix lives on several ranks.
class DirectSolver {
 public:
  /// Rows and columns of `matrix` must be numbered contiguously, rank after rank. Collective.
  DirectSolver(MPI_Comm comm, const tpetra::Matrix& matrix);
  ~DirectSolver();

  /// Whether the factorisation succeeded (the matrix is not singular to working precision), on all ranks alike.
  bool isFactored() const;
  /// x = A^-1 b over owned rows. Collective. Returns false where a value is not finite.
  bool solve(const double* b, double* x) const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace pd

#endif
