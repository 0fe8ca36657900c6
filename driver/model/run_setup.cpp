#include "run_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <sstream>

#include "../deck/sections.hpp"
#include "../discretization/discretization.hpp"
#include "collective.hpp"
#include "rates.hpp"

namespace pd {

namespace {

std::vector<std::string> fieldsThatAdvance(const Model& model) {
  std::vector<std::string> labels = fieldsWithRates(*model.blocks());
  for (const char* label : {"Displacement", "Velocity", "Damage"})
    if (model.hasField(label)) labels.emplace_back(label);
  return labels;
}

}  // namespace

RunSetup::RunSetup(const Deck& deck, const Communicator& comm, std::unique_ptr<Output> givenOutput)
    : output(std::move(givenOutput)) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Discretization discretization;
  withMemoryFor(comm, "the mesh and its neighbourhoods", [&] { discretization = readDiscretization(deck, comm); });
  const double readingTime = std::chrono::duration<double>(Clock::now() - start).count();
  withMemoryFor(comm,
                fmt::format("the fields of {} points and {} bonds of rank {}", discretization.nPoints,
                            discretization.nBonds(), comm.rank()),
                [&] { model = std::make_unique<Model>(deck, comm, std::move(discretization), std::vector<int>()); });
  model->timers().add("mesh and neighborhoods", readingTime);
  stages = createStages(deck);
  ofPlugins = fieldLabels(*model);
  for (const Stage& stage : stages) model->allocateFields(stage.solver->fields().ids());
  const std::set<std::string> ofSolvers = fieldLabels(*model);
  conditions = std::make_unique<BoundaryConditions>(deck, *model);
  for (const std::string& label : fieldLabels(*model))
    if (ofSolvers.count(label) == 0) ofConditions.insert(label);
  model->allocateFields(output->fieldIds());
  output->initialize(*model);
  errorNorms = std::make_unique<ErrorNorms>(deck, *model);
  advancedFields = fieldsThatAdvance(*model);
}

void RunSetup::initialize() {
  conditions->applyInitial();
  model->initialize();
}

void RunSetup::start() {
  const double t = stages.front().startTime;
  conditions->applyPrescribed(t);
  for (const std::string& label : advancedFields) model->requireFinite(label, 0);
  if (model->hasMechanics()) model->updateCoordinates();
  fillHostFields(*model, *conditions, t);
  model->adoptState();
}

Resumed RunSetup::resume(const std::string& checkpoint, const std::string& resolvedDeck) {
  Restart restart(*model, checkpoint, resolvedDeck, timeUnitOf(stages));
  const std::size_t stage = restart.findStage(stages, ofPlugins, ofConditions);
  try {
    for (const std::string& label : advancedFields) model->requireFinite(label, restart.step());
  } catch (const RunError& error) {
    throw RunError(fmt::format("\"{}\" is damaged: {}", checkpoint, error.what()));
  }
  conditions->resume(restart.time());
  model->adoptState();
  return {std::move(restart), stage};
}

void fillHostFields(Model& model, const BoundaryConditions& conditions, double t) {
  if (model.hasField("Time")) *model.field("Time") = t;
  const char* const label = "External_Force_Density";
  if (!model.hasField(label)) return;
  double* force = model.field(label);
  std::fill(force, force + 3 * static_cast<std::size_t>(model.nOwned()), 0.0);
  conditions.addExternalForce(t, force);
}

namespace {

/// Does a part of the start of a run; where it cannot be done, each line of why goes to `mistakes`, with `what` before
/// it. Returns whether it was done.
template <class Work>
bool rehearsePart(const std::string& what, Mistakes& mistakes, const Work& work) {
  std::string trouble, prefix;
  try {
    work();
    return true;
  } catch (const DeckError& error) {  // which names its place
    trouble = error.what();
  } catch (const RunError& error) {
    trouble = error.what();
    prefix = what + ": ";
  }
  std::istringstream lines(trouble);
  for (std::string line; std::getline(lines, line);) mistakes.add("", prefix + line);
  return false;
}

}  // namespace

std::vector<std::string> rehearse(const Deck& deck, const Communicator& comm, const std::string& checkpoint) {
  RunSetup setup(deck, comm, std::make_unique<Output>(deck, comm, true));
  const std::string ofRun = deck.fileName() + ": the start of the run";
  Mistakes mistakes;
  std::optional<Resumed> resumed;
  rehearsePart(ofRun, mistakes, [&] {
    setup.initialize();
    if (checkpoint.empty())
      setup.start();
    else
      resumed.emplace(setup.resume(checkpoint, resolvedDeck(deck)));
  });
  mistakes.report();
  const auto evaluate = [&] { setup.output->evaluate(*setup.model, 0); };
  const bool isMeasured = rehearsePart(ofRun, mistakes, evaluate);
  const std::size_t s = resumed ? resumed->stage : 0;
  const Stage& first = setup.stages[s];
  Simulation simulation = setup.simulation();
  const double start = resumed ? resumed->restart.startTime(first) : first.startTime;
  double end = start;
  const bool isReady = rehearsePart(first.place, mistakes, [&] {
    first.solver->initialize(simulation);
    if (resumed) resumed->restart.setState(*first.solver);
    const int n = first.solver->numberOfIncrements(simulation, first.startTime, first.endTime);
    const int done = resumed ? resumed->restart.incrementsDone(first, n, s + 1 == setup.stages.size()) : 0;
    if (n > done) end = first.solver->incrementEnd(done + 1, n, first.startTime, first.endTime);
  });
  // A solver may have told them more, as which points are fluid.
  if (isReady && isMeasured) rehearsePart(ofRun, mistakes, evaluate);
  for (const std::string& warning : setup.output->warnings()) deck.warnings().add("", warning);
  if (isReady && end > start)
    rehearsePart(first.place, mistakes, [&] { first.solver->rehearse(simulation, start, end - start); });
  // Later solvers start from what the first one makes: what they refuse of the model alone is known.
  for (std::size_t k = s + 1; isReady && k < setup.stages.size(); ++k)
    rehearsePart(setup.stages[k].place, mistakes, [&] { setup.stages[k].solver->initialize(simulation); });
  mistakes.report();
  return resumed ? resumed->restart.notes() : std::vector<std::string>();
}

}  // namespace pd
