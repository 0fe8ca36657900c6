#include "output_section.hpp"

#include <cmath>
#include <filesystem>
#include <limits>

#include "../deck/sections.hpp"
#include "result_files.hpp"

namespace pd {

namespace {

bool isMultiple(int step, int frequency) { return frequency > 0 && step % frequency == 0; }

/// The items of a list; one value stands for a list of one.
std::vector<DeckNode> itemsOrSelf(const DeckNode& node) {
  if (node.isSequence()) return node.items();
  return node ? std::vector<DeckNode>{node} : std::vector<DeckNode>{};
}

/// A list of labels, or Peridigm's map {label: true}.
std::vector<OutputVariable> readVariables(const DeckNode& node) {
  std::vector<OutputVariable> variables;
  if (node.isMap()) {
    for (const auto& [label, isWanted] : node.entries())
      if (isWanted.flag()) variables.push_back({label, isWanted.keyPlace()});
  } else {
    for (const DeckNode& item : itemsOrSelf(node)) variables.push_back({item.text(), item.place()});
  }
  return variables;
}

OutputSection readSection(const DeckNode& node, bool isPeridigmDeck, const std::string& folder) {
  OutputSection section;
  section.fileName = resultPath(folder, node.text("Output Filename", "dump"));
  section.place = node["Output Filename"] ? node["Output Filename"].place() : node.keyPlace();
  section.frequency = node.integer("Output Frequency", -1);
  for (const DeckNode& step : itemsOrSelf(node["Output Steps"]))
    section.steps.insert(static_cast<int>(std::lround(step.real())));
  section.firstStep =
      isPeridigmDeck ? node.integer("Initial Output Step", 1) - 1 : node.integer("Initial Output Step", 0);
  section.lastStep = node.integer("Final Output Step", std::numeric_limits<int>::max());
  section.historyFrequency = node.integer("History Frequency", isPeridigmDeck ? section.frequency : 1);
  section.countsStarts = isPeridigmDeck;
  section.checkpointFrequency = node.integer("Checkpoint Frequency", -1);
  section.variables = readVariables(node["Output Variables"]);
  return section;
}

}  // namespace

bool OutputSection::isInRange(int step) const { return step >= firstStep && step <= lastStep; }

bool OutputSection::areFieldsDue(int step, bool isLast) const {
  if (!writesFields() || !isInRange(step + nStarts)) return false;
  return isLast || isMultiple(step + nStarts, frequency) || steps.count(step) != 0;
}

bool OutputSection::isHistoryDue(int step, bool isLast) const {
  if (historyFrequency <= 0 || !isInRange(step + nStarts)) return false;
  return isLast || isMultiple(step + nStarts, historyFrequency);
}

bool OutputSection::isCheckpointDue(int step, bool isLast) const {
  return checkpointFrequency > 0 && step > 0 && isInRange(step + nStarts) &&
         (isLast || isMultiple(step, checkpointFrequency));
}

std::vector<OutputSection> readOutputSections(const Deck& deck, const std::string& folder) {
  std::vector<OutputSection> sections;
  for (const auto& [key, node] : deck.root().entries())
    if (isSectionOf(deck, key, "Output")) sections.push_back(readSection(node, deck.isPeridigmDeck(), folder));
  return sections;
}

std::string mainOutputName(const Deck& deck, const std::vector<OutputSection>& sections, const std::string& folder) {
  if (!sections.empty()) return sections.front().fileName;
  return resultPath(folder, std::filesystem::path(deck.fileName()).stem().string());
}

}  // namespace pd
