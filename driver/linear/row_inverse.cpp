#include "row_inverse.hpp"

#include <stdexcept>

#include "methods/krylov.hpp"
#include "methods/mumps_factor.hpp"
#include "methods/rows_to_tpetra.hpp"

namespace pd {

struct RowInverse::Implementation {
  const Communicator& comm;
  std::size_t count = 0;  ///< rows of this rank
  std::unique_ptr<MumpsFactor> factor;
  Teuchos::RCP<tpetra::Matrix> matrix;
  Teuchos::RCP<tpetra::Operator> preconditioner;  ///< of `matrix`

  void forget() {
    factor.reset();
    preconditioner = Teuchos::null;
    matrix = Teuchos::null;
  }
};

RowInverse::RowInverse(const Communicator& comm) : implementation_(new Implementation{comm, 0, {}, {}, {}}) {}
RowInverse::~RowInverse() = default;

std::string RowInverse::factor(const SparseRows& rows, FactorPrecision precision) {
  Implementation& self = *implementation_;
  self.forget();  // its memory goes first
  self.count = rows.count();
  self.factor = std::make_unique<MumpsFactor>(self.comm.mpi(), rows, precision);
  const std::string trouble = self.factor->trouble();
  if (!trouble.empty()) self.forget();
  return trouble;
}

void RowInverse::precondition(const std::string& name, const SparseRows& rows) {
  Implementation& self = *implementation_;
  self.forget();
  self.count = rows.count();
  self.matrix = matrixOfRows(mapOfRows(self.comm.mpi(), rows.count()), rows);
  const auto constants = Teuchos::rcp(new tpetra::MultiVector(self.matrix->getRowMap(), 1));
  constants->putScalar(1.0);
  self.preconditioner = makePreconditioner(name, self.matrix, 1, constants);
}

bool RowInverse::isMadeFor(std::size_t count) const {
  const Implementation& self = *implementation_;
  const bool isMade = self.factor != nullptr || !self.preconditioner.is_null();
  return !self.comm.any(!isMade || count != self.count);
}

double RowInverse::factorEntries() const {
  return implementation_->factor != nullptr ? implementation_->factor->entries() : 0.0;
}

void RowInverse::apply(const double* b, double* x, std::size_t count) const {
  const Implementation& self = *implementation_;
  if (self.factor != nullptr) {
    for (std::size_t k = 0; k < count; ++k) self.factor->solve(b + k * self.count, x + k * self.count);
    return;
  }
  if (self.preconditioner.is_null()) throw std::logic_error("an inverse is applied that has not been made");
  const auto map = self.matrix->getRowMap();
  const tpetra::MultiVector rightSides(map, Teuchos::ArrayView<const double>(b, static_cast<int>(self.count * count)),
                                       self.count, count);
  tpetra::MultiVector solutions(map, count);
  self.preconditioner->apply(rightSides, solutions);
  for (std::size_t k = 0; k < count; ++k) {
    const auto values = solutions.getData(k);
    std::copy(values.begin(), values.end(), x + k * self.count);
  }
}

}  // namespace pd
