// Values that a deck gives as functions of place and time.
#ifndef PD_FUNCTION_HPP
#define PD_FUNCTION_HPP

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "deck.hpp"
#include "function_program.hpp"

namespace pd {

/// f(x, y, z, t): a number, a muParser expression ("0.02e-3*min(t/1000, 1)"), Peridigm's form ("value = ..." with
/// if/else, local variables and several assignments), or a table in time ({Table: [[0, 0], [1000, 2e-5]]}, piecewise
/// linear, constant outside; of two equal times the later holds from then on).
/// Copies share their state: evaluate one function on one thread at a time.
class Function {
 public:
  /// Throws DeckError naming `place` where the text cannot be understood. `isPeridigms`: "-x^2" is (-x)^2, as there.
  Function(const std::string& text, const std::string& place, bool isPeridigms = false);
  static Function constant(double value);
  /// `times` must not decrease and be as many as `values`, at least one; throws std::invalid_argument.
  /// `place`: of the deck, for messages of at().
  static Function table(std::vector<double> times, std::vector<double> values, const std::string& place = "");
  /// From a deck value: number, string (Peridigm's in its decks) or {Table: [[t, v], ...]}. Throws DeckError.
  static Function fromDeck(const DeckNode& node);

  double operator()(double x, double y, double z, double t) const;
  /// The value at a point of a mesh, `x` [3] its coordinates, m, `id` its number from 0. Throws DeckError that names
  /// the place of the function, the point and the value, where that is not finite.
  double at(const double* x, double t, int id) const;
  bool isConstant() const;
  /// Whether the value depends on t (then it must be evaluated again each step).
  bool dependsOnTime() const;
  /// Whether it differs from place to place.
  bool dependsOnPlace() const;

 private:
  Function() = default;
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

/// What "-x^2" means in the deck of this value.
MinusSign minusSignOf(const DeckNode& node);

/// Throws DeckError naming `place` where the text is no function of these variables.
void checkFunction(const std::string& text, const std::string& place, const std::vector<std::string>& variables);

/// omega(zeta, horizon), the form of Peridigm's user-defined influence functions ("1.0/zeta"). Throws DeckError, and
/// so does the function where its value is not finite. `isPeridigms` as of Function.
std::function<double(double, double)> influenceFunction(const std::string& text, const std::string& place,
                                                        bool isPeridigms = false);

}  // namespace pd

#endif
