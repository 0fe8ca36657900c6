#include "rows_to_tpetra.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

namespace pd {

Teuchos::RCP<const tpetra::Map> mapOfRows(MPI_Comm comm, std::size_t count) {
  return Teuchos::rcp(new tpetra::Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), count, 0,
                                      Teuchos::rcp(new Teuchos::MpiComm<int>(comm))));
}

Teuchos::RCP<tpetra::Matrix> matrixOfRows(const Teuchos::RCP<const tpetra::Map>& map, const SparseRows& rows) {
  std::vector<std::size_t> lengths(rows.count());
  for (std::size_t row = 0; row < rows.count(); ++row) lengths[row] = rows.start[row + 1] - rows.start[row];
  const auto matrix = Teuchos::rcp(new tpetra::Matrix(map, Teuchos::ArrayView<const std::size_t>(lengths)));
  for (std::size_t row = 0; row < rows.count(); ++row)
    matrix->insertGlobalValues(map->getGlobalElement(static_cast<int>(row)), static_cast<int>(lengths[row]),
                               rows.values.data() + rows.start[row], rows.columns.data() + rows.start[row]);
  matrix->fillComplete();
  return matrix;
}

}  // namespace pd
