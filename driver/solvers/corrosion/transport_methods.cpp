#include "transport_methods.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "explicit_step.hpp"
#include "implicit_step.hpp"
#include "newton_krylov.hpp"
#include "polak_ribiere.hpp"

namespace pd {

namespace {

constexpr const char* newtonKrylov = "Newton Krylov";

}  // namespace

void declareTransportMethods(ParameterDeclarations& declare) {
  declare
      .text("Method",
            "Of a step at given phases. Backward Euler and SDIRK2 are implicit, the latter of second order in two "
            "stages; "
            "C may exceed saturation by up to 1 % in it. Euler: explicit, in sub-steps of 0.9 of the longest stable "
            "one. RKL: Runge-Kutta-Legendre of second order, explicit with as many stages as stability asks for. The "
            "last two are for comparison.")
      .defaultTo("Backward Euler")
      .oneOf({"Backward Euler", "SDIRK2", "Euler", "RKL"})
      .from("Alexander, SIAM J. Numer. Anal. 14 (1977) 1006; Meyer, Balsara & Aslam, J. Comput. Phys. 257 (2014) 594");
  declare
      .text("Nonlinear Solver",
            "Of a stage of Backward Euler or SDIRK2: Newton's method with conjugate gradients and a preconditioner; or "
            "Polak and Ribiere's nonlinear conjugate gradients, for comparison.")
      .defaultTo(newtonKrylov)
      .oneOf({newtonKrylov, "Polak Ribiere"})
      .from("Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512, section 5.3");
  declare
      .text(
          "Saturation",
          "Complementarity: salt covers the share of a surface that keeps C at saturation, in steps of any length. "
          "Pause: a surface with C at saturation when a step (Euler: sub-step) begins does not dissolve in it, others "
          "dissolve freely; C may then exceed saturation by what a bare surface gives in one step, so steps must be "
          "short.")
      .defaultTo("Complementarity")
      .oneOf({"Complementarity", "Pause"})
      .from("Jafarzadeh, Zhao, Shakouri & Bobaru, Electrochim. Acta 401 (2022) 139512, eq. 14");
  declare
      .real("Solver Tolerance", "1",
            "Largest residual of an implicit step, of saturation. Mass is conserved to rounding whatever it is.")
      .defaultTo(1e-9)
      .strictlyBetween(1e-14, 1.0);
  declare
      .integer("Maximum Linear Iterations",
               "Of one linear solve of an implicit step; with Polak Ribiere, of one nonlinear solve.")
      .defaultTo(5000)
      .atLeast(1);
}

std::unique_ptr<TransportStep> makeTransportStep(const Teuchos::ParameterList& params) {
  const auto method = params.get<std::string>("Method"), field = params.get<std::string>("Concentration Field");
  const Saturation saturation =
      params.get<std::string>("Saturation") == "Pause" ? Saturation::Pause : Saturation::Complementarity;
  const bool isNewton = params.get<std::string>("Nonlinear Solver") == newtonKrylov;
  if (!isNewton && (method == "Euler" || method == "RKL"))
    throw std::invalid_argument("Corrosion: \"Nonlinear Solver\" has no meaning with Method: " + method +
                                " (it belongs to Backward Euler and SDIRK2)");
  if (method == "Euler") return std::make_unique<ExplicitStep>(ExplicitMethod::Euler, saturation, field);
  if (method == "RKL") return std::make_unique<ExplicitStep>(ExplicitMethod::Legendre, saturation, field);
  const double tolerance = params.get<double>("Solver Tolerance");
  const int mostIterations = params.get<int>("Maximum Linear Iterations");
  std::unique_ptr<StageSolver> solver;
  if (isNewton)
    solver = std::make_unique<NewtonKrylov>(tolerance, mostIterations);
  else
    solver = std::make_unique<PolakRibiere>(tolerance, mostIterations);
  return std::make_unique<ImplicitStep>(method == "SDIRK2" ? ImplicitMethod::Sdirk2 : ImplicitMethod::BackwardEuler,
                                        std::move(solver), saturation, field);
}

}  // namespace pd
