// Expressions of a deck in concentration and pH.
#ifndef PD_CORROSION_EXPRESSION_HPP
#define PD_CORROSION_EXPRESSION_HPP

#include <string>
#include <vector>

#include "function_program.hpp"

namespace pd {

constexpr double litresPerCubicMetre = 1000.0;  ///< expressions take C in mol/L

/// An expression of C, or of C and pH. A material does not know whether its deck is one of Peridigm, where -C^2 is
/// (-C)^2: what the two conventions read differently is refused.
class Expression {
 public:
  /// Throws std::invalid_argument, naming `owner`, where `text` cannot be read.
  Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& owner);
  /// `values`: one for each variable, in their order. Throws std::invalid_argument, naming the owner and the values,
  /// where the result is not finite, or depends on the convention.
  double operator()(const std::vector<double>& values) const;

 private:
  [[noreturn]] void refuse(const std::vector<double>& values, const std::string& why) const;

  std::string text_, owner_;
  std::vector<std::string> variables_;
  std::vector<FunctionProgram> readings_;  ///< in mathematics, in Peridigm
};

}  // namespace pd

#endif
