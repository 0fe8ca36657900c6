// A fit: values of decks that are adjusted until histories of runs agree with measured series.
#ifndef PD_FIT_FILE_HPP
#define PD_FIT_FILE_HPP

#include <limits>
#include <string>
#include <vector>

#include "../../materials/registry/parameters.hpp"
#include "study_file.hpp"

namespace pd {

/// A value that is adjusted; numbers are in its unit.
struct FitValue {
  std::string name, place, unit;  ///< unit: empty for that of the key it stands in
  double factor = 1.0;            ///< one of its unit in SI
  double start = 0.0;
  double lowest = -std::numeric_limits<double>::infinity(), highest = std::numeric_limits<double>::infinity();
  bool isLogarithmic = false;

  double scale() const;  ///< what is a step of one for the optimiser; of logarithmic ones that of the logarithm
};

/// An override in whose text fitted values stand.
struct FitOverride {
  struct Piece {
    std::string text;
    int value = -1;        ///< number of the fitted value that stands here in place of a text
    bool isWhole = false;  ///< it is all there is: a number with its unit; else a number in SI units
  };
  std::string path, place;
  std::vector<Piece> pieces;
  bool hasColumns = false;  ///< a column of the measured data stood in it

  /// With these `values`, in the order of the fit.
  StudyOverride with(const std::vector<FitValue>& fitted, const std::vector<double>& values) const;
};
std::vector<StudyOverride> overridesWith(const std::vector<FitOverride>& overrides, const std::vector<FitValue>& fitted,
                                         const std::vector<double>& values);

struct FitRun {
  std::string deckFile, label, place;  ///< label and place of its series
  std::vector<FitOverride> overrides;
  bool isKnown = true;  ///< its deck and all of its overrides have been read
};

struct FitPoint {
  std::size_t run = 0;
  double time = 0.0;                       ///< s; of a history that is compared over time
  double measured = 0.0, deviation = 0.0;  ///< deviation: 0 where none is given
  bool isFitted = true;                    ///< else it is only compared
  std::string place;                       ///< in the file of data
};

struct FitSeries {
  std::string label, place;
  StudyHistory history;
  std::string historyUnit, unit;  ///< of the history and of the data
  double factor = 1.0;            ///< one of the history's in the unit of the data
  std::string unitPlace;
  std::string timeUnit;  ///< of the data
  double timeFactor = 1.0;
  bool isOverTime = true;
  HistoryValue::Kind kind = HistoryValue::Final;
  bool isLogarithmic = false;
  std::size_t firstRun = 0;
  std::vector<FitPoint> points;

  bool hasDeviationOfFitted() const;
};

/// What becomes a deck with the fitted values.
struct FittedDeck {
  std::string name;  ///< of its file, below the folder of results
  std::string deckFile;
  std::vector<FitOverride> overrides;
};

/// A file of this form:
///   Deck: wire.yaml               # seen from the folder of the fit
///   Values:
///     Current: {Start: 5.0, Lowest: 1.0, Highest: 20.0, Unit: A/m^2}
///   Overrides: {Materials/Wire/Current Density: "{Current}"}
///   Series:
///     - {Label: tomograms, Data: measured.csv, Time: hours, Time Unit: h, Value: loss, History: Relative_Volume_Loss}
struct Fit {
  std::string fileName, name;
  std::vector<FitValue> values;
  std::vector<FitRun> runs;
  std::vector<FitSeries> series;
  std::vector<FittedDeck> decks;
  double tolerance = 0.0, differenceStep = 0.0;
  bool isCentral = false;
  int nIterations = 0, nProcesses = 0;  ///< processes: 0 for as many as there are cores

  std::vector<double> start() const;
};

const ParameterDeclarations& fitDeclarations();        ///< but for its Values, Overrides and Series
const ParameterDeclarations& fitValueDeclarations();   ///< an entry of Values
const ParameterDeclarations& fitSeriesDeclarations();  ///< an entry of Series
const ParameterDeclarations& fitSeriesKeys();          ///< without Overrides, which hold deck paths

/// Reads the fit and its data, with `overrides` (path=value) added to each run, and adds all mistakes of the files;
/// what they leave of the fit can be checked further. What histories are measured in is known once the runs have been
/// checked. Throws DeckError where the file is no YAML.
Fit readFit(const std::string& fileName, const std::vector<std::string>& overrides, Mistakes& mistakes);

}  // namespace pd

#endif
