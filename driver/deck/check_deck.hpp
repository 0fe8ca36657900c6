// The checks of a deck that go beyond one section. Private to this folder.
#ifndef PD_CHECK_DECK_HPP
#define PD_CHECK_DECK_HPP

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

#include "section_walk.hpp"

namespace pd {

struct CheckedSection {
  DeckSection section;
  Teuchos::ParameterList list;  ///< with defaults
  bool isGood = false;          ///< no mistake so far
};

/// A deck with its sections read.
struct DeckUnderCheck {
  const Deck& deck;
  std::vector<CheckedSection> sections;

  std::vector<const CheckedSection*> ofKind(DeckSection::Kind kind) const;
  bool hasDamageModel() const;  ///< whether any block has one
};

template <class Value>
Value valueOr(const Teuchos::ParameterList& list, const std::string& name, Value fallback) {
  return list.isParameter(name) ? list.get<Value>(name) : fallback;
}

/// Whether an entry of Blocks has no damage model.
bool hasNone(const DeckNode& block);

/// Reads all sections; mistakes go to deck.mistakes().
DeckUnderCheck readSections(const Deck& deck);

/// Names that refer to something: materials, damage models, blocks, node sets, files.
void checkReferences(const DeckUnderCheck& check);
/// Values that must fit each other: times, steps, boxes, directions, thicknesses.
void checkCombinations(const DeckUnderCheck& check);
/// Makes the plug-ins and checks the names of fields against theirs.
void checkPluginsAndFields(const DeckUnderCheck& check);

}  // namespace pd

#endif
