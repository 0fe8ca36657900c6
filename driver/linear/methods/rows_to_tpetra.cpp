#include "rows_to_tpetra.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <algorithm>
#include <numeric>

namespace pd {

Teuchos::RCP<const tpetra::Map> mapOfRows(MPI_Comm comm, std::size_t count) {
  return Teuchos::rcp(new tpetra::Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), count, 0,
                                      Teuchos::rcp(new Teuchos::MpiComm<int>(comm))));
}

namespace {

/// Columns that rows of other ranks have, in order.
std::vector<long long> foreignColumns(const SparseRows& rows, long long first) {
  const long long end = first + static_cast<long long>(rows.count());
  std::vector<long long> columns;
  for (const long long column : rows.columns)
    if (column < first || column >= end) columns.push_back(column);
  std::sort(columns.begin(), columns.end());
  columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
  return columns;
}

}  // namespace

/// By local indices, own columns first, so that Tpetra has nothing to find out or to sort, which would take several
/// times as long.
Teuchos::RCP<tpetra::Matrix> matrixOfRows(const Teuchos::RCP<const tpetra::Map>& map, const SparseRows& rows) {
  const auto own = static_cast<long long>(rows.count());
  const long long first = own > 0 ? map->getMinGlobalIndex() : 0;
  const std::vector<long long> foreign = foreignColumns(rows, first);
  std::vector<long long> columns(rows.count());
  std::iota(columns.begin(), columns.end(), first);
  columns.insert(columns.end(), foreign.begin(), foreign.end());
  const Teuchos::RCP<const tpetra::Map> columnMap =
      Teuchos::rcp(new tpetra::Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                                   Teuchos::ArrayView<const long long>(columns), 0, map->getComm()));
  const auto nEntries = static_cast<Teuchos::Ordinal>(rows.columns.size());
  Teuchos::ArrayRCP<std::size_t> starts(static_cast<Teuchos::Ordinal>(rows.start.size()));
  std::copy(rows.start.begin(), rows.start.end(), starts.begin());
  Teuchos::ArrayRCP<int> indices(nEntries);
  Teuchos::ArrayRCP<double> values(nEntries);
  for (std::size_t row = 0; row < rows.count(); ++row) {
    auto at = static_cast<Teuchos::Ordinal>(rows.start[row]);
    for (const bool wantsOwn : {true, false})
      for (std::size_t k = rows.start[row]; k < rows.start[row + 1]; ++k) {
        const long long column = rows.columns[k];
        const bool isOwn = column >= first && column < first + own;
        if (isOwn != wantsOwn) continue;
        indices[at] = static_cast<int>(
            isOwn ? column - first
                  : own + (std::lower_bound(foreign.begin(), foreign.end(), column) - foreign.begin()));
        values[at++] = rows.values[k];
      }
  }
  const auto matrix = Teuchos::rcp(new tpetra::Matrix(map, columnMap, starts, indices, values));
  matrix->expertStaticFillComplete(map, map);
  return matrix;
}

}  // namespace pd
