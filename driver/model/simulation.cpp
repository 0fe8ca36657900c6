#include "simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <optional>
#include <set>

#include "../deck/sections.hpp"
#include "../output/output_section.hpp"
#include "Peridigm_Field.hpp"
#include "collective.hpp"
#include "error_norms.hpp"
#include "rates.hpp"
#include "restart.hpp"
#include "stage.hpp"

namespace pd {

namespace {

Deck readCheckedDeck(const RunOptions& options, const Communicator& comm) {
  std::optional<Deck> deck;
  collectively(comm, [&] {
    deck = Deck::read(options.deckFile, options.overrides, options.unknownKeys);
    checkDeck(*deck);
    deck->mistakes().report();
  });
  return *deck;
}

/// Fields that a solver may advance: those that must stay finite.
std::vector<std::string> advancedFields(const Model& model) {
  std::vector<std::string> labels = fieldsWithRates(*model.blocks());
  for (const char* label : {"Displacement", "Velocity", "Damage"})
    if (model.hasField(label)) labels.emplace_back(label);
  return labels;
}

void logModel(Model& model, Output& output, const Deck& deck) {
  const Communicator& comm = model.comm();
  const Discretization& mesh = model.discretization();
  const long long nBonds = comm.sum(model.nBonds());
  output.log(fmt::format(
      "{}: {} points in {} dimension(s), {} directed bonds ({:.1f} a point), {} block(s), {} rank(s)", deck.fileName(),
      mesh.nGlobal, mesh.dimension, nBonds, static_cast<double>(nBonds) / static_cast<double>(mesh.nGlobal),
      model.blocks()->size(), comm.size()));
  if (!mesh.symmetry.empty())
    output.log(fmt::format("planes of symmetry: the mesh is one of {} equal parts of the body; totals are of this part",
                           mesh.symmetry.nCopies()));
  for (const std::string& warning : deck.warnings().lines()) output.log("warning: " + warning);
}

void writeResolvedDeck(const Deck& deck, const std::string& resolved, const Communicator& comm) {
  collectively(comm, [&] {
    if (!comm.isRoot()) return;
    const std::string fileName = mainOutputName(deck, readOutputSections(deck)) + ".resolved.yaml";
    std::ofstream file(fileName);
    file << resolved << std::flush;
    if (!file) throw RunError(fileName + ": cannot be written");
  });
}

/// For output and computes that ask for the fields; solvers keep times and forces of their own.
void fillHostFields(Model& model, const BoundaryConditions& conditions, double t) {
  if (model.hasField("Time")) *model.field("Time") = t;
  const char* const label = "External_Force_Density";
  if (!model.hasField(label)) return;
  double* force = model.field(label);
  std::fill(force, force + 3 * static_cast<std::size_t>(model.nOwned()), 0.0);
  conditions.addExternalForce(t, force);
}

/// The loop over all stages and their increments.
class Run {
 public:
  /// `deck`: text of the resolved deck, for checkpoints.
  Run(Simulation simulation, std::vector<Stage>& stages, const Communicator& comm, std::string deck)
      : simulation_(simulation),
        stages_(stages),
        comm_(comm),
        deck_(std::move(deck)),
        labels_(advancedFields(simulation.model)) {}

  /// From the initial state, or from `restart` (fields already filled) in the stage `first`.
  void execute(const Restart* restart, std::size_t first) {
    for (std::size_t s = 0; s < stages_.size(); ++s) {
      if (s > 0) simulation_.output.startSolver();
      if (s < first) continue;
      Stage& stage = stages_[s];
      const bool isRestarted = restart != nullptr && s == first;
      int nSteps = 0, done = 0;
      double start = stage.startTime;
      orAbortUnlessShared([&] {
        stage.solver->initialize(simulation_);
        if (isRestarted) restart->setState(*stage.solver);
        // After the state is set: a solver that chooses its increments must choose the same again.
        nSteps = stage.solver->numberOfIncrements(simulation_, stage.startTime, stage.endTime);
        if (isRestarted) {
          done = restart->incrementsDone(stage, nSteps, s + 1 == stages_.size());
          firstStep_ = restart->step() - done;
          start = restart->startTime(stage);
        }
      });
      advance(s, start, done, nSteps);
      firstStep_ += nSteps;
    }
  }

 private:
  /// The increments of a stage after the first `done`, from time `start`.
  void advance(std::size_t stageNumber, double start, int done, int nSteps) {
    Model& model = simulation_.model;
    Stage& stage = stages_[stageNumber];
    for (int increment = done + 1; increment <= nSteps; ++increment) {
      const int step = firstStep_ + increment;
      const double end = stage.solver->incrementEnd(increment, nSteps, stage.startTime, stage.endTime);
      orAbortUnlessShared([&] {
        try {
          stage.solver->advance(simulation_, start, end - start);
        } catch (const RunError&) {
          requireFinite(step);  // a solver that met a value that is no number knows neither its place nor the step
          throw;
        }
      });
      requireFinite(step);
      fillHostFields(model, simulation_.conditions, end);
      const bool isLast = stageNumber + 1 == stages_.size() && increment == nSteps;
      simulation_.output.write(model, step, firstStep_ + nSteps, end, isLast);
      if (simulation_.output.isCheckpointDue(step, isLast))
        simulation_.output.checkpoint(model, {step, end, stage.name, stage.solver->restartState(), deck_, {}}, isLast);
      simulation_.output.progress(step, firstStep_ + nSteps, end, stage.name);
      start = end;
    }
  }

  void requireFinite(int step) const {
    for (const std::string& label : labels_) simulation_.model.requireFinite(label, step);
  }

  /// Solvers throw DeckError and RunError on all ranks alike; anything else may have happened on one rank alone.
  template <class Work>
  void orAbortUnlessShared(const Work& work) {
    try {
      work();
    } catch (const DeckError&) {
      throw;
    } catch (const RunError&) {
      throw;
    } catch (const std::exception& error) {
      abortRun(comm_, error.what());
    }
  }

  Simulation simulation_;
  std::vector<Stage>& stages_;
  const Communicator& comm_;
  std::string deck_;
  std::vector<std::string> labels_;
  int firstStep_ = 0;  ///< increments of the stages before
};

}  // namespace

void runDeck(const RunOptions& options, const Communicator& comm) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const Deck deck = readCheckedDeck(options, comm);
  Discretization discretization = readDiscretization(deck, comm);
  const double readingTime = std::chrono::duration<double>(Clock::now() - start).count();

  Model model(deck, comm, std::move(discretization), {});
  model.timers().add("mesh and neighborhoods", readingTime);
  std::vector<Stage> stages = createStages(deck);
  const std::set<std::string> ofPlugins = fieldLabels(model);
  for (const Stage& stage : stages) model.allocateFields(stage.solver->fields().ids());
  const std::set<std::string> ofSolvers = fieldLabels(model);
  BoundaryConditions conditions(deck, model);
  std::set<std::string> ofConditions;
  for (const std::string& label : fieldLabels(model))
    if (ofSolvers.count(label) == 0) ofConditions.insert(label);
  Output output(deck, comm, options.isQuiet, !options.restartFile.empty());
  model.allocateFields(output.fieldIds());
  output.initialize(model);
  const ErrorNorms errorNorms(deck, model);
  const std::string resolved = resolvedDeck(deck);
  writeResolvedDeck(deck, resolved, comm);
  logModel(model, output, deck);
  for (const std::string& note : conditions.notes()) output.log(note);

  conditions.applyInitial();
  model.initialize();
  const std::vector<std::string> notes = model.notes();
  for (const std::string& note : notes) output.log(note);
  std::optional<Restart> restart;
  std::size_t firstStage = 0;
  if (options.restartFile.empty()) {
    conditions.applyPrescribed(stages.front().startTime);
    for (const std::string& label : advancedFields(model)) model.requireFinite(label, 0);
    if (model.hasMechanics()) model.updateCoordinates();
    fillHostFields(model, conditions, stages.front().startTime);
    model.adoptState();
    output.write(model, 0, 0, stages.front().startTime, false);
  } else {
    restart.emplace(model, options.restartFile, resolved);
    firstStage = restart->findStage(stages, ofPlugins, ofConditions);
    conditions.resume(restart->time());
    model.adoptState();
    for (const std::string& note : restart->notes()) output.log(note);
  }

  Run(Simulation{model, conditions, output}, stages, comm, resolved).execute(restart ? &*restart : nullptr, firstStage);

  std::vector<std::string> summary = notes;
  for (const Stage& stage : stages)
    for (const std::string& line : stage.solver->summary()) summary.push_back(line);
  output.report(model, summary, errorNorms.evaluate(stages.back().endTime));
}

}  // namespace pd
