#include "check_study.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "../deck/deck_data.hpp"
#include "../deck/deck_parameters.hpp"
#include "../deck/sections.hpp"
#include "../model/run_setup.hpp"
#include "../output/compute_set.hpp"
#include "../output/history.hpp"
#include "../output/output_section.hpp"
#include "Peridigm_Field.hpp"

namespace pd {

namespace {

using PeridigmNS::FieldManager;
namespace Field = PeridigmNS::PeridigmField;

std::vector<std::string> textsOf(const std::vector<StudyOverride>& overrides) {
  std::vector<std::string> texts;
  for (const StudyOverride& item : overrides) texts.push_back(item.text());
  return texts;
}

/// `line` with the place in the study in place of the override that the deck's reader names.
std::string placedInStudy(const std::string& line, const std::vector<StudyOverride>& overrides) {
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

/// A field for the whole body with its columns of the CSV file.
struct WrittenHistory {
  std::string label;
  std::vector<std::string> columns;
};

/// What a run of the deck writes into the CSV file of its first section: what that names, and of the computes what no
/// other section names.
std::vector<WrittenHistory> historiesOf(const Deck& deck, const Communicator& comm) {
  const ComputeSet computes(deck, comm);  // first: it makes their fields known
  const std::vector<OutputSection> sections = readOutputSections(deck);
  std::vector<std::string> labels;
  for (const OutputVariable& variable : sections.front().variables)
    if (FieldManager::self().hasField(variable.label) &&
        FieldManager::self().getFieldSpec(variable.label).relation == Field::GLOBAL)
      labels.push_back(variable.label);
  for (const std::string& label : computes.globalLabels())
    if (std::none_of(sections.begin(), sections.end(),
                     [&](const OutputSection& section) { return lists(section, label); }))
      labels.push_back(label);
  std::vector<WrittenHistory> histories;
  for (const std::string& label : labels)
    histories.push_back(
        {label, columnNames(label, Field::variableDimension(FieldManager::self().getFieldSpec(label).length))});
  return histories;
}

class StudyCheck {
 public:
  StudyCheck(Study& study, const Communicator& comm, bool withMeshes)
      : study_(study), comm_(comm), withMeshes_(withMeshes) {}

  void run() {
    for (StudyRun& run : study_.runs) {
      try {
        const Deck deck = Deck::read(study_.deckFile, textsOf(run.overrides));
        check(deck);
        for (auto& [path, value] : run.swept) value = understood(deck, path, value);
      } catch (const DeckError& error) {
        std::istringstream lines(error.what());
        for (std::string line; std::getline(lines, line);) add(placedInStudy(line, run.overrides), run);
      }
    }
    mistakes_.report();
  }

 private:
  /// A swept value as table and picture have it: "3 GPa" is a number in the unit of its key.
  static std::string understood(const Deck& deck, const std::string& path, const std::string& value) {
    DeckNode node = deck.root();
    std::istringstream parts(path);
    for (std::string part; std::getline(parts, part, '/');)
      if (part != "Peridigm") node = node[part];
    return node.isScalar() && parseReal(node.text()) && !parseReal(value) ? node.text() : value;
  }

  void add(const std::string& line, const StudyRun& run) {
    if (said_.insert(line).second) mistakes_.add("", line + "\n  (" + run.place + ": series \"" + run.label + "\")");
  }

  void check(const Deck& deck) {
    checkDeck(deck);
    if (!study_.errorNorm.empty()) errorNorm(deck);
    if (firstOutput(deck) != "Output")
      deck.mistakes().add(study_.deckFile,
                          "the first section for output must be called Output: a study gives it the name of each run");
    deck.mistakes().report();
    if (!study_.histories.empty()) histories(deck);
    deck.mistakes().report();
    if (withMeshes_ && readMeshes_.insert(textOfMesh(deck)).second) rehearse(deck, comm_);
  }

  static std::string firstOutput(const Deck& deck) {
    for (const auto& entry : deck.root().entries())
      if (isSectionOf(deck, entry.first, "Output")) return entry.first;
    return "";
  }

  void errorNorm(const Deck& deck) {
    const DeckNode section = deck["Exact Solution"];
    if (!section) {
      deck.mistakes().add(study_.errorPlace,
                          "Error: the deck has no section Exact Solution, so a study of it finds no error; add one, or "
                          "ask for Histories");
      return;
    }
    std::vector<std::string> names;
    for (const auto& entry : section.entries()) names.push_back(entry.first);
    for (const DeckNode& item : section.items())
      if (item["Field"].isScalar())
        names.push_back(item["Field"].text() +
                        (item["Coordinate"].isScalar() ? " " + item["Coordinate"].text() : std::string()));
    std::vector<std::string> norms;
    std::size_t nFound = 0;
    for (const std::string& name : names)
      for (const char* norm : {" L2 error", " maximum error"}) {
        // Errors are absolute where the exact values are zero, which only the run finds out.
        const std::string relative = name + " relative" + norm, absolute = name + " absolute" + norm;
        norms.push_back(relative);
        const auto isPartOf = [&](const std::string& text) { return text.find(study_.errorNorm) != std::string::npos; };
        if (isPartOf(relative) || isPartOf(absolute)) ++nFound;
      }
    if (nFound != 1)
      deck.mistakes().add(study_.errorPlace, "Error: \"" + study_.errorNorm +
                                                 "\" must be part of exactly one error norm; the deck has " +
                                                 quotedList(norms));
  }

  void histories(const Deck& deck) {
    const OutputSection output = readOutputSections(deck).front();
    if (output.historyFrequency <= 0)
      deck.mistakes().add(deck["Output"]["History Frequency"].place(),
                          "Output/History Frequency: the study asks for histories, which the deck does not write; give "
                          "1 or more increments");
    const auto known = historiesOf(deck, comm_);
    for (StudyHistory& history : study_.histories) {
      std::vector<std::string> names;
      history.columns.clear();
      for (const auto& [label, columns] : known) {
        names.push_back(label);
        if (label == history.name) history.columns = columns;
        if (std::find(columns.begin(), columns.end(), history.name) != columns.end()) history.columns = {history.name};
      }
      if (history.columns.empty())
        deck.mistakes().add(history.place,
                            "Histories: no run writes \"" + history.name + "\"" + didYouMean(history.name, names) +
                                (names.empty() ? "; the deck has no computes for the whole body; add them to Compute "
                                                 "Class Parameters"
                                               : "; there are: " + quotedList(names)));
    }
  }

  /// Of all that a discretization may depend on: runs that agree in it have one mesh.
  static std::string textOfMesh(const Deck& deck) {
    std::string text;
    for (const auto& [key, node] : deck.root().entries())
      if (!isSectionOf(deck, key, "Solver") && !isSectionOf(deck, key, "Output")) text += textOf(key, node);
    return text;
  }

  static std::string textOf(const std::string& key, const DeckNode& node) {
    std::string text = key + ":";
    if (node.isScalar()) text += node.text();
    for (const auto& [name, entry] : node.entries()) text += "{" + textOf(name, entry) + "}";
    for (const DeckNode& item : node.items()) text += "[" + textOf("", item) + "]";
    return text;
  }

  Study& study_;
  const Communicator& comm_;
  const bool withMeshes_;
  Mistakes mistakes_;
  std::set<std::string> said_, readMeshes_;
};

}  // namespace

void checkStudy(Study& study, const Communicator& comm, bool withMeshes) { StudyCheck(study, comm, withMeshes).run(); }

}  // namespace pd
