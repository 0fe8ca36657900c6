#include "check_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "../../materials/registry/fields.hpp"
#include "../deck/deck.hpp"
#include "../deck/sections.hpp"
#include "../deck/units.hpp"
#include "../model/run_setup.hpp"
#include "../model/solver_sections.hpp"
#include "deck_of_run.hpp"

namespace pd {

namespace {

/// What a checked deck gives.
struct DeckOfFit {
  std::vector<WrittenHistory> histories;
  double begin = 0.0, end = 0.0;  ///< s
};

class FitCheck {
 public:
  FitCheck(Fit& fit, const Communicator& comm, bool withMeshes, Mistakes& mistakes)
      : fit_(fit), comm_(comm), withMeshes_(withMeshes), mistakes_(mistakes) {}

  void run() {
    std::map<std::size_t, DeckOfFit> decks;
    for (std::size_t i = 0; i < fit_.runs.size(); ++i)
      if (fit_.runs[i].isKnown)
        if (const auto deck = checkedDeck(fit_.runs[i], fit_.start(), "")) decks[i] = *deck;
    if (mistakes_.empty()) atBounds();
    for (FitSeries& series : fit_.series) {
      const auto deck = decks.find(series.firstRun);
      if (deck == decks.end()) continue;
      history(series, deck->second);
      if (series.isOverTime) times(series, deck->second);
    }
  }

 private:
  /// Nothing after a mistake. `where`: which values these are.
  std::optional<DeckOfFit> checkedDeck(const FitRun& run, const std::vector<double>& values, const std::string& where) {
    const std::vector<StudyOverride> overrides = overridesWith(run.overrides, fit_.values, values);
    try {
      const Deck deck = Deck::read(run.deckFile, textsOf(overrides));
      checkDeck(deck);
      requireOutput(deck);
      deck.mistakes().report();
      requireHistories(deck);
      DeckOfFit result{historiesOf(deck, comm_), initialTime(deck), finalTime(deck)};
      deck.mistakes().report();
      if (withMeshes_ && where.empty() && readMeshes_.insert(textOfMesh(deck)).second) rehearse(deck, comm_);
      return result;
    } catch (const DeckError& error) {
      for (const std::string& line : placedLines(error, overrides))
        if (said_.insert(line).second)
          mistakes_.add("", line + "\n  (" + run.place + ": series \"" + run.label + "\"" + where + ")");
      return std::nullopt;
    }
  }

  /// In one run of each deck: a bound that the deck does not take would end the fit half way.
  void atBounds() {
    std::set<std::string> done;
    for (const FitRun& run : fit_.runs)
      for (std::size_t i = 0; i < fit_.values.size(); ++i)
        for (const double bound : {fit_.values[i].lowest, fit_.values[i].highest}) {
          if (!std::isfinite(bound) || !done.insert(fmt::format("{} {} {}", run.deckFile, i, bound)).second) continue;
          std::vector<double> values = fit_.start();
          values[i] = bound;
          checkedDeck(run, values, fmt::format(", with \"{}\" at its bound {}", fit_.values[i].name, bound));
        }
  }

  void history(FitSeries& series, const DeckOfFit& deck) {
    std::string label;
    std::vector<std::string> components;
    for (const WrittenHistory& written : deck.histories) {
      const bool isColumn =
          std::find(written.columns.begin(), written.columns.end(), series.history.name) != written.columns.end();
      if (!isColumn && written.label != series.history.name) continue;
      label = written.label;
      components = isColumn ? std::vector<std::string>{series.history.name} : written.columns;
    }
    if (label.empty()) {
      mistakes_.add(series.history.place, "History: " + missingHistory(series.history.name, deck.histories));
    } else if (components.size() > 1) {
      mistakes_.add(series.history.place,
                    "History: \"" + label + "\" has several components; name one: " + quotedList(components));
    } else {
      series.history.columns = components;
      units(series, label);
    }
  }

  void units(FitSeries& series, const std::string& label) {
    const bool isTime = series.kind == HistoryValue::TimeOfMaximum && !series.isOverTime;
    // Of fatigue, time is counted in cycles.
    series.historyUnit = !isTime ? fields::unitOf(label) : parseUnit(series.unit) ? "s" : series.unit;
    if (series.unit.empty()) series.unit = series.historyUnit == "1" ? "" : series.historyUnit;
    if (series.unit == series.historyUnit || series.unitPlace.empty()) return;
    const std::optional<Unit> wanted = parseUnit(series.unit), given = parseUnit(series.historyUnit);
    if (wanted && given && wanted->measuresAs(*given))
      series.factor = given->size() / wanted->size();
    else
      mistakes_.add(series.unitPlace,
                    fmt::format("Unit: \"{}\" does not convert to that of the history \"{}\", which is {}", series.unit,
                                series.history.name,
                                series.historyUnit.empty() ? "known to the deck alone" : series.historyUnit));
  }

  void times(const FitSeries& series, const DeckOfFit& deck) {
    const double slack = 1e-9 * std::max(std::abs(deck.begin), std::abs(deck.end));
    for (const FitPoint& point : series.points)
      if (point.isFitted && (point.time < deck.begin - slack || point.time > deck.end + slack))
        mistakes_.add(
            point.place,
            fmt::format("time {:g} lies outside of the run of series \"{}\", which goes from {:g} to {:g}; "
                        "change its Final Time, the Time Unit of the series, or leave the row out by From and "
                        "Until",
                        point.time, series.label, deck.begin, deck.end));
  }

  Fit& fit_;
  const Communicator& comm_;
  const bool withMeshes_;
  Mistakes& mistakes_;
  std::set<std::string> said_, readMeshes_;
};

}  // namespace

void checkFit(Fit& fit, const Communicator& comm, bool withMeshes, Mistakes& mistakes) {
  FitCheck(fit, comm, withMeshes, mistakes).run();
}

}  // namespace pd
