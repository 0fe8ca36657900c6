// Values that a deck gives as functions of place and time.
#ifndef PD_FUNCTION_HPP
#define PD_FUNCTION_HPP

#include <memory>
#include <string>
#include <vector>

#include "deck.hpp"

namespace pd {

/// f(x, y, z, t): a number, a muParser expression ("0.02e-3*min(t/1000, 1)"), Peridigm's form ("value = ..." with
/// if/else, local variables and several assignments), or a table in time ("table: [[0, 0], [1000, 2e-5]]",
/// piecewise linear, constant outside).
class Function {
 public:
  /// Throws DeckError naming `place` where the text cannot be understood.
  Function(const std::string& text, const std::string& place);
  static Function constant(double value);
  static Function table(std::vector<double> times, std::vector<double> values);
  /// From a deck value: number, string or {Table: [[t, v], ...]}.
  static Function fromDeck(const DeckNode& node);

  double operator()(double x, double y, double z, double t) const;
  bool isConstant() const;
  /// Whether the value depends on t (then it must be evaluated again each step).
  bool dependsOnTime() const;

 private:
  Function() = default;
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

}  // namespace pd

#endif
