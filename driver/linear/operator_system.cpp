#include "operator_system.hpp"

#include <algorithm>
#include <cmath>

#include "methods/krylov.hpp"
#include "methods/rows_to_tpetra.hpp"

namespace pd {

namespace {

/// A linear function over plain arrays as Belos wants it; of zero it is not asked.
class FunctionOperator : public tpetra::Operator {
 public:
  FunctionOperator(const Communicator& comm, Teuchos::RCP<const tpetra::Map> map, const LinearMap& function)
      : comm_(comm), map_(std::move(map)), function_(function) {}

  Teuchos::RCP<const tpetra::Map> getDomainMap() const override { return map_; }
  Teuchos::RCP<const tpetra::Map> getRangeMap() const override { return map_; }
  void apply(const tpetra::MultiVector& x, tpetra::MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    std::vector<double> result(map_->getNodeNumElements());
    for (std::size_t column = 0; column < x.getNumVectors(); ++column) {
      const auto in = x.getData(column);
      // Where an iteration begins from nothing.
      const bool isZero = std::all_of(in.begin(), in.end(), [](double entry) { return entry == 0.0; });
      if (comm_.any(!isZero))
        function_(in.getRawPtr(), result.data());
      else
        std::fill(result.begin(), result.end(), 0.0);
      const auto out = y.getDataNonConst(column);
      for (std::size_t i = 0; i < result.size(); ++i) {
        double& value = out[static_cast<Teuchos::Ordinal>(i)];
        value = alpha * result[i] + (beta == 0.0 ? 0.0 : beta * value);
      }
    }
  }

 private:
  const Communicator& comm_;
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

GmresReport solveByGmres(const Communicator& comm, const LinearMap& matrix, const LinearMap& precondition,
                         const std::vector<double>& b, std::vector<double>& x, double relativeTolerance,
                         int maximumIterations, int nKept) {
  const auto map = mapOfRows(comm.mpi(), b.size());
  const auto rightSide = vectorOf(map, b), solution = vectorOf(map, x);
  Teuchos::Array<double> norm(1);
  rightSide->norm2(norm());
  const double size = norm[0];
  if (size == 0.0) {
    std::fill(x.begin(), x.end(), 0.0);
    return {0, 0.0, true};
  }
  const auto product = Teuchos::rcp(new FunctionOperator(comm, map, matrix));
  const auto preconditioner = Teuchos::rcp(new FunctionOperator(comm, map, precondition));
  GmresReport report;
  // The recurrence of GMRES may be ahead of the true residual, by rounding or since the preconditioner's precision is
  // single: then it goes on from there.
  for (int pass = 0; pass < 3 && !report.hasConverged && report.iterations < maximumIterations; ++pass) {
    const KrylovResult result = runKrylov("GMRES", product, preconditioner, rightSide, solution, relativeTolerance,
                                          maximumIterations - report.iterations, nKept);
    tpetra::MultiVector difference(*rightSide, Teuchos::Copy);
    product->apply(*solution, difference, Teuchos::NO_TRANS, -1.0, 1.0);
    difference.norm2(norm());
    report.iterations += result.iterations;
    report.relativeResidual = result.hasBrokenDown ? HUGE_VAL : norm[0] / size;
    report.hasConverged = report.relativeResidual <= 2.0 * relativeTolerance;
    if (result.hasBrokenDown || result.iterations == 0) break;
  }
  const auto values = solution->getData(0);
  std::copy(values.begin(), values.end(), x.begin());
  return report;
}

}  // namespace pd
