// What decks of Peridigm may hold and decks of our own do not. Private to this folder.
#ifndef PD_PERIDIGM_DECK_HPP
#define PD_PERIDIGM_DECK_HPP

#include <string>
#include <vector>

#include "deck_data.hpp"

namespace pd {

/// Brings the tree of a deck of Peridigm into our own form: keys without a meaning here are taken out with a warning
/// that says so, those whose effect is missing here become mistakes that say what to do instead, and what has another
/// name here is renamed. Keys that Peridigm does not know either are left for the checks.
void translatePeridigmDeck(DeckNode::Data& root, Mistakes& mistakes, Mistakes& warnings);

/// Fields and computes that Peridigm may write and that nothing here provides.
const std::vector<std::string>& fieldsOfPeridigmAlone();

}  // namespace pd

#endif
