#include "check_study.hpp"

#include <algorithm>
#include <set>
#include <sstream>

#include "../deck/deck_data.hpp"
#include "../deck/deck_parameters.hpp"
#include "../deck/sections.hpp"
#include "../model/run_setup.hpp"
#include "deck_of_run.hpp"

namespace pd {

namespace {

class StudyCheck {
 public:
  StudyCheck(Study& study, const Communicator& comm, bool withMeshes, Mistakes& mistakes)
      : study_(study), comm_(comm), withMeshes_(withMeshes), mistakes_(mistakes) {}

  void run() {
    if (study_.deckFile.empty()) return;  // which is a mistake by itself
    for (StudyRun& run : study_.runs) {
      try {
        const Deck deck = Deck::read(study_.deckFile, textsOf(run.overrides));
        check(deck);
        for (auto& [path, value] : run.swept) value = understood(deck, path, value);
      } catch (const DeckError& error) {
        for (const std::string& line : placedLines(error, run.overrides)) add(line, run);
      }
    }
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
    requireOutput(deck);
    deck.mistakes().report();
    if (!study_.histories.empty()) histories(deck);
    deck.mistakes().report();
    if (withMeshes_ && readMeshes_.insert(textOfMesh(deck)).second) rehearse(deck, comm_);
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
    requireHistories(deck);
    const auto known = historiesOf(deck, comm_);
    for (StudyHistory& history : study_.histories) {
      history.columns.clear();
      for (const auto& [label, columns] : known) {
        if (label == history.name) history.columns = columns;
        if (std::find(columns.begin(), columns.end(), history.name) != columns.end()) history.columns = {history.name};
      }
      if (history.columns.empty())
        deck.mistakes().add(history.place, "Histories: " + missingHistory(history.name, known));
    }
  }

  Study& study_;
  const Communicator& comm_;
  const bool withMeshes_;
  Mistakes& mistakes_;
  std::set<std::string> said_, readMeshes_;
};

}  // namespace

void checkStudy(Study& study, const Communicator& comm, bool withMeshes, Mistakes& mistakes) {
  StudyCheck(study, comm, withMeshes, mistakes).run();
}

}  // namespace pd
