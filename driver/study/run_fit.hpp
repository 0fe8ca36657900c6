// Runs a fit: pdfit, a program in Python, steps to the values by SciPy's least squares and runs the decks.
#ifndef PD_RUN_FIT_HPP
#define PD_RUN_FIT_HPP

#include <string>

#include "fit_file.hpp"

namespace pd {

/// Throws DeckError where the results of the fit cannot be written below `folder`. Looks only.
void checkFitResults(const Fit& fit, const std::string& folder);

/// Hands the fit, which has been checked, to pdfit (beside the program or on the PATH), which prints the table of
/// iterations (unless quiet) and writes <name>.fit.csv, .fit.json, .fit.residuals.csv and .fit.png. Then writes each
/// deck with the fitted values, <name>.fitted.yaml or, of several, <name>.<deck>.fitted.yaml. Results go below `folder`
/// (empty: the working folder); those of an earlier fit of this name are removed first, but for the histories of its
/// runs, <name>.fit/: a run of the same deck, files, values and pdrun is not repeated. Throws RunError where another
/// process writes the same, or the fit cannot go on.
void runFit(const Fit& fit, const std::string& folder, bool isQuiet);

}  // namespace pd

#endif
