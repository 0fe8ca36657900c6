#include "check_deck.hpp"

#include "sections.hpp"

namespace pd {

std::vector<const CheckedSection*> DeckUnderCheck::ofKind(DeckSection::Kind kind) const {
  std::vector<const CheckedSection*> result;
  for (const CheckedSection& checked : sections)
    if (checked.section.kind == kind) result.push_back(&checked);
  return result;
}

bool hasNone(const DeckNode& block) {
  const DeckNode name = block["Damage Model"];
  return !name || (name.isScalar() && name.text() == "None");
}

bool DeckUnderCheck::hasDamageModel() const {
  for (const CheckedSection* block : ofKind(DeckSection::Kind::Block)) {
    if (!block->section.node["Damage Model"].each().empty() && !hasNone(block->section.node)) return true;
  }
  return false;
}

DeckUnderCheck readSections(const Deck& deck) {
  DeckUnderCheck check{deck, {}};
  Mistakes& mistakes = deck.mistakes();
  for (DeckSection& section : findSections(deck)) {
    const std::size_t before = mistakes.lines().size();
    CheckedSection checked;
    checked.list = readParameters(section.node, section.declarations, mistakes, section.hostKeys,
                                  deck.isLenient() ? &deck.warnings() : nullptr);
    checked.isGood = mistakes.lines().size() == before;
    checked.section = std::move(section);
    check.sections.push_back(std::move(checked));
  }
  return check;
}

void checkDeck(const Deck& deck) {
  const DeckUnderCheck check = readSections(deck);
  checkReferences(check);
  checkCombinations(check);
  checkPluginsAndFields(check);
  deck.mistakes().sort(deck.fileName());
  deck.warnings().sort(deck.fileName());
}

}  // namespace pd
