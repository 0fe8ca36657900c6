#include "current_density.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "expression.hpp"

namespace pd {

void CurrentDensity::declareParameters(ParameterDeclarations& declare) {
  declare
      .function("Current Density", "A/m2",
                "i of bare metal: a number, or an expression of C (mol/L), and of pH where that is given, such as "
                "\"1.0e4*pow(10, 1.151*exp(-0.723*pH) - 7.647)\".")
      .of({"C", "pH"});
  declare
      .function("pH", "1",
                "Expression of C (mol/L), for Current Density to use, and field pH of the electrolyte: "
                "\"7.405*exp(-0.08036*C) - 6.498\".")
      .of({"C"});
  declare.reals("Current Density Table", "mol/m3, A/m2",
                "Pairs C1, i1, C2, i2, ... with C rising; linear between them, constant beyond.");
  declare.exactlyOneOf({"Current Density", "Current Density Table"});
  declare.needs("pH", {"Current Density"});
}

CurrentDensity::CurrentDensity(const Teuchos::ParameterList& params, double saturation, const std::string& owner)
    : saturation_(saturation) {
  if (params.isParameter("Current Density Table"))
    readTable(params.get<Teuchos::Array<double>>("Current Density Table"), owner);
  else
    sample(params.get<std::string>("Current Density"),
           params.isParameter("pH") ? params.get<std::string>("pH") : std::string(), owner);
}

/// Interpolation of i, or of ln i where it is positive.
void CurrentDensity::sample(const std::string& current, const std::string& ph, const std::string& owner) {
  const bool usesPh = !ph.empty();
  const Expression ofCurrent(current, usesPh ? std::vector<std::string>{"C", "pH"} : std::vector<std::string>{"C"},
                             owner);
  const Expression ofPh(usesPh ? ph : "0", {"C"}, owner);
  std::vector<double> fine = SampledFunction::samples(saturation_, [&](double concentration) {
    const double c = concentration / litresPerCubicMetre;
    return usesPh ? ofCurrent({c, ofPh({c})}) : ofCurrent({c});
  });
  isLogarithmic_ = std::all_of(fine.begin(), fine.end(), [](double i) { return i > 0.0; });
  for (double& value : fine) {
    if (value < 0.0)
      throw std::invalid_argument(owner + ": the current density is negative at some concentration up to saturation");
    if (isLogarithmic_) value = std::log(value);
  }
  sampled_ = SampledFunction(saturation_, fine);
}

void CurrentDensity::readTable(const Teuchos::Array<double>& numbers, const std::string& owner) {
  if (numbers.size() < 4 || numbers.size() % 2 != 0)
    throw std::invalid_argument(owner + ": \"Current Density Table\" takes pairs C, i; at least two of them");
  for (int k = 0; k < numbers.size(); k += 2) {
    if (!concentrations_.empty() && !(numbers[k] > concentrations_.back()))
      throw std::invalid_argument(owner + ": concentrations of \"Current Density Table\" must rise");
    concentrations_.push_back(numbers[k]);
    values_.push_back(numbers[k + 1]);
    if (values_.back() < 0.0)
      throw std::invalid_argument(owner + ": the current density is negative at some concentration up to saturation");
  }
}

CurrentDensity::Value CurrentDensity::at(double concentration) const {
  if (!concentrations_.empty()) {
    if (concentration <= concentrations_.front()) return {values_.front(), 0.0};
    if (concentration >= concentrations_.back()) return {values_.back(), 0.0};
    const auto next = std::upper_bound(concentrations_.begin(), concentrations_.end(), concentration);
    const auto k = static_cast<std::size_t>(next - concentrations_.begin());
    const double slope = (values_[k] - values_[k - 1]) / (concentrations_[k] - concentrations_[k - 1]);
    return {values_[k - 1] + slope * (concentration - concentrations_[k - 1]), slope};
  }
  const SampledFunction::Value sampled = sampled_.at(concentration);
  if (!isLogarithmic_) return {sampled.value, sampled.slope};
  const double current = std::exp(sampled.value);
  return {current, current * sampled.slope};
}

}  // namespace pd
