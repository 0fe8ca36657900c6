#include "fit_file.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "../deck/deck.hpp"
#include "../deck/deck_data.hpp"
#include "../deck/deck_parameters.hpp"
#include "../deck/names.hpp"
#include "../deck/units.hpp"
#include "data_file.hpp"
#include "fit_override.hpp"
#include "override_values.hpp"

namespace pd {

namespace {

using ParameterList = Teuchos::ParameterList;

std::string textOr(const ParameterList& list, const char* key, const std::string& fallback = "") {
  return list.isParameter(key) ? list.get<std::string>(key) : fallback;
}

/// The unit; nothing, with a mistake, where it is none.
std::optional<Unit> unitAt(const DeckNode& node, Mistakes& mistakes) {
  std::string unknown;
  const std::optional<Unit> unit = parseUnit(node.text(), &unknown);
  if (!unit)
    mistakes.add(node.place(), node.path() + ": there is no unit \"" + node.text() + "\"" + didYouMeanUnit(unknown));
  return unit;
}

bool isColumnAt(const DataFile& data, const DeckNode& node, Mistakes& mistakes) {
  if (data.column(node.text())) return true;
  mistakes.add(node.place(), node.path() + ": " + data.fileName + " has no column \"" + node.text() + "\"" +
                                 didYouMean(node.text(), data.names) + "; it has: " + quotedList(data.names));
  return false;
}

const char* const neededKeys[] = {"Label", "Data", "Value", "History"};

/// The columns of a series.
struct FitColumns {
  std::optional<std::size_t> time, value, deviation;
  double deviationOfAll = 0.0;
};

class FitReader {
 public:
  FitReader(const std::string& fileName, const std::vector<std::string>& overrides, Mistakes& mistakes)
      : file_(Deck::read(fileName)), mistakes_(mistakes) {
    fit_.fileName = fileName;
    for (const std::string& text : overrides) {
      const StudyOverride item = overrideOfCommandLine(text);
      commandLine_.push_back({item.path, "", {{item.value}}});
    }
  }

  Fit read() {
    head();
    values();
    const DeckNode series = file_["Series"];
    if (!series.isSequence() || series.items().empty())
      mistakes_.add(series ? series.place() : file_.root().place(),
                    "Series must be a list, each with a Label, its Data and the History that they are compared with");
    for (const DeckNode& entry : series.items()) addSeries(entry);
    finish();
    return fit_;
  }

 private:
  void head() {
    Mistakes own;
    const ParameterList list =
        readParameters(file_.root(), fitDeclarations(), own, {{"Values", "Overrides", "Series"}, {}});
    addOfRoot(own, file_, "fit", mistakes_);
    fit_.name = textOr(list, "Name", std::filesystem::path(file_.fileName()).stem().string());
    if (const std::string complaint = complaintOfFileName(fit_.name); !complaint.empty())
      mistakes_.add(file_["Name"] ? file_["Name"].place() : file_.fileName(), "Name " + complaint);
    deckFile_ = deckAt(file_["Deck"]);
    if (!own.empty()) return;
    fit_.tolerance = list.get<double>("Tolerance");
    fit_.differenceStep = list.get<double>("Difference Step");
    fit_.isCentral = list.get<std::string>("Differences") == "Central";
    fit_.nIterations = list.get<int>("Maximum Iterations");
    fit_.nProcesses = list.isParameter("Processes") ? list.get<int>("Processes") : 0;
  }

  std::string deckAt(const DeckNode& node) { return fileAt(node, "names start at the folder of the fit"); }

  /// Its path; empty, with a mistake, where it is not there.
  std::string fileAt(const DeckNode& node, const std::string& hint) {
    if (!node.isScalar()) return "";
    const std::string name = file_.resolvePath(node.text());
    std::error_code error;
    if (std::filesystem::is_regular_file(name, error)) return name;
    mistakes_.add(node.place(), node.path() + ": there is no file \"" + name + "\" (" + hint + ")");
    return "";
  }

  void values() {
    const DeckNode section = file_["Values"];
    if (!section.isMap() || section.entries().empty())
      mistakes_.add(section ? section.place() : file_.root().place(),
                    "Values must be a section with the values that are fitted, each by a name of your choice with its "
                    "Start");
    if (!section.isMap()) return;
    for (const auto& [name, entry] : section.entries()) addValue(name, entry);
  }

  void addValue(const std::string& name, const DeckNode& entry) {
    if (name.find_first_of("{}\",") != std::string::npos || hasControlCharacter(name))
      mistakes_.add(entry.keyPlace(), "the name of a value must be free of braces, quotes and commas");
    const ParameterList list = readParameters(entry, fitValueDeclarations(), mistakes_);
    names_.push_back(name);  // known, so that its uses are no mistakes
    if (!entry.isMap() || !list.isParameter("Start")) {
      valuesAreKnown_ = false;
      return;
    }
    FitValue value;
    value.name = name;
    value.place = entry.keyPlace();
    value.start = list.get<double>("Start");
    value.isLogarithmic = list.get<bool>("Logarithmic");
    if (list.isParameter("Lowest")) value.lowest = list.get<double>("Lowest");
    if (list.isParameter("Highest")) value.highest = list.get<double>("Highest");
    value.unit = textOr(list, "Unit");
    if (!value.unit.empty())
      if (const auto unit = unitAt(entry["Unit"], mistakes_)) value.factor = unit->size();
    checkBounds(value, entry);
    fit_.values.push_back(value);
  }

  void checkBounds(const FitValue& value, const DeckNode& entry) {
    const auto complain = [&](const char* key, const std::string& text) {
      mistakes_.add(entry[key].place(), entry.path() + ": " + text);
    };
    const std::string lowest = realText(value.lowest), highest = realText(value.highest), start = realText(value.start);
    if (!(value.lowest < value.highest))
      complain("Lowest", "Lowest " + lowest + " must be below Highest " + highest);
    else if (value.start < value.lowest || value.start > value.highest)
      complain("Start", "Start " + start + " must lie between Lowest and Highest");
    else if (value.isLogarithmic && !(value.start > 0.0 && (value.lowest > 0.0 || !entry["Lowest"])))
      complain("Logarithmic", "of a Logarithmic value Start and Lowest must be above 0");
    else if (value.start == 0.0 && !std::isfinite(value.highest - value.lowest))
      complain("Start", "a value that starts at 0 needs Lowest and Highest, which tell how large a step is");
  }

  void addSeries(const DeckNode& node) {
    const ParameterList list = readParameters(node, fitSeriesKeys(), mistakes_, {{"Overrides"}, {}});
    const bool hasKeys = std::all_of(std::begin(neededKeys), std::end(neededKeys),
                                     [&](const char* key) { return list.isParameter(key); });
    if (!hasKeys || list.isParameter("Time") == list.isParameter("History Value")) {
      seriesAreKnown_ = false;
      return;
    }
    FitSeries series;
    series.label = list.get<std::string>("Label");
    series.place = node.place();
    if (hasControlCharacter(series.label))
      mistakes_.add(node["Label"].place(), node["Label"].path() + " must be one line, without tabs");
    series.history = {list.get<std::string>("History"), node["History"].place(), {}};
    series.unit = textOr(list, "Unit");
    series.unitPlace = node["Unit"].place();
    series.isOverTime = list.isParameter("Time");
    series.isLogarithmic = list.get<bool>("Logarithmic");
    const auto& kinds = HistoryValue::names();
    if (!series.isOverTime)
      series.kind = static_cast<HistoryValue::Kind>(
          std::find(kinds.begin(), kinds.end(), list.get<std::string>("History Value")) - kinds.begin());
    series.timeUnit = textOr(list, "Time Unit");
    if (!series.timeUnit.empty())
      if (const auto unit = unitAt(node["Time Unit"], mistakes_)) {
        series.timeFactor = unit->size();
        if (!unit->measuresAs(*parseUnit("s")))
          mistakes_.add(node["Time Unit"].place(),
                        node.path() + ": Time Unit must be one of time, such as s, min or h");
      }
    const std::string dataFile = fileAt(node["Data"], "names start at the folder of the fit");
    const std::string deckFile = node["Deck"] ? deckAt(node["Deck"]) : deckFile_;
    addPoints(series, node, list, readData(dataFile), deckFile);
  }

  /// Nothing, with the mistakes, where it cannot be read.
  std::optional<DataFile> readData(const std::string& fileName) {
    try {
      if (!fileName.empty()) return DataFile::read(fileName);
    } catch (const DeckError& error) {
      addAll(mistakes_, error);
    }
    seriesAreKnown_ = false;
    return std::nullopt;
  }

  FitColumns columnsOf(const FitSeries& series, const DeckNode& node, const DataFile& data) {
    FitColumns columns;
    if (isColumnAt(data, node["Value"], mistakes_)) columns.value = data.column(node["Value"].text());
    if (series.isOverTime && isColumnAt(data, node["Time"], mistakes_)) columns.time = data.column(node["Time"].text());
    if (!node["Deviation"]) return columns;
    if (const auto number = parseReal(node["Deviation"].text())) {
      columns.deviationOfAll = *number;
      if (!(*number > 0.0)) mistakes_.add(node["Deviation"].place(), node["Deviation"].path() + " must be above 0");
    } else if (isColumnAt(data, node["Deviation"], mistakes_)) {
      columns.deviation = data.column(node["Deviation"].text());
    }
    return columns;
  }

  /// And its runs, as far as they are known: that of a series over time without its data, too.
  void addPoints(FitSeries& series, const DeckNode& node, const ParameterList& list,
                 const std::optional<DataFile>& data, const std::string& deckFile) {
    series.firstRun = fit_.runs.size();
    if (series.isOverTime) addRun(series, node, {names_, {}}, deckFile);
    if (data) addRows(series, node, list, *data, deckFile);
    if (fit_.runs.size() == series.firstRun) return;
    addDeck(deckFile);
    fit_.series.push_back(series);
  }

  void addRows(FitSeries& series, const DeckNode& node, const ParameterList& list, const DataFile& data,
               const std::string& deckFile) {
    const FitColumns columns = columnsOf(series, node, data);
    const bool hasColumns = columns.value && (columns.time || !series.isOverTime);
    seriesAreKnown_ = seriesAreKnown_ && hasColumns;
    const double from = list.isParameter("From") ? list.get<double>("From") : -HUGE_VAL;
    const double until = list.isParameter("Until") ? list.get<double>("Until") : HUGE_VAL;
    for (std::size_t row = 0; row < data.rows.size(); ++row) {
      if (!series.isOverTime) addRun(series, node, {names_, cellsOf(data, row)}, deckFile);
      if (hasColumns) addPoint(series, data, row, columns, from, until);
    }
    if (hasColumns &&
        std::none_of(series.points.begin(), series.points.end(), [](const FitPoint& point) { return point.isFitted; }))
      mistakes_.add(series.place, node.path() + ": no row of " + data.fileName + " is left to fit by From and Until");
  }

  static std::map<std::string, std::string> cellsOf(const DataFile& data, std::size_t row) {
    std::map<std::string, std::string> cells;
    for (std::size_t c = 0; c < data.names.size(); ++c) cells[data.names[c]] = data.rows[row][c];
    return cells;
  }

  void addPoint(FitSeries& series, const DataFile& data, std::size_t row, const FitColumns& columns, double from,
                double until) {
    FitPoint point;
    point.run = fit_.runs.size() - 1;
    point.place = data.place(row);
    const auto measured = data.number(row, *columns.value, mistakes_);
    const auto time = columns.time ? data.number(row, *columns.time, mistakes_) : std::optional(0.0);
    const auto deviation =
        columns.deviation ? data.number(row, *columns.deviation, mistakes_) : std::optional(columns.deviationOfAll);
    if (!measured || !time || !deviation) {
      seriesAreKnown_ = false;
      return;
    }
    point.time = *time * series.timeFactor;
    point.measured = *measured;
    point.deviation = *deviation;
    // Bounds of decimal times are met to rounding.
    const double slack = 1e-9 * std::abs(point.time);
    point.isFitted = !series.isOverTime || (point.time >= from - slack && point.time <= until + slack);
    if (columns.deviation && point.isFitted && !(point.deviation > 0.0))
      mistakes_.add(point.place,
                    "the standard deviation must be above 0; leave the row out, or by From and Until of "
                    "series \"" +
                        series.label + "\" out of the fit");
    if (series.isLogarithmic && point.isFitted && !(point.measured > 0.0))
      mistakes_.add(point.place, "a value of a Logarithmic series must be above 0");
    series.points.push_back(point);
  }

  /// Overrides of the file, then of the series, then of the command line.
  std::vector<FitOverride> overridesOf(const DeckNode& node, const FitNames& names, Mistakes& mistakes) const {
    std::vector<FitOverride> result;
    for (const DeckNode& section : {file_["Overrides"], node["Overrides"]}) {
      if (!section) continue;
      if (!section.isMap())
        mistakes.add(section.place(), section.path() +
                                          " must be a section of deck paths, as in \"Solver/Final Time: "
                                          "1.0\"");
      const bool isOfFile = section.path() == "Overrides";
      for (const auto& [path, value] : section.entries()) {
        if (isMissing(value)) {
          mistakes.add(value.place(), value.path() + " has no value");
          continue;
        }
        result.push_back(readFitOverride(path, value, isOfFile ? FitNames{names_, {}} : names, mistakes));
      }
    }
    result.insert(result.end(), commandLine_.begin(), commandLine_.end());
    return result;
  }

  void addRun(const FitSeries& series, const DeckNode& node, const FitNames& names, const std::string& deckFile) {
    for (const auto& column : names.columns)
      if (contains(names_, column.first))
        mistakes_.add(series.place, "\"" + column.first + "\" is a fitted value and a column of the data; rename one");
    Mistakes own;
    FitRun run{deckFile, series.label, series.place, overridesOf(node, names, own)};
    for (const std::string& line : own.lines()) mistakes_.add("", line);
    overridesAreKnown_ = overridesAreKnown_ && own.empty();
    run.isKnown = own.empty() && valuesAreKnown_ && !deckFile.empty();
    fit_.runs.push_back(run);
  }

  /// The deck of this series with what is the same in all of its rows, once.
  void addDeck(const std::string& deckFile) {
    if (!fit_.runs.back().isKnown) return;
    FittedDeck deck{"", deckFile, {}};
    for (const FitOverride& item : fit_.runs.back().overrides)
      if (!item.hasColumns) deck.overrides.push_back(item);
    const auto textOf = [&](const FittedDeck& of) {
      std::string text = of.deckFile;
      for (const StudyOverride& item : overridesWith(of.overrides, fit_.values, fit_.start()))
        text += "\n" + item.text();
      return text;
    };
    const std::string text = textOf(deck);
    if (std::any_of(fit_.decks.begin(), fit_.decks.end(),
                    [&](const FittedDeck& other) { return textOf(other) == text; }))
      return;
    deck.name = std::filesystem::path(deckFile).stem().string();
    int n = 1;
    for (const FittedDeck& other : fit_.decks) n += other.deckFile == deckFile ? 1 : 0;
    if (n > 1) deck.name += "_" + std::to_string(n);
    fit_.decks.push_back(deck);
  }

  void finish() {
    std::set<int> used;
    std::size_t nFitted = 0, nWith = 0;
    for (const FitRun& run : fit_.runs)
      for (const FitOverride& item : run.overrides)
        for (const FitOverride::Piece& piece : item.pieces) used.insert(piece.value);
    for (std::size_t i = 0; valuesAreKnown_ && overridesAreKnown_ && i < fit_.values.size(); ++i)
      if (used.count(static_cast<int>(i)) == 0)
        mistakes_.add(fit_.values[i].place, "\"" + fit_.values[i].name +
                                                "\" stands in no override, so that no run knows of it; write \"{" +
                                                fit_.values[i].name + "}\" where the deck has the value");
    if (!seriesAreKnown_ || fit_.series.empty()) return;
    for (const FitSeries& series : fit_.series) {
      for (const FitPoint& point : series.points) nFitted += point.isFitted ? 1 : 0;
      nWith += series.hasDeviationOfFitted() ? 1 : 0;
    }
    if (nWith != 0 && nWith != fit_.series.size())
      mistakes_.add(file_["Series"].place(),
                    "Series: give all of them a Deviation, or none: else nothing says how they weigh");
    if (nFitted < fit_.values.size())
      mistakes_.add(file_["Series"].place(), "Series: " + std::to_string(nFitted) + " measured points cannot tell " +
                                                 std::to_string(fit_.values.size()) + " values");
  }

  const Deck file_;
  std::vector<FitOverride> commandLine_;
  Mistakes& mistakes_;
  // Whether mistakes have left all of them; what needs all of them is not judged otherwise.
  bool valuesAreKnown_ = true, overridesAreKnown_ = true, seriesAreKnown_ = true;
  Fit fit_;
  std::string deckFile_;
  std::vector<std::string> names_;
};

}  // namespace

bool FitSeries::hasDeviationOfFitted() const {
  return std::any_of(points.begin(), points.end(),
                     [](const FitPoint& point) { return point.isFitted && point.deviation > 0.0; });
}

Fit readFit(const std::string& fileName, const std::vector<std::string>& overrides, Mistakes& mistakes) {
  return FitReader(fileName, overrides, mistakes).read();
}

}  // namespace pd
