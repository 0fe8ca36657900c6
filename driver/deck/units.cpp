#include "units.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

#include "../../materials/registry/parameters.hpp"

namespace pd {

namespace {

constexpr double pi = 3.14159265358979323846;

struct NamedUnit {
  Unit unit;
  bool takesPrefixes;
};

/// Factors: International System of Units, 9th edition (2019), tables 4 and 8; pound-force and inch as in NIST SP 811.
const std::map<std::string, NamedUnit>& namedUnits() {
  static const std::map<std::string, NamedUnit> units{{"m", {{{1, 0, 0, 0, 0, 0, 0}}, true}},
                                                      {"g", {{{0, 1, 0, 0, 0, 0, 0}, 1.0, -3}, true}},
                                                      {"s", {{{0, 0, 1, 0, 0, 0, 0}}, true}},
                                                      {"A", {{{0, 0, 0, 1, 0, 0, 0}}, true}},
                                                      {"K", {{{0, 0, 0, 0, 1, 0, 0}}, true}},
                                                      {"mol", {{{0, 0, 0, 0, 0, 1, 0}}, true}},
                                                      {"rad", {{{0, 0, 0, 0, 0, 0, 1}}, true}},
                                                      {"Hz", {{{0, 0, -1, 0, 0, 0, 0}}, true}},
                                                      {"N", {{{1, 1, -2, 0, 0, 0, 0}}, true}},
                                                      {"Pa", {{{-1, 1, -2, 0, 0, 0, 0}}, true}},
                                                      {"J", {{{2, 1, -2, 0, 0, 0, 0}}, true}},
                                                      {"W", {{{2, 1, -3, 0, 0, 0, 0}}, true}},
                                                      {"C", {{{0, 0, 1, 1, 0, 0, 0}}, true}},
                                                      {"V", {{{2, 1, -3, -1, 0, 0, 0}}, true}},
                                                      {"L", {{{3, 0, 0, 0, 0, 0, 0}, 1.0, -3}, true}},
                                                      {"l", {{{3, 0, 0, 0, 0, 0, 0}, 1.0, -3}, true}},
                                                      {"bar", {{{-1, 1, -2, 0, 0, 0, 0}, 1.0, 5}, true}},
                                                      {"min", {{{0, 0, 1, 0, 0, 0, 0}, 60.0}, false}},
                                                      {"h", {{{0, 0, 1, 0, 0, 0, 0}, 3600.0}, false}},
                                                      {"d", {{{0, 0, 1, 0, 0, 0, 0}, 86400.0}, false}},
                                                      {"degrees", {{{0, 0, 0, 0, 0, 0, 1}, pi / 180.0}, false}},
                                                      {"degree", {{{0, 0, 0, 0, 0, 0, 1}, pi / 180.0}, false}},
                                                      {"deg", {{{0, 0, 0, 0, 0, 0, 1}, pi / 180.0}, false}},
                                                      {"in", {{{1, 0, 0, 0, 0, 0, 0}, 0.0254}, false}},
                                                      {"psi", {{{-1, 1, -2, 0, 0, 0, 0}, 6894.757293168361}, false}},
                                                      {"ksi", {{{-1, 1, -2, 0, 0, 0, 0}, 6894757.293168361}, false}}};
  return units;
}

const std::vector<std::pair<std::string, int>>& prefixes() {
  static const std::vector<std::pair<std::string, int>> decades{
      {"f", -15}, {"p", -12}, {"n", -9}, {"u", -6}, {"\u00b5", -6}, {"\u03bc", -6}, {"m", -3},
      {"c", -2},  {"d", -1},  {"h", 2},  {"k", 3},  {"M", 6},       {"G", 9},       {"T", 12}};
  return decades;
}

std::optional<Unit> unitCalled(const std::string& name) {
  const auto& units = namedUnits();
  if (const auto found = units.find(name); found != units.end()) return found->second.unit;
  for (const auto& [prefix, decade] : prefixes()) {
    if (name.compare(0, prefix.size(), prefix) != 0) continue;
    const auto found = units.find(name.substr(prefix.size()));
    if (found == units.end() || !found->second.takesPrefixes) continue;
    Unit unit = found->second.unit;
    unit.decade += decade;
    return unit;
  }
  return std::nullopt;
}

constexpr int deepestNesting = 5;

/// Reads factors by recursive descent: factor, {blank or * or / factor}.
class UnitReader {
 public:
  explicit UnitReader(const std::string& text) : text_(text) {}

  std::optional<Unit> read() {
    std::optional<Unit> unit = product(0);
    return at_ == text_.size() ? unit : std::nullopt;
  }
  const std::string& unknown() const { return unknown_; }

 private:
  static bool isLetter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0 || (c & 0x80) != 0; }
  static bool isDigit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

  char next() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }

  std::optional<Unit> product(int depth) {
    std::optional<Unit> result = factor(depth);
    while (result && next() != '\0' && next() != ')') {
      const bool divides = accept('/');
      if (!divides) accept('*');
      const std::optional<Unit> other = factor(depth);
      if (!other) return std::nullopt;
      multiply(*result, *other, divides ? -1 : 1);
    }
    return result;
  }

  std::optional<Unit> factor(int depth) {
    if (depth > deepestNesting) return std::nullopt;
    if (accept('(')) {
      const std::optional<Unit> inner = product(depth + 1);
      return accept(')') ? inner : std::nullopt;
    }
    if (accept('1')) return Unit();
    next();
    const std::size_t start = at_;
    while (at_ < text_.size() && isLetter(text_[at_])) ++at_;
    const std::string name = text_.substr(start, at_ - start);
    const std::optional<Unit> unit = unitCalled(name);
    if (!unit) unknown_ = name;
    const std::optional<int> exponent = power();
    if (!unit || !exponent) return std::nullopt;
    Unit result;
    multiply(result, *unit, *exponent);
    return result;
  }

  /// Of "m2", "m^2", "m-3"; 1 where there is none.
  std::optional<int> power() {
    const bool hasCaret = at_ < text_.size() && text_[at_] == '^';
    if (hasCaret) ++at_;
    const bool isNegative = at_ < text_.size() && text_[at_] == '-';
    if (isNegative) ++at_;
    if (at_ == text_.size() || !isDigit(text_[at_])) return hasCaret || isNegative ? std::nullopt : std::optional(1);
    const int digit = text_[at_++] - '0';
    if (at_ < text_.size() && isDigit(text_[at_])) return std::nullopt;
    return isNegative ? -digit : digit;
  }

  static void multiply(Unit& unit, const Unit& other, int exponent) {
    for (std::size_t i = 0; i < unit.powers.size(); ++i) unit.powers[i] += exponent * other.powers[i];
    unit.factor *= std::pow(other.factor, exponent);
    unit.decade += exponent * other.decade;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  std::string unknown_;
};

std::string replaced(std::string text, const std::string& sign, const std::string& by) {
  for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at))
    text.replace(at, sign.size(), by);
  return text;
}

}  // namespace

double Unit::size() const { return factor * std::pow(10.0, decade); }

std::optional<Unit> parseUnit(const std::string& text, std::string* unknown) {
  constexpr std::size_t longestUnit = 60;
  if (text.empty() || text.size() > longestUnit) {
    if (unknown != nullptr) *unknown = text;
    return std::nullopt;
  }
  const std::string plain = replaced(replaced(replaced(text, "\u00b2", "2"), "\u00b3", "3"), "\u00b7", "*");
  UnitReader reader(plain);
  std::optional<Unit> unit = reader.read();
  if (!unit && unknown != nullptr) *unknown = reader.unknown();
  return unit;
}

std::string didYouMeanUnit(const std::string& word) {
  std::vector<std::string> known;
  for (const auto& [name, named] : namedUnits()) {
    known.push_back(name);
    for (const char* prefix : {"G", "M", "k", "m", "u", "n", "c"})
      if (named.takesPrefixes) known.push_back(prefix + name);
  }
  return didYouMean(word, known);
}

}  // namespace pd
