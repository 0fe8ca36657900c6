#include "expression.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace pd {

Expression::Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& owner)
    : text_(text), owner_(owner), variables_(variables) {
  try {
    for (const MinusSign minusSign : {MinusSign::AfterPower, MinusSign::BeforePower})
      readings_.emplace_back(text, variables, minusSign);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(owner + ": " + error.what());
  }
}

double Expression::operator()(const std::vector<double>& values) const {
  const double value = readings_[0].evaluate(values.data()), peridigms = readings_[1].evaluate(values.data());
  if (value != peridigms && !(std::isnan(value) && std::isnan(peridigms)))
    refuse(values,
           "has a minus sign before a power, which Peridigm reads as (-a)^b and mathematics as -(a^b); write "
           "the parentheses. They differ");
  if (!std::isfinite(value)) refuse(values, std::isnan(value) ? "is not a number" : "is infinite");
  return value;
}

void Expression::refuse(const std::vector<double>& values, const std::string& why) const {
  std::ostringstream message;
  message.precision(6);
  message << owner_ << ": \"" << text_ << "\" " << why << " at ";
  for (std::size_t i = 0; i < values.size(); ++i)
    message << (i == 0 ? "" : ", ") << variables_[i] << " = " << values[i] << (variables_[i] == "C" ? " mol/L" : "");
  message << "; it must have a value from C = 0 to saturation";
  throw std::invalid_argument(message.str());
}

}  // namespace pd
