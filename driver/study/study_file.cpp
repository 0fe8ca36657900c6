#include "study_file.hpp"

#include <filesystem>

#include "../deck/deck.hpp"
#include "../deck/deck_parameters.hpp"
#include "../deck/sections.hpp"

namespace pd {

namespace {

ParameterDeclarations declareStudy() {
  ParameterDeclarations declare;
  declare.text("Deck", "The deck that is run, seen from the folder of the study.").required();
  declare.text("Name", "Of the results (default: the name of the file).");
  declare.text("Reference", "What the errors are taken against.").required();
  declare.text("Error", "Part of the name of one error norm of the deck's Exact Solution.").required();
  return declare;
}

ParameterDeclarations declareSeries() {
  ParameterDeclarations declare;
  declare.text("Label", "Name of the series in table and picture.").required();
  return declare;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

/// The value on one line, in YAML.
std::string flowYaml(const DeckNode& value) {
  std::string text;
  if (value.isSequence()) {
    for (const DeckNode& item : value.items()) text += (text.empty() ? "" : ", ") + flowYaml(item);
    return "[" + text + "]";
  }
  if (value.isMap()) {
    for (const auto& [key, entry] : value.entries())
      text += (text.empty() ? "" : ", ") + quoted(key) + ": " + flowYaml(entry);
    return "{" + text + "}";
  }
  return value.isQuoted() ? quoted(value.text()) : value.text();
}

/// The overrides of each run of a series.
std::vector<std::vector<std::string>> overridesOfRuns(const DeckNode& series, Mistakes& mistakes) {
  std::vector<std::string> common;
  for (const auto& [path, value] : series["Overrides"].entries()) common.push_back(path + "=" + flowYaml(value));
  const auto sweeps = series["Sweep"].entries();
  if (sweeps.empty()) return {common};
  const std::size_t nRuns = sweeps.front().second.items().size();
  std::vector<std::vector<std::string>> runs(nRuns, common);
  for (const auto& [path, list] : sweeps) {
    const std::vector<DeckNode> values = list.items();
    if (!list.isSequence() || values.empty()) {
      mistakes.add(list.place(), list.path() + " must be a list of values, one for each run");
    } else if (nRuns > 0 && values.size() != nRuns) {
      mistakes.add(list.place(), list.path() + " has " + std::to_string(values.size()) + " values, but \"" +
                                     sweeps.front().first + "\" has " + std::to_string(nRuns) +
                                     ": lists of one Sweep go side by side");
    } else {
      for (std::size_t i = 0; i < nRuns; ++i) runs[i].push_back(path + "=" + flowYaml(values[i]));
    }
  }
  return runs;
}

void addSeries(const DeckNode& series, int number, Study& study, Mistakes& mistakes) {
  const auto list = readParameters(series, declareSeries(), mistakes, {{"Overrides", "Sweep"}, {}});
  bool isGood = series.isMap();
  for (const char* key : {"Overrides", "Sweep"}) {
    const DeckNode section = series[key];
    if (!section || section.isMap()) continue;
    mistakes.add(section.place(),
                 section.path() + " must be a section of deck paths, as in \"Solver/Final Time: 1.0\"");
    isGood = false;
  }
  if (!isGood || !list.isParameter("Label")) return;
  const auto label = list.get<std::string>("Label");
  int run = 0;
  for (std::vector<std::string>& overrides : overridesOfRuns(series, mistakes))
    study.runs.push_back({label, series.place(), std::move(overrides),
                          study.name + ".study/" + std::to_string(number) + "_" + std::to_string(++run)});
}

/// The mistakes of the decks of all runs, each said once, with the label of the first series that has it.
void checkDecks(const Study& study, Mistakes& mistakes) {
  Mistakes seen;
  for (const StudyRun& run : study.runs) {
    try {
      const Deck deck = Deck::read(study.deckFile, run.overrides);
      checkDeck(deck);
      if (!deck["Exact Solution"])
        deck.mistakes().add(study.deckFile, "the deck has no section Exact Solution, so a study finds no error");
      deck.mistakes().report();
    } catch (const DeckError& error) {
      const std::size_t nSeen = seen.lines().size();
      seen.add("", error.what());
      if (seen.lines().size() > nSeen)
        mistakes.add("", std::string(error.what()) + "\n  (" + run.place + ": series \"" + run.label + "\")");
    }
  }
}

}  // namespace

Study readStudy(const std::string& fileName, const std::vector<std::string>& overrides) {
  const Deck file = Deck::read(fileName);
  Mistakes mistakes;
  Teuchos::ParameterList list = readParameters(file.root(), declareStudy(), mistakes, {{"Series"}, {}});
  Study study;
  study.name = list.get("Name", std::filesystem::path(fileName).stem().string());
  study.reference = list.get("Reference", std::string());
  study.errorNorm = list.get("Error", std::string());
  const DeckNode series = file["Series"];
  if (!series.isSequence() || series.items().empty()) {
    mistakes.add(series ? series.place() : fileName,
                 "Series must be a list, each with a Label, Overrides and a Sweep of values");
  } else {
    int number = 0;
    for (const DeckNode& entry : series.items()) addSeries(entry, ++number, study, mistakes);
  }
  mistakes.report();
  study.deckFile = file.resolvePath(list.get<std::string>("Deck"));
  for (StudyRun& run : study.runs) run.overrides.insert(run.overrides.end(), overrides.begin(), overrides.end());
  checkDecks(study, mistakes);
  mistakes.report();
  return study;
}

}  // namespace pd
