// Multigrid, from a library that is loaded when it is first asked for.
#ifndef PD_MULTIGRID_HPP
#define PD_MULTIGRID_HPP

#include "tpetra_types.hpp"

namespace pd {

/// Smoothed aggregation by MueLu. `width`: degrees of freedom a point; `nullspace` as in krylov.hpp. MueLu brings sixty
/// libraries along, which take the loader as long as a small run takes, so that it is in a library of its own,
/// pd_multigrid (muelu.cpp). Throws std::runtime_error where that is missing, and what MueLu throws.
Teuchos::RCP<tpetra::Operator> makeMultigrid(const Teuchos::RCP<tpetra::Matrix>& matrix, int width,
                                             const Teuchos::RCP<tpetra::MultiVector>& nullspace);

/// What the library offers by the name makeMueLu.
using MakeMueLu = void(const Teuchos::RCP<tpetra::Matrix>* matrix, int width,
                       const Teuchos::RCP<tpetra::MultiVector>* nullspace, Teuchos::RCP<tpetra::Operator>* result);

}  // namespace pd

#endif
