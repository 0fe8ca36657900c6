// The library pd_multigrid, whole: multigrid by MueLu, for multigrid.cpp, which loads it.
#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Teuchos_oblackholestream.hpp>

#include "multigrid.hpp"

namespace {

Teuchos::ParameterList symmetricGaussSeidel(int sweeps) {
  Teuchos::ParameterList list;
  list.set("relaxation: type", "Symmetric Gauss-Seidel");
  list.set("relaxation: sweeps", sweeps);
  list.set("relaxation: use l1", true);  // across ranks it is a Jacobi step, which may be too long without this
  return list;
}

}  // namespace

/// The smoother is Gauss-Seidel since it is definite wherever the matrix is; Chebyshev's is not where the largest
/// eigenvalue is underestimated, as happens at crack tips. On several ranks the coarsest level is smoothed too, since a
/// direct solve fails there (direct_solver.hpp).
extern "C" void makeMueLu(const Teuchos::RCP<pd::tpetra::Matrix>* matrix, int width,
                          const Teuchos::RCP<pd::tpetra::MultiVector>* nullspace,
                          Teuchos::RCP<pd::tpetra::Operator>* result) {
  // Its verbosity covers not all that it prints.
  MueLu::VerboseObject::SetMueLuOStream(Teuchos::fancyOStream(Teuchos::rcp(new Teuchos::oblackholestream)));
  Teuchos::ParameterList list;
  list.set("verbosity", "none");
  list.set("number of equations", width);
  list.set("multigrid algorithm", "sa");
  list.set("smoother: type", "RELAXATION");
  list.sublist("smoother: params") = symmetricGaussSeidel(1);
  list.set("coarse: max size", 500);
  if ((*matrix)->getComm()->getSize() == 1) {
    list.set("coarse: type", "KLU2");
  } else {
    list.set("coarse: type", "RELAXATION");
    list.sublist("coarse: params") = symmetricGaussSeidel(10);
  }
  list.sublist("user data").set("Nullspace", *nullspace);
  *result = MueLu::CreateTpetraPreconditioner(Teuchos::RCP<pd::tpetra::Operator>(*matrix), list);
}
