#include "expression.hpp"

#include <cmath>
#include <stdexcept>

namespace pd {

Expression::Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& owner)
    : function_(static_cast<unsigned>(variables.size()) + 1u, "expression"),
      text_(text),
      owner_(owner),
      result_(static_cast<unsigned>(variables.size())) {
  bool isGood = true;
  for (const std::string& name : variables) isGood = isGood && function_.addVar("double", name);
  isGood = isGood && function_.addVar("double", "value");
  const bool isBody = text.find("value") != std::string::npos;
  isGood = isGood && function_.addBody(isBody ? text : "value = " + text);
  if (!isGood) throw std::invalid_argument(owner + ": cannot read \"" + text + "\": " + function_.getErrors());
}

double Expression::operator()(double first, double second) {
  bool isGood = function_.varValueFill(0, first);
  if (result_ > 1) isGood = isGood && function_.varValueFill(1, second);
  isGood = isGood && function_.varValueFill(result_, 0.0) && function_.execute();
  const double value = isGood ? function_.getValueOfVar("value") : NAN;
  if (!std::isfinite(value))
    throw std::invalid_argument(owner_ + ": \"" + text_ + "\" has no finite value at " + std::to_string(first) +
                                "; concentrations of expressions are in mol/L");
  return value;
}

}  // namespace pd
