#include "row_system.hpp"

#include <algorithm>
#include <cmath>

#include "methods/krylov.hpp"
#include "methods/mumps_factor.hpp"
#include "methods/rows_to_tpetra.hpp"

namespace pd {

namespace {

/// y = A^-1 x by a factor.
class FactorOperator : public tpetra::Operator {
 public:
  FactorOperator(Teuchos::RCP<const tpetra::Map> map, std::unique_ptr<MumpsFactor> factor)
      : map_(std::move(map)), factor_(std::move(factor)) {}

  const MumpsFactor& factor() const { return *factor_; }
  Teuchos::RCP<const tpetra::Map> getDomainMap() const override { return map_; }
  Teuchos::RCP<const tpetra::Map> getRangeMap() const override { return map_; }
  void apply(const tpetra::MultiVector& x, tpetra::MultiVector& y, Teuchos::ETransp, double alpha,
             double beta) const override {
    std::vector<double> solution(map_->getNodeNumElements());
    for (std::size_t column = 0; column < x.getNumVectors(); ++column) {
      factor_->solve(x.getData(column).getRawPtr(), solution.data());
      const auto out = y.getDataNonConst(column);
      for (std::size_t i = 0; i < solution.size(); ++i) {
        double& value = out[static_cast<Teuchos::Ordinal>(i)];
        value = alpha * solution[i] + (beta == 0.0 ? 0.0 : beta * value);
      }
    }
  }

 private:
  Teuchos::RCP<const tpetra::Map> map_;
  std::unique_ptr<MumpsFactor> factor_;
};

}  // namespace

void SparseRows::addRow(std::vector<std::pair<long long, double>>& entries) {
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k > 0 && entries[k].first == entries[k - 1].first) {
      values.back() += entries[k].second;
    } else {
      columns.push_back(entries[k].first);
      values.push_back(entries[k].second);
    }
  }
  start.push_back(columns.size());
}

struct RowSystem::Implementation {
  const Communicator& comm;
  Teuchos::RCP<tpetra::Matrix> matrix;
  Teuchos::RCP<const tpetra::Operator> factor;  ///< or preconditioner

  double residual(const tpetra::MultiVector& b, const tpetra::MultiVector& x) const {
    tpetra::MultiVector difference(b, Teuchos::Copy);
    matrix->apply(x, difference, Teuchos::NO_TRANS, -1.0, 1.0);
    Teuchos::Array<double> norm(1);
    difference.norm2(norm());
    return norm[0];
  }
};

RowSystem::RowSystem(const Communicator& comm) : implementation_(new Implementation{comm, {}, {}}) {}
RowSystem::~RowSystem() = default;

void RowSystem::setMatrix(const SparseRows& rows) {
  Implementation& self = *implementation_;
  const auto map = mapOfRows(self.comm.mpi(), rows.count());
  self.matrix = matrixOfRows(map, rows);
  if (!self.factor.is_null() && !self.factor->getRangeMap()->isSameAs(*map)) self.factor = Teuchos::null;
}

std::string RowSystem::factor() {
  Implementation& self = *implementation_;
  const auto local = self.matrix->getLocalMatrixHost();
  const auto ownRows = static_cast<int>(self.matrix->getNodeNumRows());
  std::vector<int> rows, columns;
  std::vector<double> values;
  for (int row = 0; row < ownRows; ++row)
    for (auto k = local.graph.row_map(row); k < local.graph.row_map(row + 1); ++k) {
      if (local.values(k) == 0.0) continue;
      rows.push_back(static_cast<int>(self.matrix->getRowMap()->getGlobalElement(row)) + 1);
      columns.push_back(static_cast<int>(self.matrix->getColMap()->getGlobalElement(local.graph.entries(k))) + 1);
      values.push_back(local.values(k));
    }
  self.factor = Teuchos::null;  // its memory goes first
  auto factor = std::make_unique<MumpsFactor>(self.comm.mpi(), static_cast<int>(self.matrix->getGlobalNumRows()),
                                              ownRows, std::move(rows), std::move(columns), std::move(values));
  if (!factor->trouble().empty()) return factor->trouble();
  self.factor = Teuchos::rcp(new FactorOperator(self.matrix->getRowMap(), std::move(factor)));
  return "";
}

void RowSystem::precondition(const std::string& name) {
  Implementation& self = *implementation_;
  self.factor = Teuchos::null;
  const auto constants = Teuchos::rcp(new tpetra::MultiVector(self.matrix->getRowMap(), 1));
  constants->putScalar(1.0);
  self.factor = makePreconditioner(name, self.matrix, 1, constants);
}

bool RowSystem::hasFactor() const { return !implementation_->factor.is_null(); }
double RowSystem::factorEntries() const {
  const auto* factor = dynamic_cast<const FactorOperator*>(implementation_->factor.get());
  return factor != nullptr ? factor->factor().entries() : 0.0;
}

RowSolveReport RowSystem::solve(const std::vector<double>& b, std::vector<double>& x, double relativeTolerance,
                                int maximumIterations) const {
  const Implementation& self = *implementation_;
  const auto map = self.matrix->getRowMap();
  const auto vectorOf = [&](const std::vector<double>& values) {
    const auto vector = Teuchos::rcp(new tpetra::MultiVector(map, 1));
    std::copy(values.begin(), values.end(), vector->getDataNonConst(0).begin());
    return vector;
  };
  const auto rightSide = vectorOf(b), solution = vectorOf(x);
  Teuchos::Array<double> size(1);
  rightSide->norm2(size());
  RowSolveReport report;
  if (size[0] == 0.0) {
    std::fill(x.begin(), x.end(), 0.0);
    report.hasConverged = true;
    return report;
  }
  const KrylovResult result =
      runKrylov("GMRES", self.matrix, self.factor, rightSide, solution, relativeTolerance, maximumIterations);
  report.iterations = result.iterations;
  report.relativeResidual = result.hasBrokenDown ? HUGE_VAL : self.residual(*rightSide, *solution) / size[0];
  // The recurrence of GMRES may be ahead of the true residual by rounding.
  report.hasConverged = report.relativeResidual <= 2.0 * relativeTolerance;
  const auto values = solution->getData(0);
  std::copy(values.begin(), values.end(), x.begin());
  return report;
}

}  // namespace pd
