// The solver sections of a deck.
#ifndef PD_SOLVER_SECTIONS_HPP
#define PD_SOLVER_SECTIONS_HPP

#include <vector>

#include "../deck/deck.hpp"

namespace pd {

/// Every root list whose name contains "Solver", in the order of the file; they run one after another.
std::vector<DeckNode> solverSections(const Deck& deck);

/// "Initial Time" of the first of them, s.
double initialTime(const Deck& deck);
/// "Final Time" of the last of them, s.
double finalTime(const Deck& deck);

}  // namespace pd

#endif
