#include "stage.hpp"

#include "../solvers/event_solver.hpp"
#include "solver_sections.hpp"

namespace pd {

namespace {

Stage createStage(const DeckNode& section) {
  Stage stage;
  stage.section = section.path();
  stage.startTime = section.real("Initial Time", 0.0);
  stage.endTime = section.real("Final Time", 1.0);
  for (const auto& [name, node] : section.entries()) {
    const auto* plugin = SolverRegistry::self().find(name);
    if (plugin == nullptr) continue;
    stage.name = name;
    stage.place = node.keyPlace() + ": " + node.path();
    stage.solver = plugin->create(node.parameters(plugin->declare()));
    return stage;
  }
  throw DeckError(section.keyPlace() + ": this section names no solver (one of " +
                  quotedList(SolverRegistry::self().names()) + ")");
}

}  // namespace

std::vector<Stage> createStages(const Deck& deck) {
  std::vector<Stage> stages;
  Mistakes mistakes;
  for (const DeckNode& section : solverSections(deck)) {
    try {
      stages.push_back(createStage(section));
    } catch (const DeckError& error) {
      mistakes.add("", error.what());
    } catch (const std::invalid_argument& error) {
      mistakes.add(section.keyPlace(), error.what());
    }
  }
  if (stages.empty() && mistakes.empty()) mistakes.add(deck.fileName(), "the deck has no section Solver");
  mistakes.report();
  return stages;
}

std::string timeUnitOf(const std::vector<Stage>& stages) { return timeUnitOf(*stages.front().solver); }

}  // namespace pd
