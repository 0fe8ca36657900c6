#include "deck_of_run.hpp"

#include <algorithm>
#include <sstream>

#include "../deck/sections.hpp"
#include "../output/compute_set.hpp"
#include "../output/history.hpp"
#include "../output/output_section.hpp"
#include "Peridigm_Field.hpp"

namespace pd {

using PeridigmNS::FieldManager;
namespace GlobalField = PeridigmNS::PeridigmField;

namespace {

std::string placed(const std::string& line, const std::vector<StudyOverride>& overrides) {
  for (const StudyOverride& item : overrides) {
    const std::string source = "--set \"" + item.text() + "\"";
    if (!item.place.empty() && line.compare(0, source.size(), source) == 0)
      return item.place + line.substr(source.size());
  }
  return line;
}

bool lists(const OutputSection& section, const std::string& label) {
  return std::any_of(section.variables.begin(), section.variables.end(),
                     [&](const OutputVariable& variable) { return variable.label == label; });
}

std::string textOfNode(const std::string& key, const DeckNode& node) {
  std::string text = key + ":";
  if (node.isScalar()) text += node.text();
  for (const auto& [name, entry] : node.entries()) text += "{" + textOfNode(name, entry) + "}";
  for (const DeckNode& item : node.items()) text += "[" + textOfNode("", item) + "]";
  return text;
}

}  // namespace

std::vector<std::string> textsOf(const std::vector<StudyOverride>& overrides) {
  std::vector<std::string> texts;
  for (const StudyOverride& item : overrides) texts.push_back(item.text());
  return texts;
}

std::vector<std::string> placedLines(const DeckError& error, const std::vector<StudyOverride>& overrides) {
  std::vector<std::string> result;
  std::istringstream lines(error.what());
  for (std::string line; std::getline(lines, line);) result.push_back(placed(line, overrides));
  return result;
}

void requireOutput(const Deck& deck) {
  for (const auto& entry : deck.root().entries()) {
    if (!isSectionOf(deck, entry.first, "Output")) continue;
    if (entry.first == "Output") return;
    break;
  }
  deck.mistakes().add(deck.fileName(),
                      "the first section for output must be called Output: it is given the name of each run");
}

void requireHistories(const Deck& deck) {
  if (readOutputSections(deck).front().historyFrequency <= 0)
    deck.mistakes().add(deck["Output"]["History Frequency"].place(),
                        "Output/History Frequency: histories are asked for, which the deck does not write; give 1 or "
                        "more increments");
}

std::vector<WrittenHistory> historiesOf(const Deck& deck, const Communicator& comm) {
  const ComputeSet computes(deck, comm);  // first: it makes their fields known
  const std::vector<OutputSection> sections = readOutputSections(deck);
  std::vector<std::string> labels;
  for (const OutputVariable& variable : sections.front().variables)
    if (FieldManager::self().hasField(variable.label) &&
        FieldManager::self().getFieldSpec(variable.label).relation == GlobalField::GLOBAL)
      labels.push_back(variable.label);
  for (const std::string& label : computes.globalLabels())
    if (std::none_of(sections.begin(), sections.end(),
                     [&](const OutputSection& section) { return lists(section, label); }))
      labels.push_back(label);
  std::vector<WrittenHistory> histories;
  for (const std::string& label : labels)
    histories.push_back(
        {label, columnNames(label, GlobalField::variableDimension(FieldManager::self().getFieldSpec(label).length))});
  return histories;
}

std::string missingHistory(const std::string& name, const std::vector<WrittenHistory>& known) {
  std::vector<std::string> names;
  for (const WrittenHistory& history : known) names.push_back(history.label);
  return "no run writes \"" + name + "\"" + didYouMean(name, names) +
         (names.empty() ? "; the deck has no computes for the whole body; add them to Compute Class Parameters"
                        : "; there are: " + quotedList(names));
}

std::string textOfMesh(const Deck& deck) {
  std::string text;
  for (const auto& [key, node] : deck.root().entries())
    if (!isSectionOf(deck, key, "Solver") && !isSectionOf(deck, key, "Output")) text += textOfNode(key, node);
  return text;
}

}  // namespace pd
