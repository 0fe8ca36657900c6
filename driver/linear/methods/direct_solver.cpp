#include "direct_solver.hpp"

#include <Amesos2.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace pd {

namespace {

using Amesos = Amesos2::Solver<tpetra::Matrix, tpetra::MultiVector>;

bool anyRank(MPI_Comm comm, bool value) {
  int mine = value ? 1 : 0, any = 0;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, comm);
  return any != 0;
}

/// All ranks' values one after another on the root, nothing on the others.
template <class T>
std::vector<T> gather(MPI_Comm comm, const std::vector<T>& values, MPI_Datatype type) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  long long total = static_cast<long long>(values.size());
  MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_LONG_LONG, MPI_SUM, comm);
  if (total > std::numeric_limits<int>::max())
    throw std::length_error("the linear system is too large for a direct solve on one rank; use CG or GMRES");
  const int count = static_cast<int>(values.size());
  std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(counts.size());
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, comm);
  for (std::size_t rank = 1; rank < counts.size(); ++rank) starts[rank] = starts[rank - 1] + counts[rank - 1];
  std::vector<T> all(rank == 0 ? static_cast<std::size_t>(total) : 0);
  MPI_Gatherv(values.data(), count, type, all.data(), counts.data(), starts.data(), type, 0, comm);
  return all;
}

}  // namespace

struct DirectSolver::Implementation {
  MPI_Comm comm = MPI_COMM_NULL;
  int rank = 0;
  bool isFactored = false;
  std::vector<int> rowCounts, rowStarts;  ///< rows of each rank
  // On the root alone:
  Teuchos::RCP<tpetra::Matrix> matrix;
  Teuchos::RCP<tpetra::MultiVector> b, x;
  Teuchos::RCP<Amesos> solver;

  void assemble(const std::vector<int>& rowLengths, const std::vector<int>& columns, const std::vector<double>& values);
  bool factor();
};

void DirectSolver::Implementation::assemble(const std::vector<int>& rowLengths, const std::vector<int>& columns,
                                            const std::vector<double>& values) {
  const auto self = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF));
  const auto map = Teuchos::rcp(new tpetra::Map(rowLengths.size(), 0, self));
  const std::vector<std::size_t> lengths(rowLengths.begin(), rowLengths.end());
  matrix = Teuchos::rcp(new tpetra::Matrix(map, map, Teuchos::ArrayView<const std::size_t>(lengths)));
  std::size_t start = 0;
  for (std::size_t row = 0; row < lengths.size(); ++row) {
    matrix->insertLocalValues(static_cast<int>(row), static_cast<int>(lengths[row]), &values[start], &columns[start]);
    start += lengths[row];
  }
  matrix->fillComplete();
  b = Teuchos::rcp(new tpetra::MultiVector(map, 1));
  x = Teuchos::rcp(new tpetra::MultiVector(map, 1));
}

bool DirectSolver::Implementation::factor() {
  try {
    solver = Amesos2::create<tpetra::Matrix, tpetra::MultiVector>("KLU2", matrix, x, b);
    solver->symbolicFactorization().numericFactorization();
    return true;
  } catch (const std::exception&) {
    return false;  // a zero pivot
  }
}

DirectSolver::DirectSolver(MPI_Comm comm, const tpetra::Matrix& matrix)
    : implementation_(std::make_unique<Implementation>()) {
  Implementation& self = *implementation_;
  int ranks = 1;
  self.comm = comm;
  MPI_Comm_rank(comm, &self.rank);
  MPI_Comm_size(comm, &ranks);
  const auto local = matrix.getLocalMatrixHost();
  const auto rows = static_cast<int>(matrix.getNodeNumRows());
  std::vector<int> lengths, columns;
  std::vector<double> values;
  for (int row = 0; row < rows; ++row) {
    const std::size_t before = columns.size();
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      if (local.values(k) == 0.0) continue;  // broken bonds and eliminated columns need no fill
      columns.push_back(static_cast<int>(matrix.getColMap()->getGlobalElement(local.graph.entries(k))));
      values.push_back(local.values(k));
    }
    lengths.push_back(static_cast<int>(columns.size() - before));
  }
  self.rowCounts.resize(static_cast<std::size_t>(ranks));
  self.rowStarts.resize(self.rowCounts.size());
  MPI_Allgather(&rows, 1, MPI_INT, self.rowCounts.data(), 1, MPI_INT, comm);
  for (std::size_t rank = 1; rank < self.rowCounts.size(); ++rank)
    self.rowStarts[rank] = self.rowStarts[rank - 1] + self.rowCounts[rank - 1];

  lengths = gather(comm, lengths, MPI_INT);
  columns = gather(comm, columns, MPI_INT);
  values = gather(comm, values, MPI_DOUBLE);
  if (self.rank == 0) {
    self.assemble(lengths, columns, values);
    self.isFactored = self.factor();
  }
  self.isFactored = anyRank(comm, self.isFactored);
}

DirectSolver::~DirectSolver() = default;

bool DirectSolver::isFactored() const { return implementation_->isFactored; }

bool DirectSolver::solve(const double* b, double* x) const {
  const Implementation& self = *implementation_;
  if (!self.isFactored) return false;
  const auto rank = static_cast<std::size_t>(self.rank);
  double* allB = self.rank == 0 ? self.b->getDataNonConst(0).getRawPtr() : nullptr;
  MPI_Gatherv(b, self.rowCounts[rank], MPI_DOUBLE, allB, self.rowCounts.data(), self.rowStarts.data(), MPI_DOUBLE, 0,
              self.comm);
  bool hasFailed = false;
  if (self.rank == 0) {
    try {
      self.solver->solve();
    } catch (const std::exception&) {
      hasFailed = true;
    }
  }
  const double* allX = self.rank == 0 ? self.x->getData(0).getRawPtr() : nullptr;
  MPI_Scatterv(allX, self.rowCounts.data(), self.rowStarts.data(), MPI_DOUBLE, x, self.rowCounts[rank], MPI_DOUBLE, 0,
               self.comm);
  hasFailed = hasFailed || !std::all_of(x, x + self.rowCounts[rank], [](double value) { return std::isfinite(value); });
  return !anyRank(self.comm, hasFailed);
}

}  // namespace pd
