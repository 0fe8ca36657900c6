// Expressions of a deck in concentration and pH.
#ifndef PD_CORROSION_EXPRESSION_HPP
#define PD_CORROSION_EXPRESSION_HPP

#include <RTC_FunctionRTC.hh>
#include <string>
#include <vector>

namespace pd {

constexpr double litresPerCubicMetre = 1000.0;  ///< expressions take C in mol/L

/// An expression of up to two variables, in the C of Trilinos' run-time compiler as Peridigm's decks use it.
class Expression {
 public:
  /// Throws std::invalid_argument, naming `owner`, where `text` cannot be read.
  Expression(const std::string& text, const std::vector<std::string>& variables, const std::string& owner);
  /// Throws std::invalid_argument, naming the owner, where there is no finite value.
  double operator()(double first, double second = 0.0);

 private:
  PG_RuntimeCompiler::Function function_;
  std::string text_, owner_;
  unsigned result_;
};

}  // namespace pd

#endif
