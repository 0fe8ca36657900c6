// The keys of a deck that choose how the linear systems of an implicit solver are solved.
#ifndef PD_LINEAR_SOLVER_SETTINGS_HPP
#define PD_LINEAR_SOLVER_SETTINGS_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "../../materials/registry/parameters.hpp"

namespace pd {

struct LinearSolverSettings {
  std::string method, preconditioner;  ///< as LinearSystem::solve() has them; preconditioner empty: none is given
  double tolerance;                    ///< 0: as tight as the solver needs
  int maximumIterations;
  bool logs;

  /// With Peridigm's names of the same keys.
  static void declareParameters(ParameterDeclarations& declare, const std::vector<std::string>& preconditioners);
  explicit LinearSolverSettings(const Teuchos::ParameterList& parameters);
};

}  // namespace pd

#endif
