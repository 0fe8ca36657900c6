// Values of a deck as a study or a fit gives them. Private to this folder.
#ifndef PD_OVERRIDE_VALUES_HPP
#define PD_OVERRIDE_VALUES_HPP

#include <string>

#include "../deck/deck.hpp"
#include "study_file.hpp"

namespace pd {

/// `text` in double quotes, as YAML has it.
std::string quotedYaml(const std::string& text);
/// The value on one line, in YAML.
std::string flowYaml(const DeckNode& value);

/// Keys without a value are empty maps to a deck, and no value of an override.
bool isMissing(const DeckNode& value);

/// path=value of the command line; throws DeckError where it is no such text.
StudyOverride overrideOfCommandLine(const std::string& text);

/// Adds the mistakes of a file of `what` ("study", "fit"); those of the file as a whole lack a path that says where
/// they are.
void addOfRoot(const Mistakes& own, const Deck& file, const std::string& what, Mistakes& mistakes);

}  // namespace pd

#endif
