#include "operator_system.hpp"

#include <cmath>

#include "methods/krylov.hpp"
#include "methods/rows_to_tpetra.hpp"

namespace pd {

namespace {

/// A function over plain arrays as Belos wants it.
class FunctionOperator : public tpetra::Operator {
 public:
  FunctionOperator(Teuchos::RCP<const tpetra::Map> map, const LinearMap& function)
      : map_(std::move(map)), function_(function) {}

  Teuchos::RCP<const tpetra::Map> getDomainMap() const override { return map_; }
  Teuchos::RCP<const tpetra::Map> getRangeMap() const override { return map_; }
  void apply(const tpetra::MultiVector& x, tpetra::MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    std::vector<double> result(map_->getNodeNumElements());
    for (std::size_t column = 0; column < x.getNumVectors(); ++column) {
      function_(x.getData(column).getRawPtr(), result.data());
      const auto out = y.getDataNonConst(column);
      for (std::size_t i = 0; i < result.size(); ++i) {
        double& value = out[static_cast<Teuchos::Ordinal>(i)];
        value = alpha * result[i] + (beta == 0.0 ? 0.0 : beta * value);
      }
    }
  }

 private:
  Teuchos::RCP<const tpetra::Map> map_;
  const LinearMap& function_;
};

Teuchos::RCP<tpetra::MultiVector> vectorOf(const Teuchos::RCP<const tpetra::Map>& map,
                                           const std::vector<double>& values) {
  const auto vector = Teuchos::rcp(new tpetra::MultiVector(map, 1));
  std::copy(values.begin(), values.end(), vector->getDataNonConst(0).begin());
  return vector;
}

}  // namespace

RowSolveReport solveByGmres(const Communicator& comm, const LinearMap& matrix, const LinearMap& precondition,
                            const std::vector<double>& b, std::vector<double>& x, double relativeTolerance,
                            int maximumIterations, int nKept) {
  const auto map = mapOfRows(comm.mpi(), b.size());
  const auto rightSide = vectorOf(map, b), solution = vectorOf(map, x);
  Teuchos::Array<double> norm(1);
  rightSide->norm2(norm());
  const double size = norm[0];
  RowSolveReport report;
  if (size == 0.0) {
    std::fill(x.begin(), x.end(), 0.0);
    report.hasConverged = true;
    return report;
  }
  const auto product = Teuchos::rcp(new FunctionOperator(map, matrix));
  const auto preconditioner = Teuchos::rcp(new FunctionOperator(map, precondition));
  const KrylovResult result =
      runKrylov("GMRES", product, preconditioner, rightSide, solution, relativeTolerance, maximumIterations, nKept);
  tpetra::MultiVector difference(*rightSide, Teuchos::Copy);
  product->apply(*solution, difference, Teuchos::NO_TRANS, -1.0, 1.0);
  difference.norm2(norm());
  report.iterations = result.iterations;
  report.relativeResidual = result.hasBrokenDown ? HUGE_VAL : norm[0] / size;
  // The recurrence of GMRES may be ahead of the true residual by rounding.
  report.hasConverged = report.relativeResidual <= 2.0 * relativeTolerance;
  const auto values = solution->getData(0);
  std::copy(values.begin(), values.end(), x.begin());
  return report;
}

struct Multigrid::Implementation {
  Teuchos::RCP<tpetra::Matrix> matrix;
  Teuchos::RCP<tpetra::Operator> cycle;
};

Multigrid::Multigrid(const Communicator& comm, const SparseRows& rows) : implementation_(new Implementation) {
  Implementation& self = *implementation_;
  self.matrix = matrixOfRows(mapOfRows(comm.mpi(), rows.count()), rows);
  const auto constants = Teuchos::rcp(new tpetra::MultiVector(self.matrix->getRowMap(), 1));
  constants->putScalar(1.0);
  self.cycle = makePreconditioner("Multigrid", self.matrix, 1, constants);
}
Multigrid::~Multigrid() = default;

void Multigrid::apply(const double* b, double* x, std::size_t count) const {
  const Implementation& self = *implementation_;
  const auto map = self.matrix->getRowMap();
  const std::size_t size = map->getNodeNumElements();
  const tpetra::MultiVector rightSides(map, Teuchos::ArrayView<const double>(b, static_cast<int>(size * count)), size,
                                       count);
  tpetra::MultiVector solutions(map, count);
  self.cycle->apply(rightSides, solutions);
  for (std::size_t k = 0; k < count; ++k) {
    const auto values = solutions.getData(k);
    std::copy(values.begin(), values.end(), x + k * size);
  }
}

}  // namespace pd
