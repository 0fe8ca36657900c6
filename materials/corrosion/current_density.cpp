#include "current_density.hpp"

#include <RTC_FunctionRTC.hh>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pd {

namespace {

/// An expression of up to two variables, in the C of Trilinos' run-time compiler as Peridigm's decks use it.
class Expression {
 public:
  Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& owner)
      : function_(static_cast<unsigned>(variables.size()) + 1u, "currentDensity"), text_(text), owner_(owner) {
    bool isGood = true;
    for (const std::string& name : variables) isGood = isGood && function_.addVar("double", name);
    isGood = isGood && function_.addVar("double", "value");
    const bool isBody = text.find("value") != std::string::npos;
    isGood = isGood && function_.addBody(isBody ? text : "value = " + text);
    result_ = static_cast<unsigned>(variables.size());
    if (!isGood) throw std::invalid_argument(owner + ": cannot read \"" + text + "\": " + function_.getErrors());
  }
  double operator()(double first, double second = 0.0) {
    bool isGood = function_.varValueFill(0, first);
    if (result_ > 1) isGood = isGood && function_.varValueFill(1, second);
    isGood = isGood && function_.varValueFill(result_, 0.0) && function_.execute();
    const double value = isGood ? function_.getValueOfVar("value") : NAN;
    if (!std::isfinite(value))
      throw std::invalid_argument(owner_ + ": \"" + text_ + "\" has no finite value at " + std::to_string(first) +
                                  "; concentrations of expressions are in mol/L");
    return value;
  }

 private:
  PG_RuntimeCompiler::Function function_;
  std::string text_, owner_;
  unsigned result_ = 0;
};

constexpr double litresPerCubicMetre = 1000.0;

}  // namespace

void CurrentDensity::declareParameters(ParameterDeclarations& declare) {
  declare.text(
      "Current Density",
      "i, A/m2, of bare metal: a number, or an expression of C (mol/L), and of pH where that is given, such as "
      "\"1.0e4*pow(10, 1.151*exp(-0.723*pH) - 7.647)\".");
  declare.text("pH", "Expression of C (mol/L), for Current Density to use: \"7.405*exp(-0.08036*C) - 6.498\".");
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
  for (const double value : values_)
    if (!isLogarithmic_ && value < 0.0)
      throw std::invalid_argument(owner + ": the current density is negative at some concentration up to saturation");
}

/// Cubic interpolation of i, or of ln i where it is positive, over equal intervals: evaluated often, by many points.
void CurrentDensity::sample(const std::string& current, const std::string& ph, const std::string& owner) {
  const bool usesPh = !ph.empty();
  Expression ofCurrent(current, usesPh ? std::vector<std::string>{"C", "pH"} : std::vector<std::string>{"C"}, owner);
  Expression ofPh(usesPh ? ph : "0.0", {"C"}, owner);
  const auto exact = [&](double concentration) {
    const double c = concentration / litresPerCubicMetre;
    return usesPh ? ofCurrent(c, ofPh(c)) : ofCurrent(c);
  };
  constexpr int intervals = 2000;
  const double width = saturation_ / intervals;
  std::vector<double> fine;  // with half intervals
  for (int i = 0; i <= 2 * intervals; ++i) fine.push_back(exact(0.5 * width * i));
  isLogarithmic_ = std::all_of(fine.begin(), fine.end(), [](double i) { return i > 0.0; });
  if (isLogarithmic_)
    for (double& value : fine) value = std::log(value);
  const int last = 2 * intervals;
  for (int i = 0; i <= last; i += 2) {
    const auto at = [&](int k) { return fine[static_cast<std::size_t>(k)]; };
    values_.push_back(at(i));
    // Second order, one-sided at the ends.
    const double slope = i == 0      ? -3.0 * at(0) + 4.0 * at(1) - at(2)
                         : i == last ? 3.0 * at(last) - 4.0 * at(last - 1) + at(last - 2)
                                     : at(i + 1) - at(i - 1);
    slopes_.push_back(slope / width);
  }
}

void CurrentDensity::readTable(const Teuchos::Array<double>& numbers, const std::string& owner) {
  if (numbers.size() < 4 || numbers.size() % 2 != 0)
    throw std::invalid_argument(owner + ": \"Current Density Table\" takes pairs C, i; at least two of them");
  for (int k = 0; k < numbers.size(); k += 2) {
    if (!concentrations_.empty() && !(numbers[k] > concentrations_.back()))
      throw std::invalid_argument(owner + ": concentrations of \"Current Density Table\" must rise");
    concentrations_.push_back(numbers[k]);
    values_.push_back(numbers[k + 1]);
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
  const auto intervals = static_cast<double>(values_.size() - 1);
  const double width = saturation_ / intervals;
  const double c = std::clamp(concentration, 0.0, saturation_);
  const auto k = static_cast<std::size_t>(std::min(c / width, intervals - 1.0));
  const double t = c / width - static_cast<double>(k), s = 1.0 - t;
  // Cubic Hermite polynomial.
  const double y0 = values_[k], y1 = values_[k + 1], m0 = slopes_[k] * width, m1 = slopes_[k + 1] * width;
  const double value = s * s * ((1.0 + 2.0 * t) * y0 + t * m0) + t * t * ((1.0 + 2.0 * s) * y1 - s * m1);
  const double slope = (6.0 * t * s * (y1 - y0) + s * (1.0 - 3.0 * t) * m0 + t * (3.0 * t - 2.0) * m1) / width;
  const bool isInside = concentration >= 0.0 && concentration <= saturation_;
  if (!isLogarithmic_) return {value, isInside ? slope : 0.0};
  const double current = std::exp(value);
  return {current, isInside ? current * slope : 0.0};
}

}  // namespace pd
