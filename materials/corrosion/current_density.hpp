// Anodic current density of a dissolving metal as a function of the concentration of its ions at the surface.
#ifndef PD_CURRENT_DENSITY_HPP
#define PD_CURRENT_DENSITY_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "parameters.hpp"
#include "sampled_function.hpp"

namespace pd {

/// i(C), A/m2. Outside [0, C_sat] the value at the nearer end.
class CurrentDensity {
 public:
  struct Value {
    double current;  ///< A/m2
    double slope;    ///< di/dC, A m/mol
  };

  static void declareParameters(ParameterDeclarations& declare);
  /// `params`: completed; `saturation` in mol/m3. Throws std::invalid_argument, naming `owner`, where an expression
  /// cannot be read, or is not finite or negative somewhere between 0 and saturation.
  CurrentDensity(const Teuchos::ParameterList& params, double saturation, const std::string& owner);

  Value at(double concentration) const;

 private:
  void sample(const std::string& current, const std::string& ph, const std::string& owner);
  void readTable(const Teuchos::Array<double>& numbers, const std::string& owner);

  double saturation_;
  std::vector<double> concentrations_, values_;  ///< of a table; empty where there is none
  SampledFunction sampled_;
  bool isLogarithmic_ = false;  ///< samples are of ln i
};

}  // namespace pd

#endif
