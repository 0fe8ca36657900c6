// What a run is made of, as far as its deck and its mesh say it: the same for a run and for a check.
#ifndef PD_RUN_SETUP_HPP
#define PD_RUN_SETUP_HPP

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "error_norms.hpp"
#include "restart.hpp"
#include "simulation.hpp"
#include "stage.hpp"

namespace pd {

/// A run that goes on.
struct Resumed {
  Restart restart;
  std::size_t stage;  ///< that goes on, or begins
};

struct RunSetup {
  /// Reads the mesh, makes all plug-ins and allocates their fields. Throws DeckError. Collective.
  RunSetup(const Deck& deck, const Communicator& comm, std::unique_ptr<Output> output);

  Simulation simulation() { return {*model, *conditions, *output}; }
  /// Initial conditions, and what plug-ins make of them.
  void initialize();
  /// Prescribed values of the start: the state from which the first solver goes on. Throws RunError where a value is
  /// not finite.
  void start();
  /// In place of start(): the state of a checkpoint. `resolvedDeck`: text of this deck. Throws RunError where the run
  /// cannot go on from it.
  Resumed resume(const std::string& checkpoint, const std::string& resolvedDeck);

  std::unique_ptr<Model> model;
  std::vector<Stage> stages;
  std::unique_ptr<BoundaryConditions> conditions;
  std::unique_ptr<Output> output;
  std::unique_ptr<ErrorNorms> errorNorms;
  std::set<std::string> ofPlugins, ofConditions;  ///< labels of fields that these alone brought
  std::vector<std::string> advancedFields;        ///< that solvers may advance: those that must stay finite
};

/// For output and computes that ask for the fields; solvers keep times and forces of their own.
void fillHostFields(Model& model, const BoundaryConditions& conditions, double t);

/// Goes as far as a run does before its first step, or its first from the time of a checkpoint where one is given, and
/// writes nothing. Returns what the log of a run that goes on would begin with. Throws DeckError with what a run would
/// refuse until then. The deck has been checked by itself. Collective.
std::vector<std::string> rehearse(const Deck& deck, const Communicator& comm, const std::string& checkpoint = "");

}  // namespace pd

#endif
