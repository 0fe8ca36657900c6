#include "linear_system.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "assembled_matrix.hpp"
#include "methods/direct_solver.hpp"
#include "methods/krylov.hpp"

namespace pd {

struct LinearSystem::Implementation {
  Implementation(const Communicator& communicator, const Discretization& discretization, int width,
                 bool couplesFamilies)
      : comm(communicator),
        assembled(communicator, discretization, width, couplesFamilies),
        nullspace(assembled.makeNullspace(discretization)) {}

  const Communicator& comm;
  AssembledMatrix assembled;
  Teuchos::RCP<tpetra::MultiVector> nullspace;

  // Kept from one solve to the next while the matrix stays the same.
  Teuchos::RCP<tpetra::Operator> preconditioner;
  std::string preconditionerName;
  std::unique_ptr<DirectSolver> direct;
  bool isIndefinite = false;  ///< CG has met a direction of negative curvature

  AssembledMatrix& changed() {
    preconditioner = Teuchos::null;
    preconditionerName.clear();
    direct.reset();
    isIndefinite = false;
    return assembled;
  }
  double relativeResidual(const tpetra::MultiVector& b, const tpetra::MultiVector& x) const;
  void solveDirectly(const tpetra::MultiVector& b, tpetra::MultiVector& x, double tolerance, LinearSolveReport& report);
  void solveByKrylov(const Teuchos::RCP<tpetra::MultiVector>& b, const Teuchos::RCP<tpetra::MultiVector>& x,
                     double tolerance, int maximumIterations, LinearSolveReport& report);
};

LinearSystem::LinearSystem(const Communicator& comm, const Discretization& discretization, int width,
                           bool couplesFamilies)
    : implementation_(std::make_unique<Implementation>(comm, discretization, width, couplesFamilies)) {}

LinearSystem::~LinearSystem() = default;

void LinearSystem::putScalar(double value) { implementation_->changed().fill(value); }

void LinearSystem::addValue(int globalRow, int globalCol, double value) {
  implementation_->assembled.addValue(globalRow, globalCol, value);
}

void LinearSystem::addValues(int numIndices, const int* globalIndices, const double* const* values) {
  implementation_->assembled.addBlock(numIndices, globalIndices, values, false);
}

void LinearSystem::addBlockDiagonalValues(int numIndices, const int* globalIndices, const double* const* values) {
  implementation_->assembled.addBlock(numIndices, globalIndices, values, true);
}

void LinearSystem::addToDiagonal(int ownedPoint, int component, double value) {
  AssembledMatrix& matrix = implementation_->changed();
  if (component < matrix.kept()) matrix.ownEntry(ownedPoint, component, component) += value;
}

void LinearSystem::scale(double factor) { implementation_->changed().scale(factor); }

void LinearSystem::finish(const std::vector<char>& isConstrained) { implementation_->changed().finish(isConstrained); }

bool LinearSystem::graphIsTooSmall() const { return implementation_->assembled.graphIsTooSmall(); }

std::vector<double> LinearSystem::diagonal() const {
  const std::vector<double> blocks = diagonalBlocks();
  const auto width = static_cast<std::size_t>(implementation_->assembled.width());
  std::vector<double> result;
  for (std::size_t point = 0; point < blocks.size() / (width * width); ++point)
    for (std::size_t c = 0; c < width; ++c) result.push_back(blocks[(point * width + c) * width + c]);
  return result;
}

std::vector<double> LinearSystem::diagonalBlocks() const {
  AssembledMatrix& matrix = implementation_->assembled;
  std::vector<double> result;
  for (int point = 0; point < matrix.nOwned(); ++point)
    for (int c = 0; c < matrix.width(); ++c)
      for (int d = 0; d < matrix.width(); ++d) {
        const bool isKept = c < matrix.kept() && d < matrix.kept();
        result.push_back(isKept ? matrix.ownEntry(point, c, d) : (c == d ? 1.0 : 0.0));
      }
  return result;
}

void LinearSystem::apply(const double* x, double* y) const {
  const AssembledMatrix& assembled = implementation_->assembled;
  const auto in = assembled.vectorOf(x);
  tpetra::MultiVector out(assembled.matrix()->getRangeMap(), 1);
  assembled.matrix()->apply(*in, out);
  assembled.copyBack(out, x, y);
}

double LinearSystem::Implementation::relativeResidual(const tpetra::MultiVector& b,
                                                      const tpetra::MultiVector& x) const {
  tpetra::MultiVector residual(b, Teuchos::Copy);
  assembled.matrix()->apply(x, residual, Teuchos::NO_TRANS, -1.0, 1.0);
  Teuchos::Array<double> normOfB(1), norm(1);
  b.norm2(normOfB());
  residual.norm2(norm());
  if (normOfB[0] == 0.0) return norm[0] == 0.0 ? 0.0 : HUGE_VAL;
  return norm[0] / normOfB[0];
}

void LinearSystem::Implementation::solveDirectly(const tpetra::MultiVector& b, tpetra::MultiVector& x, double tolerance,
                                                 LinearSolveReport& report) {
  if (!direct) direct = std::make_unique<DirectSolver>(comm.mpi(), *assembled.matrix());
  x.putScalar(0.0);
  report.relativeResidual = 1.0;
  // One solve, and at most two of its residual where rounding has left too much of it.
  for (int pass = 0; pass < 3 && report.relativeResidual > tolerance; ++pass) {
    tpetra::MultiVector residual(b, Teuchos::Copy), correction(x.getMap(), 1);
    assembled.matrix()->apply(x, residual, Teuchos::NO_TRANS, -1.0, 1.0);
    if (!direct->solve(residual.getData(0).getRawPtr(), correction.getDataNonConst(0).getRawPtr())) return;
    tpetra::MultiVector improved(x, Teuchos::Copy);
    improved.update(1.0, correction, 1.0);
    const double achieved = relativeResidual(b, improved);
    if (pass > 0 && !(achieved < report.relativeResidual)) return;
    x.assign(improved);
    report.relativeResidual = achieved;
    report.iterations = pass + 1;
  }
}

void LinearSystem::Implementation::solveByKrylov(const Teuchos::RCP<tpetra::MultiVector>& b,
                                                 const Teuchos::RCP<tpetra::MultiVector>& x, double tolerance,
                                                 int maximumIterations, LinearSolveReport& report) {
  // The recurrence drifts away from the true residual; then the method starts again from what it has.
  double before = HUGE_VAL;
  if (isIndefinite) report.method = "GMRES";
  while (report.iterations < maximumIterations) {
    const auto attempt = Teuchos::rcp(new tpetra::MultiVector(*x, Teuchos::Copy));
    const KrylovResult result = runKrylov(report.method, assembled.matrix(), preconditioner, b, attempt, tolerance,
                                          maximumIterations - report.iterations);
    report.iterations += result.iterations;
    if (result.hasBrokenDown) {
      if (report.method == "GMRES") break;
      isIndefinite = true;
      report.method = "GMRES";
      continue;
    }
    report.relativeResidual = relativeResidual(*b, *attempt);
    if (std::isfinite(report.relativeResidual)) x->assign(*attempt);
    if (report.relativeResidual <= tolerance || !(report.relativeResidual < 0.5 * before) || result.iterations == 0)
      break;
    before = report.relativeResidual;
  }
}

LinearSolveReport LinearSystem::solve(const double* b, double* x, const std::string& method,
                                      const std::string& preconditioner, double relativeTolerance,
                                      int maximumIterations) {
  Implementation& self = *implementation_;
  if (method != "CG" && method != "GMRES" && method != "Direct")
    throw std::invalid_argument("unknown linear solver \"" + method + "\" (known: CG, GMRES, Direct)");
  LinearSolveReport report;
  report.method = method;
  const auto rightSide = self.assembled.vectorOf(b);
  const auto solution = self.assembled.vectorOf(x);
  Teuchos::Array<double> normOfB(1);
  rightSide->norm2(normOfB());
  if (normOfB[0] == 0.0) {
    solution->putScalar(0.0);
  } else if (method == "Direct") {
    self.solveDirectly(*rightSide, *solution, relativeTolerance, report);
  } else {
    if (self.preconditionerName != preconditioner) {
      self.preconditioner =
          makePreconditioner(preconditioner, self.assembled.matrix(), self.assembled.kept(), self.nullspace);
      self.preconditionerName = preconditioner;
    }
    report.relativeResidual = 1.0;
    self.solveByKrylov(rightSide, solution, relativeTolerance, maximumIterations, report);
  }
  report.hasConverged = report.relativeResidual <= relativeTolerance;
  self.assembled.copyBack(*solution, b, x);
  return report;
}

}  // namespace pd
