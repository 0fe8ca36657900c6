// Load steps: the increments of a solver of states without inertia.
#ifndef PD_LOAD_STEPS_HPP
#define PD_LOAD_STEPS_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "../../materials/registry/parameters.hpp"

namespace pd {

/// `Load Steps` (Peridigm's `Number of Load Steps`) of equal length, or a list of `Time Steps`.
class LoadSteps {
 public:
  static void declareParameters(ParameterDeclarations& declare);
  /// From a completed list. Throws std::invalid_argument, naming `solver`.
  LoadSteps(const Teuchos::ParameterList& parameters, const std::string& solver);

  /// Throws RunError where the list of times does not go from t0 to t1.
  int count(double t0, double t1) const;
  /// End of load step 1 ... nSteps; of 0, the start.
  double end(int step, int nSteps, double t0, double t1) const;

 private:
  std::string solver_;
  int nSteps_ = 1;
  std::vector<double> times_;  ///< of the steps' ends, the start first; empty: equal steps
};

}  // namespace pd

#endif
