#include "study_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pd {

namespace {

constexpr std::size_t numberWidth = 12;

/// A field of a CSV file, as in RFC 4180.
std::string csvText(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

/// What names a deck path well enough: its last two parts.
std::string shortName(const std::string& path) {
  const std::size_t last = path.find_last_of('/');
  if (last == std::string::npos || last == 0) return path;
  const std::size_t before = path.find_last_of('/', last - 1);
  return before == std::string::npos ? path : path.substr(before + 1);
}

std::string cell(const std::string& text, const std::string& heading) {
  return fmt::format("  {:>{}}", text, std::max(numberWidth, heading.size()));
}

/// As YAML it may be quoted.
std::string bare(const std::string& value) {
  const bool isQuoted = value.size() > 1 && value.front() == '"' && value.back() == '"';
  return isQuoted ? value.substr(1, value.size() - 2) : value;
}

std::string csvNumber(double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : ""; }

std::string joined(const std::vector<StudyOverride>& overrides) {
  std::string text;
  for (const StudyOverride& item : overrides) text += (text.empty() ? "" : "; ") + item.text();
  return text;
}

}  // namespace

StudyTable::StudyTable(const Study& study) : study_(study) {
  labelWidth_ = std::string("series").size();
  for (const StudyRun& run : study.runs) {
    labelWidth_ = std::max(labelWidth_, run.label.size());
    for (const auto& [path, value] : run.swept)
      if (std::find(sweptPaths_.begin(), sweptPaths_.end(), path) == sweptPaths_.end()) sweptPaths_.push_back(path);
  }
  for (const std::string& path : sweptPaths_) sweptWidths_.push_back(shortName(path).size());
  for (const StudyRun& run : study.runs) {
    const std::vector<std::string> values = sweptValues(run);
    for (std::size_t i = 0; i < values.size(); ++i) sweptWidths_[i] = std::max(sweptWidths_[i], values[i].size());
  }
  for (const StudyHistory& history : study.histories)
    for (const std::string& column : history.columns)
      for (const HistoryValue::Kind kind : study.historyValues)
        valueNames_.push_back(HistoryValue::names()[kind] + " " + column);
}

std::vector<std::string> StudyTable::sweptValues(const StudyRun& run) const {
  std::vector<std::string> values(sweptPaths_.size());
  for (const auto& [path, value] : run.swept) {
    const auto at = std::find(sweptPaths_.begin(), sweptPaths_.end(), path) - sweptPaths_.begin();
    values[static_cast<std::size_t>(at)] = bare(value);
  }
  return values;
}

std::string StudyTable::heading() const {
  std::string line = fmt::format("{:<{}}", "series", labelWidth_);
  for (std::size_t i = 0; i < sweptPaths_.size(); ++i)
    line += fmt::format("  {:>{}}", shortName(sweptPaths_[i]), sweptWidths_[i]);
  if (!study_.errorNorm.empty()) line += cell("error", "error");
  for (const std::string& name : valueNames_) line += cell(name, name);
  return line + cell("seconds", "") + cell("bond-updates", "");
}

std::string StudyTable::row(const StudyRun& run, const StudyResult* result) const {
  std::string line = fmt::format("{:<{}}", run.label, labelWidth_);
  const std::vector<std::string> values = sweptValues(run);
  for (std::size_t i = 0; i < values.size(); ++i) line += fmt::format("  {:>{}}", values[i], sweptWidths_[i]);
  if (result == nullptr) return line + cell("failed", "");
  if (!study_.errorNorm.empty()) line += cell(fmt::format("{:.4e}", result->error), "");
  for (std::size_t i = 0; i < valueNames_.size(); ++i)
    line += cell(fmt::format("{:.5g}", result->historyValues[i]), valueNames_[i]);
  return line + cell(fmt::format("{:.3f}", result->seconds), "") +
         cell(fmt::format("{:.4e}", static_cast<double>(result->bondUpdates)), "");
}

std::string StudyTable::csvHeading() const {
  std::string line = "label";
  for (const std::string& path : sweptPaths_) line += "," + csvText(path);
  line += ",overrides,results";
  if (!study_.errorNorm.empty()) line += ",error";
  line += ",seconds,bond_updates";
  for (const std::string& name : valueNames_) line += "," + csvText(name);
  return line + "\n";
}

std::string StudyTable::csvRow(const StudyRun& run, const StudyResult* result) const {
  std::string line = csvText(run.label);
  for (const std::string& value : sweptValues(run)) line += "," + csvText(value);
  line += "," + csvText(joined(run.overrides)) + "," + csvText(run.outputName);
  if (!study_.errorNorm.empty()) line += "," + (result != nullptr ? csvNumber(result->error) : "");
  line += result != nullptr ? fmt::format(",{:.6g},{}", result->seconds, result->bondUpdates) : ",,";
  for (std::size_t i = 0; i < valueNames_.size(); ++i)
    line += "," + (result != nullptr ? csvNumber(result->historyValues[i]) : "");
  return line + "\n";
}

}  // namespace pd
