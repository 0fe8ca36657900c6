// Plain rows as a matrix of Tpetra.
#ifndef PD_ROWS_TO_TPETRA_HPP
#define PD_ROWS_TO_TPETRA_HPP

#include <mpi.h>

#include "../sparse_rows.hpp"
#include "tpetra_types.hpp"

namespace pd {

/// `count`: rows of this rank, which follow those of the ranks before. Collective.
Teuchos::RCP<const tpetra::Map> mapOfRows(MPI_Comm comm, std::size_t count);

/// Collective.
Teuchos::RCP<tpetra::Matrix> matrixOfRows(const Teuchos::RCP<const tpetra::Map>& map, const SparseRows& rows);

}  // namespace pd

#endif
