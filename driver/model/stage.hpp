// The stages of a run: one for each Solver section of the deck.
#ifndef PD_STAGE_HPP
#define PD_STAGE_HPP

#include <Teuchos_RCP.hpp>
#include <string>
#include <vector>

#include "../deck/deck.hpp"
#include "../solvers/solver.hpp"

namespace pd {

struct Stage {
  std::string section;  ///< its key in the deck
  std::string name;     ///< of the solver
  std::string place;    ///< where it is in the deck, for messages
  Teuchos::RCP<Solver> solver;
  double startTime = 0.0, endTime = 1.0;  ///< s
};

/// Throws DeckError with all mistakes.
std::vector<Stage> createStages(const Deck& deck);

/// What the times of a run are counted in, as its first solver has it: s, or cycles.
std::string timeUnitOf(const std::vector<Stage>& stages);

}  // namespace pd

#endif
