#include "solver_sections.hpp"

#include "../deck/sections.hpp"

namespace pd {

std::vector<DeckNode> solverSections(const Deck& deck) {
  std::vector<DeckNode> sections;
  for (const auto& [name, node] : deck.root().entries())
    if (isSectionOf(deck, name, "Solver") && node.isMap()) sections.push_back(node);
  return sections;
}

double initialTime(const Deck& deck) {
  const std::vector<DeckNode> sections = solverSections(deck);
  return sections.empty() ? 0.0 : sections.front().real("Initial Time", 0.0);
}

double finalTime(const Deck& deck) {
  const std::vector<DeckNode> sections = solverSections(deck);
  return sections.empty() ? 1.0 : sections.back().real("Final Time", 1.0);
}

}  // namespace pd
