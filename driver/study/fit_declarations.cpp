// What a file of a fit may hold.
#include "fit_file.hpp"

namespace pd {

namespace {

ParameterDeclarations declareFit() {
  ParameterDeclarations declare;
  declare.text("Deck", "The deck that is run, seen from the folder of the fit.").required();
  declare.text("Name", "Of the results (default: the name of the file).");
  declare
      .real("Tolerance", "1",
            "The fit ends where a step changes the sum of squares, or the values, by less than this share.")
      .strictlyBetween(0.0, 1.0)
      .defaultTo(1e-4);
  declare
      .real("Difference Step", "1",
            "Step of the differences that derivatives are taken by: a share of Start (of the range between Lowest and "
            "Highest where Start is 0), of the value itself where that is Logarithmic. Larger than what the tolerances "
            "of the runs do to their histories.")
      .strictlyBetween(0.0, 1.0)
      .defaultTo(0.01);
  declare.text("Differences", "Forward take one run a value and deck, Central two, with an error of higher order.")
      .oneOf({"Forward", "Central"})
      .defaultTo("Forward");
  declare.integer("Maximum Iterations", "Steps after which the fit gives up.").positive().defaultTo(30);
  declare.integer("Processes", "Runs that go on side by side, each on one rank (default: as many as there are cores).")
      .positive();
  return declare;
}

ParameterDeclarations declareValue() {
  ParameterDeclarations declare;
  declare.real("Start", "1", "The value that the fit begins with, in Unit.").required();
  declare.real("Lowest", "1", "The value stays above this, in Unit (default: no bound).");
  declare.real("Highest", "1", "The value stays below this, in Unit (default: no bound).");
  declare.text(
      "Unit", "Of these numbers and of the results, such as h or A/m^2 (default: that of the key in which it stands).");
  declare
      .flag(
          "Logarithmic",
          "Steps go by factors, for values above zero whose power of ten is in doubt; their intervals are factors too.")
      .defaultTo(false);
  return declare;
}

ParameterDeclarations declareFitSeriesKeys() {
  ParameterDeclarations declare;
  declare.text("Label", "Name of the series in table and picture.").required();
  declare.text("Deck", "The deck of this series, where it is another one.");
  declare.text("Data", "File of the measured series, seen from the folder of the fit: CSV with a line of names.")
      .required();
  declare.text("Value", "Column of the measured values.").required();
  declare.text("Unit", "Of the measured values (default: that of the history).");
  declare.text("Deviation",
               "Standard deviation of the values: a column, or one number for all, in Unit (of ln(value) where the "
               "series is Logarithmic). Where no series has one, all points weigh the same.");
  declare.text("History", "What the runs write that the values are compared with: a column of their CSV files.")
      .required();
  declare.text("Time", "Column of the times: one run, whose history is compared at these times, linear in between.");
  declare.text("Time Unit", "Of that column (default: that of the run, s or cycles).");
  declare.text("History Value", "What each run, one a row, comes to: of its history.").oneOf(HistoryValue::names());
  declare.real("From", "s", "Rows before this time are compared, but not fitted.");
  declare.real("Until", "s", "Rows after this time are compared, but not fitted.");
  declare.flag("Logarithmic", "Logarithms are compared: of lives, or other values over decades.").defaultTo(false);
  declare.exactlyOneOf({"Time", "History Value"});
  for (const char* key : {"Time Unit", "From", "Until"}) declare.needs(key, {"Time"});
  return declare;
}

ParameterDeclarations declareFitSeries() {
  ParameterDeclarations declare = declareFitSeriesKeys();
  declare.sublist("Overrides",
                  "Paths of the deck that this series has of its own; with History Value, names of columns in braces "
                  "stand for the cell of the row, a run each.");
  return declare;
}

}  // namespace

const ParameterDeclarations& fitDeclarations() {
  static const ParameterDeclarations declarations = declareFit();
  return declarations;
}

const ParameterDeclarations& fitValueDeclarations() {
  static const ParameterDeclarations declarations = declareValue();
  return declarations;
}

const ParameterDeclarations& fitSeriesKeys() {
  static const ParameterDeclarations declarations = declareFitSeriesKeys();
  return declarations;
}

const ParameterDeclarations& fitSeriesDeclarations() {
  static const ParameterDeclarations declarations = declareFitSeries();
  return declarations;
}

}  // namespace pd
