#include "sparse_factor.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include "direct_solver.hpp"

namespace pd {

struct SparseFactor::Implementation {
  Teuchos::RCP<tpetra::Matrix> matrix;
  std::unique_ptr<DirectSolver> solver;
};

SparseFactor::SparseFactor(const std::vector<std::size_t>& rowStart, const std::vector<int>& columns,
                           const std::vector<double>& values)
    : implementation_(std::make_unique<Implementation>()) {
  using LocalMatrix = tpetra::Matrix::local_matrix_device_type;
  const std::size_t rows = rowStart.size() - 1;
  const auto self = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF));
  const auto map = Teuchos::rcp(new tpetra::Map(rows, 0, self));
  LocalMatrix::row_map_type::non_const_type starts("row start", rowStart.size());
  LocalMatrix::index_type::non_const_type indices("columns", columns.size());
  LocalMatrix::values_type entries("values", values.size());
  std::copy(rowStart.begin(), rowStart.end(), starts.data());
  std::copy(columns.begin(), columns.end(), indices.data());
  std::copy(values.begin(), values.end(), entries.data());
  implementation_->matrix = Teuchos::rcp(new tpetra::Matrix(map, map, starts, indices, entries));
  implementation_->matrix->expertStaticFillComplete(map, map);
  implementation_->solver = std::make_unique<DirectSolver>(MPI_COMM_SELF, *implementation_->matrix);
}

SparseFactor::~SparseFactor() = default;

bool SparseFactor::isFactored() const { return implementation_->solver->isFactored(); }

bool SparseFactor::solve(const double* b, double* x) const { return implementation_->solver->solve(b, x); }

}  // namespace pd
