#include "krylov.hpp"

#include <BelosPseudoBlockCGSolMgr.hpp>
#include <BelosPseudoBlockGmresSolMgr.hpp>
#include <BelosTpetraAdapter.hpp>
#include <algorithm>
#include <cmath>

namespace pd {

namespace {

using Problem = Belos::LinearProblem<double, tpetra::MultiVector, tpetra::Operator>;
using Manager = Belos::SolverManager<double, tpetra::MultiVector, tpetra::Operator>;
using ConjugateGradients = Belos::PseudoBlockCGSolMgr<double, tpetra::MultiVector, tpetra::Operator>;
using Gmres = Belos::PseudoBlockGmresSolMgr<double, tpetra::MultiVector, tpetra::Operator>;

Teuchos::RCP<Teuchos::ParameterList> settings(double tolerance, int maximumIterations) {
  auto list = Teuchos::parameterList();
  list->set("Convergence Tolerance", tolerance);
  list->set("Maximum Iterations", maximumIterations);
  list->set("Implicit Residual Scaling", "Norm of RHS");
  list->set("Verbosity", static_cast<int>(Belos::Errors));
  return list;
}

Teuchos::RCP<Manager> makeManager(const std::string& method, const Teuchos::RCP<Problem>& problem, double tolerance,
                                  int maximumIterations, int nKept) {
  const auto list = settings(tolerance, maximumIterations);
  if (method == "CG") return Teuchos::rcp(new ConjugateGradients(problem, list));
  list->set("Explicit Residual Scaling", "Norm of RHS");
  list->set("Num Blocks", std::min(nKept, maximumIterations));
  list->set("Maximum Restarts", maximumIterations / nKept + 1);
  return Teuchos::rcp(new Gmres(problem, list));
}

}  // namespace

KrylovResult runKrylov(const std::string& method, const Teuchos::RCP<const tpetra::Operator>& matrix,
                       const Teuchos::RCP<const tpetra::Operator>& preconditioner,
                       const Teuchos::RCP<const tpetra::MultiVector>& b, const Teuchos::RCP<tpetra::MultiVector>& x,
                       double tolerance, int maximumIterations, int nKept) {
  const auto problem = Teuchos::rcp(new Problem(matrix, x, b));
  if (!preconditioner.is_null()) {
    if (method == "CG")
      problem->setLeftPrec(preconditioner);
    else
      problem->setRightPrec(preconditioner);  // the residual that GMRES minimises stays the true one
  }
  problem->setProblem();
  const Teuchos::RCP<Manager> manager = makeManager(method, problem, tolerance, maximumIterations, nKept);
  KrylovResult result;
  try {
    manager->solve();
  } catch (const std::exception&) {
    result.hasBrokenDown = true;  // Belos throws where p'Ap <= 0 or a norm is not a number, on all ranks alike
  }
  result.iterations = manager->getNumIters();
  return result;
}

}  // namespace pd
