// Decks with fitted values. Private to this folder.
#ifndef PD_FITTED_DECK_HPP
#define PD_FITTED_DECK_HPP

#include <string>
#include <vector>

#include "fit_file.hpp"

namespace pd {

/// Files that a deck names, and the deck itself. Those that are not there are left out.
std::vector<std::string> filesOf(const std::string& deckFile, const std::vector<StudyOverride>& overrides);

/// A whole deck, with all defaults, as it is written to `path`: files that it names are found from there, too.
/// `values`: those of the fit; `outputName`: of the results of its runs.
std::string fittedDeck(const Fit& fit, const FittedDeck& deck, const std::vector<double>& values,
                       const std::string& path, const std::string& outputName);

}  // namespace pd

#endif
