// In what two decks differ.
#ifndef PD_DECK_DIFFERENCES_HPP
#define PD_DECK_DIFFERENCES_HPP

#include <string>
#include <vector>

namespace pd {

struct DeckDifference {
  std::string path;         ///< "Materials/Steel/Density"
  std::string now, before;  ///< values; "nothing" where there is none, "a section" where there are keys
  /// Whether it is about the body and what acts on it, and not about times, solvers and output alone.
  bool isOfModel = true;
};

/// The entries in which two resolved decks (resolvedDeck()) differ, in the order of `now`, then those that only
/// `before` has. Throws std::runtime_error where a text is no YAML.
std::vector<DeckDifference> deckDifferences(const std::string& now, const std::string& before);

}  // namespace pd

#endif
