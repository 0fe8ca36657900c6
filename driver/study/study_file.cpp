#include "study_file.hpp"

#include <algorithm>
#include <filesystem>

#include "../deck/deck.hpp"
#include "../deck/deck_parameters.hpp"
#include "../deck/names.hpp"
#include "override_values.hpp"

namespace pd {

namespace {

ParameterDeclarations declareStudy() {
  ParameterDeclarations declare;
  declare.text("Deck", "The deck that is run, seen from the folder of the study.").required();
  declare.text("Name", "Of the results (default: the name of the file).");
  declare.text("Error", "Part of the name of one error norm of the deck's Exact Solution.");
  declare.text("Reference", "What the errors are taken against, for table and picture.");
  declare.texts("Histories",
                "Columns of the CSV files of the runs, which table and picture show; a vector stands for its "
                "components.");
  declare.texts("History Values", "What the table tells of each history (default: Final).")
      .oneOf(HistoryValue::names());
  declare.atLeastOneOf({"Error", "Histories"});
  declare.needs("Error", {"Reference"});
  declare.needs("Reference", {"Error"});
  declare.needs("History Values", {"Histories"});
  return declare;
}

ParameterDeclarations declareSeries() {
  ParameterDeclarations declare;
  declare.text("Label", "Name of the series in table and picture.").required();
  declare.sublist("Overrides",
                  "Paths of the deck, as in \"Solver/Final Time: 1.0\", that all runs of the series share.");
  declare.sublist("Sweep", "Paths of the deck with a list of values, one for each run; several lists go side by side.");
  return declare;
}

StudyOverride overrideOf(const std::string& path, const DeckNode& value) {
  return {path, flowYaml(value), value.place()};
}

class StudyReader {
 public:
  StudyReader(const std::string& fileName, const std::vector<std::string>& overrides, Mistakes& mistakes)
      : file_(Deck::read(fileName)), overrides_(overrides), mistakes_(mistakes) {
    study_.fileName = fileName;
  }

  Study read() {
    head();
    const DeckNode series = file_["Series"];
    if (!series.isSequence() || series.items().empty()) {
      mistakes_.add(series ? series.place() : file_.root().place(),
                    "Series must be a list, each with a Label, Overrides and a Sweep of values");
    } else {
      for (const DeckNode& entry : series.items()) addSeries(entry, ++nSeries_);
    }
    return study_;
  }

 private:
  void head() {
    Mistakes own;
    const Teuchos::ParameterList list = readParameters(file_.root(), studyDeclarations(), own, {{"Series"}, {}});
    addOfRoot(own, file_, "study", mistakes_);
    study_.name = file_.root().isMap() && list.isParameter("Name")
                      ? list.get<std::string>("Name")
                      : std::filesystem::path(file_.fileName()).stem().string();
    if (const std::string complaint = complaintOfFileName(study_.name); !complaint.empty())
      mistakes_.add(file_["Name"] ? file_["Name"].place() : file_.fileName(), "Name " + complaint);
    const auto text = [&](const char* key) { return list.isParameter(key) ? list.get<std::string>(key) : ""; };
    study_.reference = text("Reference");
    study_.errorNorm = text("Error");
    study_.errorPlace = file_["Error"].place();
    histories();
    if (!list.isParameter("Deck")) return;
    study_.deckFile = file_.resolvePath(text("Deck"));
    std::error_code error;
    if (std::filesystem::is_regular_file(study_.deckFile, error)) return;
    mistakes_.add(file_["Deck"].place(),
                  "Deck: there is no file \"" + study_.deckFile + "\" (names start at the folder of the study)");
    study_.deckFile.clear();
  }

  void histories() {
    for (const DeckNode& item : file_["Histories"].items())
      if (item.isScalar()) study_.histories.push_back({item.text(), item.place(), {}});
    const std::vector<std::string>& names = HistoryValue::names();
    for (const DeckNode& item : file_["History Values"].items()) {
      const auto found = std::find(names.begin(), names.end(), item.isScalar() ? item.text() : "");
      if (found != names.end()) study_.historyValues.push_back(static_cast<HistoryValue::Kind>(found - names.begin()));
    }
    if (study_.historyValues.empty()) study_.historyValues = {HistoryValue::Final};
  }

  void addSeries(const DeckNode& series, int number) {
    // Overrides and Sweep hold paths of the deck, which no declaration knows.
    ParameterDeclarations own;
    own.text("Label", "") = *studySeriesDeclarations().find("Label");
    const auto list = readParameters(series, own, mistakes_, {{"Overrides", "Sweep"}, {}});
    bool isGood = series.isMap();
    for (const char* key : {"Overrides", "Sweep"}) {
      const DeckNode section = series[key];
      if (!section || section.isMap()) continue;
      mistakes_.add(section.place(),
                    section.path() + " must be a section of deck paths, as in \"Solver/Final Time: 1.0\"");
      isGood = false;
    }
    if (!isGood || !list.isParameter("Label")) return;
    if (hasControlCharacter(list.get<std::string>("Label")))
      mistakes_.add(series["Label"].place(), series["Label"].path() + " must be one line, without tabs");
    int run = 0;
    for (StudyRun& added : runsOf(series)) {
      added.label = list.get<std::string>("Label");
      added.place = series.place();
      added.outputName = study_.name + ".study/" + std::to_string(number) + "_" + std::to_string(++run);
      addCommandLine(added);
      study_.runs.push_back(std::move(added));
    }
  }

  void addCommandLine(StudyRun& run) const {
    for (const std::string& text : overrides_) run.overrides.push_back(overrideOfCommandLine(text));
  }

  std::vector<StudyRun> runsOf(const DeckNode& series) {
    StudyRun common;
    for (const auto& [path, value] : series["Overrides"].entries())
      if (hasValue(value)) common.overrides.push_back(overrideOf(path, value));
    const auto sweeps = series["Sweep"].entries();
    if (sweeps.empty()) return {common};
    std::vector<StudyRun> runs(sweeps.front().second.items().size(), common);
    for (const auto& [path, list] : sweeps) {
      const std::vector<DeckNode> values = list.items();
      if (!list.isSequence() || values.empty()) {
        mistakes_.add(list.place(), list.path() + " must be a list of values, one for each run");
      } else if (!runs.empty() && values.size() != runs.size()) {
        mistakes_.add(list.place(), list.path() + " has " + std::to_string(values.size()) + " values, but \"" +
                                        sweeps.front().first + "\" has " + std::to_string(runs.size()) +
                                        ": lists of one Sweep go side by side");
      } else {
        for (std::size_t i = 0; i < runs.size(); ++i) {
          if (!hasValue(values[i])) continue;
          runs[i].overrides.push_back(overrideOf(path, values[i]));
          runs[i].swept.emplace_back(path, runs[i].overrides.back().value);
        }
      }
    }
    return runs;
  }

  bool hasValue(const DeckNode& value) {
    if (isMissing(value)) mistakes_.add(value.place(), value.path() + " has no value");
    return !isMissing(value);
  }

  const Deck file_;
  const std::vector<std::string>& overrides_;
  Mistakes& mistakes_;
  Study study_;
  int nSeries_ = 0;
};

}  // namespace

const std::vector<std::string>& HistoryValue::names() {
  static const std::vector<std::string> names{"Final", "Maximum", "Minimum", "Time Of Maximum"};
  return names;
}

const ParameterDeclarations& studyDeclarations() {
  static const ParameterDeclarations declarations = declareStudy();
  return declarations;
}

const ParameterDeclarations& studySeriesDeclarations() {
  static const ParameterDeclarations declarations = declareSeries();
  return declarations;
}

Study readStudy(const std::string& fileName, const std::vector<std::string>& overrides, Mistakes& mistakes) {
  return StudyReader(fileName, overrides, mistakes).read();
}

}  // namespace pd
