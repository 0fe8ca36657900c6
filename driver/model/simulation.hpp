// A run: the model with its conditions and outputs, and the loop over increments.
#ifndef PD_SIMULATION_HPP
#define PD_SIMULATION_HPP

#include <memory>
#include <string>
#include <vector>

#include "../boundary/boundary_conditions.hpp"
#include "../deck/deck.hpp"
#include "../output/output.hpp"
#include "model.hpp"

namespace pd {

/// What a solver may use.
struct Simulation {
  Model& model;
  BoundaryConditions& conditions;
  Output& output;

  // Steps that may be taken back (Model says more of them): fields, bonds, and what conditions keep.
  void beginStep();
  void beginStep(const std::vector<int>& points);
  void takeBackStep();
};

struct RunOptions {
  std::string deckFile;
  std::vector<std::string> overrides;  ///< "path=value"
  std::string restartFile;             ///< empty: from the start
  std::string outputFolder;            ///< results go below it; empty: the working folder
  bool isQuiet = false;
  UnknownKeys unknownKeys = UnknownKeys::AreMistakes;  ///< of decks of Peridigm
};

/// The straight line: read deck, check everything, build the discretization, allocate, solve, write. Collective.
/// Throws DeckError (exit code 2) or RunError (3).
void runDeck(const RunOptions& options, const Communicator& comm);

}  // namespace pd

#endif
