#include "fit_override.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../deck/deck_data.hpp"
#include "override_values.hpp"

namespace pd {

namespace {

using Piece = FitOverride::Piece;

/// Divides a text at what stands in braces.
class FitTextReader {
 public:
  FitTextReader(const FitNames& names, FitOverride& result) : names_(names), result_(result) {}

  /// Names in braces that nothing has are left as they are, and told.
  std::vector<std::string> read(const std::string& text) {
    std::vector<std::string> unknown;
    std::size_t begin = 0;
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', open + 1)) {
      const std::size_t close = text.find_first_of("{}", open + 1);
      if (close == std::string::npos || text[close] == '{') continue;
      const std::string name = text.substr(open + 1, close - open - 1);
      const auto value = std::find(names_.values.begin(), names_.values.end(), name);
      const auto column = names_.columns.find(name);
      if (value == names_.values.end() && column == names_.columns.end()) {
        unknown.push_back(name);
        continue;
      }
      add(text.substr(begin, open - begin));
      if (column != names_.columns.end()) {
        add(column->second);
        result_.hasColumns = true;
      } else {
        result_.pieces.push_back({"", static_cast<int>(value - names_.values.begin()), false});
      }
      begin = close + 1;
    }
    add(text.substr(begin));
    return unknown;
  }

 private:
  void add(const std::string& text) {
    if (text.empty()) return;
    if (!result_.pieces.empty() && result_.pieces.back().value < 0)
      result_.pieces.back().text += text;
    else
      result_.pieces.push_back({text, -1, false});
  }

  const FitNames& names_;
  FitOverride& result_;
};

/// Name in braces that YAML took for a section with one key and no value: {Current}.
bool isBareName(const DeckNode& node) {
  return node.isMap() && node.entries().size() == 1 && isMissing(node.entries().front().second);
}

std::string textOfNumber(double value) {
  const std::string text = realText(value);
  return value < 0.0 ? "(" + text + ")" : text;
}

}  // namespace

FitOverride readFitOverride(const std::string& path, const DeckNode& node, const FitNames& names, Mistakes& mistakes) {
  FitOverride result;
  result.path = path;
  result.place = node.place();
  if (isBareName(node)) {
    mistakes.add(result.place,
                 node.path() + ": write names in braces in quotes: \"{" + node.entries().front().first + "}\"");
    return result;
  }
  std::string text = flowYaml(node);
  // Braces alone: a number as it is, for which quotes would make a text.
  if (node.isScalar() && node.text().size() > 2 && node.text().front() == '{' &&
      node.text().find('}') == node.text().size() - 1)
    text = node.text();
  const std::vector<std::string> unknown = FitTextReader(names, result).read(text);
  std::vector<std::string> known = names.values;
  for (const auto& column : names.columns) known.push_back(column.first);
  if (node.isScalar())  // braces of sections and lists are YAML's
    for (const std::string& name : unknown)
      mistakes.add(result.place, node.path() + ": nothing is called \"" + name + "\"" + didYouMean(name, known) +
                                     (known.empty() ? "" : "; there are: " + quotedList(known)));
  if (result.pieces.size() == 1 && result.pieces.front().value >= 0) result.pieces.front().isWhole = true;
  return result;
}

StudyOverride FitOverride::with(const std::vector<FitValue>& fitted, const std::vector<double>& values) const {
  std::string text;
  for (const Piece& piece : pieces) {
    const auto i = static_cast<std::size_t>(piece.value);
    if (piece.value < 0)
      text += piece.text;
    else if (piece.isWhole)
      text += realText(values[i]) + (fitted[i].unit.empty() ? "" : " " + fitted[i].unit);
    else
      text += textOfNumber(values[i] * fitted[i].factor);
  }
  return {path, text, place};
}

std::vector<StudyOverride> overridesWith(const std::vector<FitOverride>& overrides, const std::vector<FitValue>& fitted,
                                         const std::vector<double>& values) {
  std::vector<StudyOverride> result;
  for (const FitOverride& item : overrides) result.push_back(item.with(fitted, values));
  return result;
}

double FitValue::scale() const {
  if (isLogarithmic) return 1.0;
  return start != 0.0 ? std::abs(start) : highest - lowest;
}

std::vector<double> Fit::start() const {
  std::vector<double> values;
  for (const FitValue& value : this->values) values.push_back(value.start);
  return values;
}

}  // namespace pd
