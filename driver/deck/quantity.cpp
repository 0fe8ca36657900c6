#include "quantity.hpp"

#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "deck_data.hpp"
#include "units.hpp"

namespace pd {

namespace {

struct Parts {
  std::string number, unit;
};

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Where the number ends and the unit begins: at the first name that is neither pi nor a function. Nothing where a
/// character belongs to neither.
std::optional<std::size_t> endOfNumber(const std::string& text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    if (std::isdigit(c) != 0 || c == '.') {
      double value = 0.0;
      const char* const start = text.data() + i;
      const char* const end = std::from_chars(start, text.data() + text.size(), value).ptr;
      if (end == start) return std::nullopt;
      i += static_cast<std::size_t>(end - start);
    } else if (std::isalpha(c) != 0 || c >= 0x80) {
      std::size_t end = i;
      while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end])) != 0) ++end;
      const bool isFunction =
          text.find_first_not_of(' ', end) != std::string::npos && text[text.find_first_not_of(' ', end)] == '(';
      if (!isFunction && text.compare(i, end - i, "pi") != 0) return depth == 0 ? std::optional(i) : std::nullopt;
      i = end;
    } else if (std::string("+-*/^() ,").find(static_cast<char>(c)) != std::string::npos) {
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      ++i;
    } else {
      return std::nullopt;
    }
  }
  return text.size();
}

std::optional<Parts> split(const std::string& text) {
  constexpr std::size_t longestNumber = 1000;
  if (text.size() > longestNumber) return std::nullopt;
  const std::optional<std::size_t> end = endOfNumber(text);
  if (!end) return std::nullopt;
  Parts parts{trimmed(text.substr(0, *end)), trimmed(text.substr(*end))};
  // "5 /s", "5 1/s": the unit has no numerator.
  if (!parts.unit.empty() && !parts.number.empty() && parts.number.back() == '/') {
    parts.number = trimmed(parts.number.substr(0, parts.number.size() - 1));
    parts.unit = "1/" + parts.unit;
    const std::size_t size = parts.number.size();
    if (size > 2 && parts.number.compare(size - 2, 2, " 1") == 0)
      parts.number = trimmed(parts.number.substr(0, size - 2));
  }
  const bool endsWithValue =
      !parts.number.empty() && (std::isalnum(static_cast<unsigned char>(parts.number.back())) != 0 ||
                                parts.number.back() == '.' || parts.number.back() == ')');
  if (!endsWithValue) return std::nullopt;
  return parts;
}

/// `number` times 10^decade, to the last bit. Nothing for what is no decimal number.
std::optional<double> shifted(const std::string& number, int decade) {
  if (!parseReal(number)) return std::nullopt;
  const std::size_t e = number.find_first_of("eE");
  const std::string exponent = e == std::string::npos ? "0" : number.substr(e + 1);
  const std::optional<int> given = parseInteger(exponent);
  return given ? parseReal(number.substr(0, e) + "e" + std::to_string(static_cast<long>(*given) + decade))
               : std::nullopt;
}

std::string unitComplaint(const std::string& text, const std::string& wanted) {
  std::string unknown;
  const std::optional<Unit> unit = parseUnit(text, &unknown);
  if (wanted.empty() || wanted == "1") return "it takes a number without a unit";
  const std::optional<Unit> target = parseUnit(wanted);
  if (!target) return "it takes no unit, since its own (" + wanted + ") depends on the rest of the deck";
  if (unknown == "\u00b0C" || unknown == "degC")
    return "degrees Celsius start elsewhere than " + wanted + "; write " + wanted;
  for (const char* const variable : {"x", "y", "z", "t", "C", "pH"})
    if (unknown == variable) return "a function has no units, its values are SI: 1.0e-3*t, not 1 mm*t";
  if (!unknown.empty())
    return "there is no unit \"" + unknown + "\"" + didYouMeanUnit(unknown) + "; it is in " + wanted;
  if (!unit) return "\"" + text + "\" is no unit; it is in " + wanted;
  return unit->measuresAs(*target) ? "" : text + " does not convert to " + wanted;
}

double evaluated(const std::string& number, MinusSign minusSign) {
  return FunctionProgram(number, {}, minusSign).evaluate(nullptr);
}

}  // namespace

bool hasUnit(const std::string& text) {
  const std::optional<Parts> parts = split(text);
  return parts && !parts->unit.empty();
}

std::optional<double> readQuantity(const std::string& text, const std::string& unit, MinusSign minusSign,
                                   std::string& complaint) {
  complaint.clear();
  const std::optional<Parts> parts = split(text);
  if (!parts) return std::nullopt;
  std::optional<double> value;
  try {
    value = evaluated(parts->number, minusSign);
    if (!parts->unit.empty()) {
      complaint = unitComplaint(parts->unit, unit);
      if (!complaint.empty()) return std::nullopt;
      const Unit given = *parseUnit(parts->unit), wanted = *parseUnit(unit);
      const std::optional<double> exact =
          given.factor == wanted.factor ? shifted(parts->number, given.decade - wanted.decade) : std::nullopt;
      value = exact ? *exact : *value * (given.size() / wanted.size());
    }
  } catch (const std::invalid_argument& error) {
    complaint = error.what();
    return std::nullopt;
  }
  if (std::isfinite(*value)) return value;
  complaint = "its value is not finite";
  return std::nullopt;
}

}  // namespace pd
