#include "run_fit.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../deck/deck.hpp"
#include "../model/model.hpp"
#include "../output/atomic_file.hpp"
#include "../output/result_files.hpp"
#include "../output/result_lock.hpp"
#include "../parallel/launch.hpp"
#include "child_process.hpp"
#include "fitted_deck.hpp"

namespace pd {

namespace {

using nlohmann::ordered_json;

/// FNV-1a, 64 bits (Fowler, Noll & Vo): what tells contents of files apart.
class ContentHash {
 public:
  void add(const char* bytes, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) value_ = (value_ ^ static_cast<unsigned char>(bytes[i])) * 1099511628211ull;
  }
  void addFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::vector<char> bytes(1 << 20);
    while (file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || file.gcount() > 0)
      add(bytes.data(), static_cast<std::size_t>(file.gcount()));
    add("", 1);
  }
  void addText(const std::string& text) { add(text.c_str(), text.size() + 1); }
  std::string text() const { return fmt::format("{:016x}", value_); }

 private:
  unsigned long long value_ = 14695981039346656037ull;
};

/// The same for runs that differ in nothing but overrides: the deck, the files that it names, and pdrun.
std::string originOf(const FitRun& run, const Fit& fit, const std::string& program) {
  ContentHash hash;
  struct stat status {};
  if (stat(program.c_str(), &status) == 0)
    hash.addText(fmt::format("{} {}", static_cast<long long>(status.st_size), static_cast<long long>(status.st_mtime)));
  for (const std::string& file : filesOf(run.deckFile, overridesWith(run.overrides, fit.values, fit.start())))
    hash.addFile(file);
  return hash.text();
}

ordered_json bound(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr); }

ordered_json valuesOf(const Fit& fit) {
  ordered_json values = ordered_json::array();
  for (const FitValue& value : fit.values)
    values.push_back({{"name", value.name},
                      {"unit", value.unit},
                      {"factor", value.factor},
                      {"start", value.start},
                      {"lowest", bound(value.lowest)},
                      {"highest", bound(value.highest)},
                      {"scale", value.scale()},
                      {"logarithmic", value.isLogarithmic}});
  return values;
}

ordered_json runsOf(const Fit& fit, const std::vector<std::string>& origins) {
  ordered_json runs = ordered_json::array();
  for (std::size_t r = 0; r < fit.runs.size(); ++r) {
    ordered_json overrides = ordered_json::array();
    for (const FitOverride& item : fit.runs[r].overrides) {
      ordered_json pieces = ordered_json::array();
      for (const FitOverride::Piece& piece : item.pieces)
        pieces.push_back(piece.value < 0 ? ordered_json(piece.text)
                                         : ordered_json{{"value", piece.value}, {"whole", piece.isWhole}});
      overrides.push_back({{"path", item.path}, {"pieces", pieces}});
    }
    runs.push_back({{"deck", fit.runs[r].deckFile}, {"origin", origins[r]}, {"overrides", overrides}});
  }
  return runs;
}

ordered_json seriesOf(const Fit& fit) {
  ordered_json all = ordered_json::array();
  for (const FitSeries& series : fit.series) {
    ordered_json points = ordered_json::array();
    for (const FitPoint& point : series.points)
      points.push_back({{"run", point.run},
                        {"time", point.time},
                        {"measured", point.measured},
                        {"deviation", point.deviation},
                        {"fitted", point.isFitted},
                        {"place", point.place}});
    all.push_back({{"label", series.label},
                   {"column", series.history.columns.front()},
                   {"value", series.isOverTime ? "" : HistoryValue::names()[series.kind]},
                   {"factor", series.factor},
                   {"unit", series.unit},
                   {"time unit", series.timeUnit},
                   {"time factor", series.timeFactor},
                   {"logarithmic", series.isLogarithmic},
                   {"points", points}});
  }
  return all;
}

std::string pathOfDeck(const Fit& fit, const FittedDeck& deck, const std::string& base) {
  return base + (fit.decks.size() > 1 ? "." + deck.name : "") + endings::fitted;
}

std::vector<std::string> pathsOfDecks(const Fit& fit, const std::string& base) {
  std::vector<std::string> paths;
  for (const FittedDeck& deck : fit.decks) paths.push_back(pathOfDeck(fit, deck, base));
  return paths;
}

std::vector<double> fittedValues(const std::string& fileName) {
  try {
    std::ifstream file(fileName);
    std::vector<double> values;
    const auto result = nlohmann::json::parse(file);
    for (const auto& value : result.at("values")) values.push_back(value.at("value").get<double>());
    return values;
  } catch (const nlohmann::json::exception& error) {
    throw RunError(fileName + ": not the results of a fit (" + error.what() + ")");
  }
}

}  // namespace

void checkFitResults(const Fit& fit, const std::string& folder) {
  const std::string base = resultPath(folder, fit.name);
  Mistakes mistakes;
  const std::string obstacle = obstacleOfPlace(base + endings::fitRuns + "/", folder);
  if (!obstacle.empty()) mistakes.add(fit.fileName, obstacle);
  for (const std::string& found : obstaclesOfFit(base, pathsOfDecks(fit, base))) mistakes.add(fit.fileName, found);
  mistakes.report();
}

void runFit(const Fit& fit, const std::string& folder, bool isQuiet) {
  const std::string program = ownProgram();
  if (program.empty()) throw RunError("cannot find the file of pdrun itself, which runs the decks of a fit");
  const std::string base = resultPath(folder, fit.name);
  const ResultLock lock(base + endings::fitRuns);
  checkFitResults(fit, folder);
  std::vector<std::string> origins;
  for (const FitRun& run : fit.runs) origins.push_back(originOf(run, fit, program));
  removeFitResults(base, pathsOfDecks(fit, base), {origins.begin(), origins.end()});
  const ordered_json problem = {{"writer", "pdrun"},
                                {"name", fit.name},
                                {"base", base},
                                {"folder", folder},
                                {"program", program},
                                {"quiet", isQuiet},
                                {"tolerance", fit.tolerance},
                                {"difference step", fit.differenceStep},
                                {"central", fit.isCentral},
                                {"iterations", fit.nIterations},
                                {"processes", fit.nProcesses},
                                {"values", valuesOf(fit)},
                                {"runs", runsOf(fit, origins)},
                                {"series", seriesOf(fit)}};
  const std::string problemFile = base + endings::problem;
  makeFolderOf(problemFile);
  writeFileAtomically(problemFile, problem.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n");
  if (runProgram({toolBeside(program, "pdfit"), problemFile}) != 0) throw RunError("the fit has failed (see above)");
  const std::vector<double> values = fittedValues(base + endings::fitResult);
  for (const FittedDeck& deck : fit.decks) {
    const std::string path = pathOfDeck(fit, deck, base);
    const std::string outputName = fit.name + (fit.decks.size() > 1 ? "." + deck.name : "") + "_fitted";
    writeFileAtomically(path, fittedDeck(fit, deck, values, path, outputName));
    if (!isQuiet) std::puts(("deck: " + path).c_str());
  }
}

}  // namespace pd
