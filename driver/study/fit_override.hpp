// Overrides of a fit, as text with names in braces. Private to this folder.
#ifndef PD_FIT_OVERRIDE_HPP
#define PD_FIT_OVERRIDE_HPP

#include <map>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "fit_file.hpp"

namespace pd {

/// Names that may stand in braces.
struct FitNames {
  std::vector<std::string> values;             ///< of fitted values
  std::map<std::string, std::string> columns;  ///< of a row of data, with its cells
};

/// Reads `path: text`; adds a mistake for names in braces that nothing has.
FitOverride readFitOverride(const std::string& path, const DeckNode& node, const FitNames& names, Mistakes& mistakes);

}  // namespace pd

#endif
