#include "run_study.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "../deck/deck.hpp"
#include "../output/atomic_file.hpp"
#include "../output/output.hpp"
#include "child_process.hpp"

namespace pd {

namespace {

struct Result {
  double error = 0.0, seconds = 0.0;
  long long bondUpdates = 0;
};

/// The one error norm whose name contains `part`.
double errorNorm(const nlohmann::json& norms, const std::string& part) {
  std::vector<std::string> found, all;
  for (const auto& [name, value] : norms.items()) {
    all.push_back(name);
    if (name.find(part) != std::string::npos) found.push_back(name);
  }
  if (found.size() != 1)
    throw DeckError(
        fmt::format("Error: \"{}\" must be part of exactly one error norm; the deck has {}", part, quotedList(all)));
  return norms[found.front()].get<double>();
}

Result readReport(const std::string& fileName, const std::string& norm) {
  try {
    std::ifstream file(fileName);
    const auto report = nlohmann::json::parse(file);
    Result result;
    result.error = errorNorm(report.at("error_norms"), norm);
    result.seconds = report.at("seconds").get<double>();
    for (const auto& phase : report.at("phases")) result.bondUpdates += phase.at("bond_updates").get<long long>();
    return result;
  } catch (const nlohmann::json::exception& error) {
    throw RunError(fileName + ": not a report of a run (" + error.what() + ")");
  }
}

/// Nothing where the run could not go on; it has told why.
std::optional<Result> perform(const Study& study, const StudyRun& run, const std::string& program) {
  std::vector<std::string> arguments = {program, study.deckFile, "--quiet"};
  for (const std::string& item : run.overrides) arguments.insert(arguments.end(), {"--set", item});
  arguments.insert(arguments.end(), {"--set", "Output/Output Filename=\"" + run.outputName + "\""});
  if (runProgram(arguments) != 0) return std::nullopt;
  return readReport(run.outputName + ".report.json", study.errorNorm);
}

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : "; ") + item;
  return text;
}

/// A field of a CSV file, as in RFC 4180.
std::string csvText(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

void print(bool isQuiet, const std::string& line) {
  if (isQuiet) return;
  std::fputs((line + "\n").c_str(), stdout);
  std::fflush(stdout);
}

void draw(const Study& study, const std::string& table, const std::string& program, bool isQuiet) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(program).parent_path();
  for (const fs::path& tool :
       {folder / "pdstudy", folder / ".." / "meshes" / "pdstudy", fs::path(PD_SOURCE_DIR) / "meshes" / "pdstudy"}) {
    if (!fs::exists(tool)) continue;
    const std::string picture = study.name + ".study.png";
    const int code =
        runProgram({tool.string(), table, "--reference", study.reference, "--error", study.errorNorm, "-o", picture});
    print(isQuiet, code == 0 ? "picture: " + picture : "pdstudy drew no picture");
    return;
  }
}

}  // namespace

void runStudy(const Study& study, bool isQuiet) {
  const std::string program = ownProgram();
  if (program.empty()) throw RunError("cannot find the file of pdrun itself, which runs the decks of a study");
  std::size_t width = 12, nFailed = 0;
  for (const StudyRun& run : study.runs) width = std::max(width, run.label.size());
  std::string table = "label,overrides,error,seconds,bond_updates\n";
  const std::string tableFile = study.name + ".study.csv";
  makeFolderOf(study.runs.front().outputName);
  print(isQuiet, fmt::format("{}: error \"{}\" against {}", study.name, study.errorNorm, study.reference));
  print(isQuiet, fmt::format("{:<{}} {:>11} {:>10} {:>13}  {}", "series", width, "error", "seconds", "bond-updates",
                             "overrides"));
  for (const StudyRun& run : study.runs) {
    const std::optional<Result> result = perform(study, run, program);
    table += csvText(run.label) + "," + csvText(joined(run.overrides)) + ",";
    table += result ? fmt::format("{:.9g},{:.6g},{}\n", result->error, result->seconds, result->bondUpdates) : ",,\n";
    writeFileAtomically(tableFile, table);
    if (!result) ++nFailed;
    print(isQuiet, fmt::format("{:<{}} {:>11} {:>10} {:>13}  {}", run.label, width,
                               result ? fmt::format("{:.4e}", result->error) : "failed",
                               result ? fmt::format("{:.3f}", result->seconds) : "",
                               result ? fmt::format("{:.4e}", static_cast<double>(result->bondUpdates)) : "",
                               joined(run.overrides)));
  }
  print(isQuiet, "table: " + tableFile);
  draw(study, tableFile, program, isQuiet);
  if (nFailed > 0)
    throw RunError(fmt::format("{} of {} runs of the study failed (see above)", nFailed, study.runs.size()));
}

}  // namespace pd
