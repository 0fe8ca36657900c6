// Units of measurement. Private to this folder.
#ifndef PD_UNITS_HPP
#define PD_UNITS_HPP

#include <array>
#include <optional>
#include <string>

namespace pd {

/// What a unit is in those of SI, and in radians.
struct Unit {
  std::array<int, 7> powers{};  ///< of m, kg, s, A, K, mol, rad
  double factor = 1.0;          ///< times 10^decade of them
  int decade = 0;

  double size() const;
  bool measuresAs(const Unit& other) const { return powers == other.powers; }
};

/// The unit that a text such as "GPa", "kJ/m^2", "mol/(m2 s)" or "1/s" names: products and quotients of units with
/// whole powers ("m2", "m^2"), with prefixes from f to T. Nothing where it names none; `unknown`, if given, is then set
/// to the part that is no unit, or to "" where all are and the form is wrong.
std::optional<Unit> parseUnit(const std::string& text, std::string* unknown = nullptr);

/// ` (did you mean "GPa"?)` or empty.
std::string didYouMeanUnit(const std::string& word);

}  // namespace pd

#endif
