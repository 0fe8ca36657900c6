#include <Ifpack2_Factory.hpp>
#include <array>
#include <cmath>
#include <stdexcept>

#include "krylov.hpp"
#include "multigrid.hpp"

namespace pd {

namespace {

/// The inverse of the diagonal block of each point.
class BlockJacobi : public tpetra::Operator {
 public:
  BlockJacobi(const tpetra::Matrix& matrix, int width) : map_(matrix.getRowMap()), width_(width) {
    const auto local = matrix.getLocalMatrixHost();
    const auto rows = static_cast<int>(map_->getNodeNumElements());
    inverses_.assign(static_cast<std::size_t>(rows) * width, 0.0);
    for (int row = 0; row < rows; ++row) {
      const int first = row - row % width;
      for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
        const int offset = local.graph.entries(k) - first;
        if (offset >= 0 && offset < width) inverses_[static_cast<std::size_t>(row) * width + offset] = local.values(k);
      }
    }
    for (int first = 0; first < rows; first += width) invert(&inverses_[static_cast<std::size_t>(first) * width]);
  }

  Teuchos::RCP<const tpetra::Map> getDomainMap() const override { return map_; }
  Teuchos::RCP<const tpetra::Map> getRangeMap() const override { return map_; }

  void apply(const tpetra::MultiVector& x, tpetra::MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    for (std::size_t column = 0; column < x.getNumVectors(); ++column) {
      const auto in = x.getData(column);
      const auto out = y.getDataNonConst(column);
      const auto rows = static_cast<int>(map_->getNodeNumElements());
      for (int row = 0; row < rows; ++row) {
        const int first = row - row % width_;
        double sum = 0.0;
        for (int k = 0; k < width_; ++k) sum += inverses_[static_cast<std::size_t>(row) * width_ + k] * in[first + k];
        out[row] = alpha * sum + (beta == 0.0 ? 0.0 : beta * out[row]);
      }
    }
  }

 private:
  /// Gauss-Jordan elimination in place. Diagonal blocks of a stable body are definite, so no pivoting; a block that
  /// is singular gives way to the inverse of its diagonal.
  void invert(double* block) const {
    std::array<double, 16> original{};
    const int n = width_;
    std::copy(block, block + n * n, original.begin());
    for (int pivot = 0; pivot < n; ++pivot) {
      const double value = block[pivot * n + pivot];
      if (std::abs(value) <= 1e-14 * std::abs(original[static_cast<std::size_t>(pivot * n + pivot)]) || value == 0.0) {
        for (int i = 0; i < n * n; ++i) block[i] = 0.0;
        for (int i = 0; i < n; ++i) {
          const double entry = original[static_cast<std::size_t>(i * n + i)];
          block[i * n + i] = entry != 0.0 ? 1.0 / entry : 1.0;
        }
        return;
      }
      block[pivot * n + pivot] = 1.0;
      for (int j = 0; j < n; ++j) block[pivot * n + j] /= value;
      for (int i = 0; i < n; ++i) {
        if (i == pivot) continue;
        const double factor = block[i * n + pivot];
        block[i * n + pivot] = 0.0;
        for (int j = 0; j < n; ++j) block[i * n + j] -= factor * block[pivot * n + j];
      }
    }
  }

  Teuchos::RCP<const tpetra::Map> map_;
  int width_;
  std::vector<double> inverses_;  ///< row after row of the blocks
};

/// Incomplete LU without fill beyond the (already dense) rows of the neighbourhoods, on each rank's own rows.
Teuchos::RCP<tpetra::Operator> makeIncompleteLu(const Teuchos::RCP<const tpetra::Matrix>& matrix) {
  using RowMatrix = Tpetra::RowMatrix<double, int, long long>;
  const bool isSerial = matrix->getComm()->getSize() == 1;
  const auto result = Ifpack2::Factory::create<RowMatrix>(isSerial ? "RILUK" : "SCHWARZ", matrix);
  Teuchos::ParameterList list;
  Teuchos::ParameterList& inner = isSerial ? list : list.sublist("schwarz: inner preconditioner parameters");
  if (!isSerial) {
    list.set("schwarz: overlap level", 0);
    list.set("schwarz: inner preconditioner name", "RILUK");
  }
  inner.set("fact: iluk level-of-fill", 0.0);
  result->setParameters(list);
  result->initialize();
  result->compute();
  return result;
}

}  // namespace

Teuchos::RCP<tpetra::Operator> makePreconditioner(const std::string& name, const Teuchos::RCP<tpetra::Matrix>& matrix,
                                                  int width, const Teuchos::RCP<tpetra::MultiVector>& nullspace) {
  if (name == "None") return Teuchos::null;
  if (name == "Jacobi") return Teuchos::rcp(new BlockJacobi(*matrix, 1));
  if (name == "Block Jacobi") return Teuchos::rcp(new BlockJacobi(*matrix, width));
  if (name == "ILU") return makeIncompleteLu(matrix);
  if (name == "Multigrid") return makeMultigrid(matrix, width, nullspace);
  throw std::invalid_argument("unknown preconditioner \"" + name +
                              "\" (known: None, Jacobi, Block Jacobi, ILU, Multigrid)");
}

}  // namespace pd
