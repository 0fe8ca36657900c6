#include "linear_solver_settings.hpp"

#include <algorithm>

#include "declarations.hpp"

namespace pd {

void LinearSolverSettings::declareParameters(ParameterDeclarations& declare,
                                             const std::vector<std::string>& preconditioners) {
  declare
      .text("Linear Solver",
            "CG (goes on with GMRES where the tangent is not positive definite), GMRES, or Direct (sparse LU, gathered "
            "on one rank). CG where nothing is given.")
      .oneOf({"CG", "GMRES", "Direct"});
  declare.text("Belos Linear Solver", "Peridigm's name of Linear Solver.").oneOf({"BlockCG", "BlockGMRES"});
  if (std::find(preconditioners.begin(), preconditioners.end(), "Two Level") == preconditioners.end())
    declare.text("Preconditioner", "Of CG and GMRES.").defaultTo("Multigrid").oneOf(preconditioners);
  else
    declare
        .text("Preconditioner",
              "Of CG and GMRES. Two Level (of CG): no matrix is made; the bonds of the undeformed body are springs, "
              "whose affine displacements, piece by piece, are solved for exactly. Where nothing is given: Two Level "
              "for CG where all materials give such springs (PDHE, Elastic, Elastic Bond Based), else Multigrid.")
        .oneOf(preconditioners);
  declare
      .real("Linear Tolerance", "1",
            "Relative residual of the linear solves. As tight as the load step's tolerance needs where none is given.")
      .strictlyBetween(0.0, 1.0);
  declare.real("Belos Relative Tolerance", "1", "Peridigm's name of Linear Tolerance.").strictlyBetween(0.0, 1.0);
  declare.integer("Maximum Linear Iterations", "Of a linear solve; 2000 where none is given.").atLeast(1);
  declare.integer("Belos Maximum Iterations", "Peridigm's name of Maximum Linear Iterations.").atLeast(1);
  declare.flag("Belos Print Status", "Log every linear solve.").defaultTo(false);
  declare.atMostOneOf({"Linear Solver", "Belos Linear Solver"});
  declare.atMostOneOf({"Linear Tolerance", "Belos Relative Tolerance"});
  declare.atMostOneOf({"Maximum Linear Iterations", "Belos Maximum Iterations"});
}

LinearSolverSettings::LinearSolverSettings(const Teuchos::ParameterList& parameters)
    : method(either<std::string>(parameters, "Linear Solver", "Belos Linear Solver", "CG")),
      preconditioner(parameters.isParameter("Preconditioner") ? parameters.get<std::string>("Preconditioner") : ""),
      tolerance(either(parameters, "Linear Tolerance", "Belos Relative Tolerance", 0.0)),
      maximumIterations(either(parameters, "Maximum Linear Iterations", "Belos Maximum Iterations", 2000)),
      logs(parameters.get<bool>("Belos Print Status")) {
  if (method == "BlockCG") method = "CG";
  if (method == "BlockGMRES") method = "GMRES";
}

}  // namespace pd
