// pH of an electrolyte as a function of the concentration of metal ions in it.
#ifndef PD_ACIDITY_HPP
#define PD_ACIDITY_HPP

#include <Teuchos_ParameterList.hpp>
#include <optional>
#include <string>

#include "sampled_function.hpp"

namespace pd {

/// The parameter "pH" that CurrentDensity declares.
class Acidity {
 public:
  /// `params`: completed; `saturation` in mol/m3. Throws std::invalid_argument, naming `owner`, where the expression
  /// cannot be read or is not finite somewhere between 0 and saturation.
  Acidity(const Teuchos::ParameterList& params, double saturation, const std::string& owner);

  bool isGiven() const { return ph_.has_value(); }
  /// C in mol/m3. Outside [0, C_sat] the value at the nearer end. Only where it is given.
  double at(double concentration) const { return ph_->at(concentration).value; }

 private:
  std::optional<SampledFunction> ph_;
};

}  // namespace pd

#endif
