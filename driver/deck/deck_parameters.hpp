// A section of a deck against its declarations. Private to this folder.
#ifndef PD_DECK_PARAMETERS_HPP
#define PD_DECK_PARAMETERS_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "deck.hpp"

namespace pd {

/// Keys of a section that its declarations do not cover.
struct HostKeys {
  std::vector<std::string> known;     ///< may stand in the section; the caller looks at them
  std::vector<std::string> injected;  ///< the driver gives these: they are not missing
};

/// The section as a Teuchos list, converted to the declared types, defaults filled in. Functions given as tables are
/// left out. Adds every mistake with its place. Unknown keys are mistakes, or where `ignoredKeys` is given, go there
/// and are ignored from then on.
Teuchos::ParameterList readParameters(const DeckNode& section, const ParameterDeclarations& declarations,
                                      Mistakes& mistakes, const HostKeys& hostKeys = {},
                                      Mistakes* ignoredKeys = nullptr);

/// " in Blocks/Plate", or " at the top level".
std::string inSection(const DeckNode& section);

/// Adds the lines of `error`, which name their places.
void addAll(Mistakes& mistakes, const DeckError& error);

}  // namespace pd

#endif
