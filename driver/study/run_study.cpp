#include "run_study.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "../deck/deck.hpp"
#include "../model/model.hpp"
#include "../output/atomic_file.hpp"
#include "../output/output.hpp"
#include "../output/result_files.hpp"
#include "../output/result_lock.hpp"
#include "../parallel/launch.hpp"
#include "child_process.hpp"
#include "history_file.hpp"
#include "study_table.hpp"

namespace pd {

namespace {

/// The one error norm whose name contains `part`.
double errorNorm(const nlohmann::json& norms, const std::string& part, const std::string& place) {
  std::vector<std::string> found, all;
  for (const auto& [name, value] : norms.items()) {
    all.push_back(name);
    if (name.find(part) != std::string::npos) found.push_back(name);
  }
  if (found.size() != 1)
    throw DeckError(fmt::format("{}: Error: \"{}\" must be part of exactly one error norm; the deck has {}", place,
                                part, quotedList(all)));
  return norms[found.front()].get<double>();
}

/// The results that are in the report of the run.
StudyResult readReport(const std::string& fileName, const Study& study) {
  try {
    std::ifstream file(fileName);
    const auto report = nlohmann::json::parse(file);
    StudyResult result;
    if (!study.errorNorm.empty()) result.error = errorNorm(report.at("error_norms"), study.errorNorm, study.errorPlace);
    result.seconds = report.at("seconds").get<double>();
    for (const auto& phase : report.at("phases")) result.bondUpdates += phase.at("bond_updates").get<long long>();
    return result;
  } catch (const nlohmann::json::exception& error) {
    throw RunError(fileName + ": not a report of a run (" + error.what() + ")");
  }
}

std::vector<double> readHistoryValues(const std::string& fileName, const Study& study) {
  std::vector<double> values;
  const auto columns = readHistory(fileName);
  for (const StudyHistory& history : study.histories)
    for (const std::string& name : history.columns) {
      const auto column = columns.find(name);
      if (column == columns.end()) throw RunError(fileName + ": the history has no column \"" + name + "\"");
      for (const HistoryValue::Kind kind : study.historyValues)
        values.push_back(valueOf(column->second, columns.at("time"), kind));
    }
  return values;
}

/// Nothing where the run could not go on; it has told why.
std::optional<StudyResult> perform(const Study& study, const StudyRun& run, const std::string& program,
                                   const std::string& folder) {
  std::vector<std::string> arguments = {program, study.deckFile, "--quiet"};
  if (!folder.empty()) arguments.insert(arguments.end(), {"--output-folder", folder});
  for (const StudyOverride& item : run.overrides) arguments.insert(arguments.end(), {"--set", item.text()});
  arguments.insert(arguments.end(), {"--set", "Output/Output Filename=\"" + run.outputName + "\""});
  if (runProgram(arguments) != 0) return std::nullopt;
  const std::string results = resultPath(folder, run.outputName);
  StudyResult result = readReport(results + endings::report, study);
  if (!study.histories.empty()) result.historyValues = readHistoryValues(results + endings::history, study);
  return result;
}

void print(bool isQuiet, const std::string& line) {
  if (isQuiet) return;
  std::fputs((line + "\n").c_str(), stdout);
  std::fflush(stdout);
}

void draw(const Study& study, const std::string& base, const std::string& program, bool isQuiet) {
  const std::string tool = toolBeside(program, "pdstudy");
  try {
    if (runProgram({tool, base + endings::table, "--reference", study.reference, "--error", study.errorNorm}) != 0)
      return print(isQuiet, "pdstudy drew no picture");
    if (!study.errorNorm.empty()) print(isQuiet, "picture: " + base + endings::errors);
    if (!study.histories.empty()) print(isQuiet, "picture: " + base + endings::histories);
  } catch (const RunError& error) {
    print(isQuiet, std::string("no picture: ") + error.what());
  }
}

}  // namespace

void checkStudyResults(const Study& study, const std::string& folder) {
  const std::string base = resultPath(folder, study.name);
  Mistakes mistakes;
  const std::string obstacle = obstacleOfPlace(base + endings::runs + "/", folder);
  if (!obstacle.empty()) mistakes.add(study.fileName, obstacle);
  for (const std::string& found : obstaclesOfStudy(base)) mistakes.add(study.fileName, found);
  mistakes.report();
}

void runStudy(const Study& study, const std::string& folder, bool isQuiet) {
  const std::string program = ownProgram();
  if (program.empty()) throw RunError("cannot find the file of pdrun itself, which runs the decks of a study");
  std::size_t nFailed = 0;
  const StudyTable table(study);
  std::string csv = table.csvHeading();
  const std::string base = resultPath(folder, study.name), tableFile = base + endings::table;
  const ResultLock lock(base + endings::runs);
  checkStudyResults(study, folder);
  removeStudyResults(base);
  if (!study.errorNorm.empty())
    print(isQuiet, fmt::format("{}: error \"{}\" against {}", study.name, study.errorNorm, study.reference));
  print(isQuiet, table.heading());
  for (const StudyRun& run : study.runs) {
    const std::optional<StudyResult> result = perform(study, run, program, folder);
    csv += table.csvRow(run, result ? &*result : nullptr);
    writeFileAtomically(tableFile, csv);
    if (!result) ++nFailed;
    print(isQuiet, table.row(run, result ? &*result : nullptr));
  }
  print(isQuiet, "table: " + tableFile);
  draw(study, base, program, isQuiet);
  if (nFailed > 0)
    throw RunError(fmt::format("{} of {} runs of the study failed (see above)", nFailed, study.runs.size()));
}

}  // namespace pd
