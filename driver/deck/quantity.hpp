// Numbers as people write them: "3 GPa", "1 h", "2*3600". Private to this folder.
#ifndef PD_QUANTITY_HPP
#define PD_QUANTITY_HPP

#include <optional>
#include <string>

#include "function_program.hpp"

namespace pd {

/// Whether the text is a number and what may be a unit, as in "3 GPa" and "3 x".
bool hasUnit(const std::string& text);

/// The number in `unit` that the text stands for: an expression of numbers, and after it a unit or none. A decimal
/// number with a decimal unit becomes the same double as if it were written out: "0.3 mm" is 0.0003. `unit`: as
/// declared; "1" of pure numbers, which take no unit. Nothing where the text is no such number; `complaint` is then set
/// to what is wrong with one that looks like it (`there is no unit "Gpa"`), or to "".
std::optional<double> readQuantity(const std::string& text, const std::string& unit, MinusSign minusSign,
                                   std::string& complaint);

}  // namespace pd

#endif
