#include "simulation.hpp"

#include <fmt/format.h>

#include <optional>

#include "../deck/sections.hpp"
#include "../deck/symmetry_planes.hpp"
#include "../solvers/event_solver.hpp"
#include "Peridigm_Field.hpp"
#include "collective.hpp"
#include "run_setup.hpp"

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

void logModel(Model& model, Output& output, const Deck& deck) {
  const Communicator& comm = model.comm();
  const Discretization& mesh = model.discretization();
  const long long nBonds = comm.sum(model.nBonds());
  output.log(fmt::format(
      "{}: {} points in {} dimension(s), {} directed bonds ({:.1f} a point), {} block(s), {} rank(s)", deck.fileName(),
      mesh.nGlobal, mesh.dimension, nBonds, static_cast<double>(nBonds) / static_cast<double>(mesh.nGlobal),
      model.blocks()->size(), comm.size()));
  const kernels::Rings rings = ringsOf(deck);
  if (rings.areUsed()) output.log("body of revolution: points are rings; totals are of the whole body about the axis");
  // Copies on the other side of an axis are the same rings.
  int nParts = 0;
  for (int copy = 0; copy < mesh.symmetry.nCopies(); ++copy)
    nParts += rings.areUsed() && mesh.symmetry.matrix(copy)[4 * rings.radial()] < 0.0 ? 0 : 1;
  if (nParts > 1)
    output.log(fmt::format("planes of symmetry: the mesh is one of {} equal parts of the body; totals are of this part",
                           nParts));
  if (mesh.isDecomposed) output.log(mesh.decompositionNote);
  for (const std::string& warning : deck.warnings().lines()) output.log("warning: " + warning);
}

/// The loop over all stages and their increments.
class Run {
 public:
  /// `deck`: text of the resolved deck, for checkpoints.
  Run(RunSetup& setup, const Communicator& comm, std::string deck)
      : simulation_(setup.simulation()),
        stages_(setup.stages),
        labels_(setup.advancedFields),
        comm_(comm),
        deck_(std::move(deck)) {}

  /// From the initial state, or from `restart` (fields already filled) in the stage `first`. Returns the time at the
  /// end of the last increment: increments need not meet the Final Time.
  double execute(const Restart* restart, std::size_t first) {
    for (std::size_t s = 0; s < stages_.size(); ++s) {
      if (s > 0) simulation_.output.startSolver();
      if (s < first) continue;
      Stage& stage = stages_[s];
      const bool isRestarted = restart != nullptr && s == first;
      int nSteps = 0, done = 0;
      double start = stage.startTime;
      orAbortUnlessShared([&] {
        initialize(stage);
        if (isRestarted) restart->setState(*stage.solver);
        // After the state is set: a solver that chooses its increments must choose the same again.
        nSteps = stage.solver->numberOfIncrements(simulation_, stage.startTime, stage.endTime);
        if (isRestarted) {
          done = restart->incrementsDone(stage, nSteps, s + 1 == stages_.size());
          firstStep_ = restart->step() - done;
          start = restart->startTime(stage);
        }
      });
      lastStage_ = s;
      time_ = advance(s, start, done, nSteps);
      if (isOver_) break;
      firstStep_ += nSteps;
    }
    return time_;
  }

  /// The last one that has run: a solver may have found that nothing is left to do.
  std::size_t lastStage() const { return lastStage_; }

 private:
  /// A solver that refuses the run does not know where it is in the deck.
  void initialize(Stage& stage) {
    try {
      stage.solver->initialize(simulation_);
    } catch (const RunError& error) {
      throw RunError(stage.place + ": " + error.what());
    }
  }

  /// The increments of a stage after the first `done`, from time `start`. Returns the time at their end. An increment
  /// that ends early with an event is a step of its own, and the rest of it another.
  double advance(std::size_t stageNumber, double start, int done, int nSteps) {
    Model& model = simulation_.model;
    Stage& stage = stages_[stageNumber];
    auto* events = dynamic_cast<EventSolver*>(stage.solver.get());
    for (int increment = done + 1; increment <= nSteps && !isOver_; ++increment) {
      const int step = firstStep_ + increment;
      const double planned = stage.solver->incrementEnd(increment, nSteps, stage.startTime, stage.endTime);
      double end = planned;
      orAbortUnlessShared([&] {
        try {
          if (events != nullptr)
            end = events->advanceToEvent(simulation_, start, planned);
          else
            stage.solver->advance(simulation_, start, planned - start);
        } catch (const RunError&) {
          requireFinite(step);  // a solver that met a value that is no number knows neither its place nor the step
          throw;
        }
      });
      requireFinite(step);
      if (events != nullptr && !events->reasonToStop().empty()) {
        isOver_ = true;
        simulation_.output.log(stage.name + ": " + events->reasonToStop() + "; the run ends");
      } else if (end < planned) {
        --increment;
        ++firstStep_;
      }
      const bool isLast = isOver_ || (stageNumber + 1 == stages_.size() && increment == nSteps);
      if (events != nullptr && !events->fieldsAreComplete() &&
          (isOver_ || increment == nSteps || simulation_.output.needsDisplacements(model, step, isLast)))
        orAbortUnlessShared([&] { events->completeFields(simulation_, end); });
      fillHostFields(model, simulation_.conditions, end);
      simulation_.output.write(model, step, firstStep_ + nSteps, end, isLast);
      if (simulation_.output.isCheckpointDue(step, isLast)) {
        simulation_.output.checkpoint(model, {step, end, stage.name, stage.solver->restartState(), deck_, {}}, isLast);
        stage.solver->checkpointWritten();
      }
      simulation_.output.progress(step, firstStep_ + nSteps, end, stage.name);
      start = end;
    }
    return start;
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
      abortRun(comm_, whatOf(error));
    }
  }

  Simulation simulation_;
  std::vector<Stage>& stages_;
  const std::vector<std::string>& labels_;  ///< of fields that must stay finite
  const Communicator& comm_;
  std::string deck_;
  int firstStep_ = 0;    ///< increments of the stages before, and early ends of increments
  bool isOver_ = false;  ///< a solver has found that nothing is left to do
  double time_ = 0.0;
  std::size_t lastStage_ = 0;
};

}  // namespace

void Simulation::beginStep() {
  model.beginStep();
  conditions.beginStep();
}

void Simulation::beginStep(const std::vector<int>& points) {
  model.beginStep(points);
  conditions.beginStep();
}

void Simulation::takeBackStep() {
  model.takeBackStep();
  conditions.takeBackStep();
}

void runDeck(const RunOptions& options, const Communicator& comm) {
  const Deck deck = readCheckedDeck(options, comm);
  auto claimed = std::make_unique<Output>(deck, comm, options.isQuiet, options.outputFolder);
  claimed->claim();
  RunSetup setup(deck, comm, std::move(claimed));
  Model& model = *setup.model;
  Output& output = *setup.output;
  const std::string resolved = resolvedDeck(deck);
  logModel(model, output, deck);
  for (const std::string& note : setup.conditions->notes()) output.log(note);

  setup.initialize();
  const std::vector<std::string> notes = model.notes();
  for (const std::string& note : notes) output.log(note);
  output.setTimeUnit(timeUnitOf(setup.stages));
  std::optional<Resumed> resumed;
  if (options.restartFile.empty()) {
    setup.start();
    output.begin(0, resolved);
    output.write(model, 0, 0, setup.stages.front().startTime, false);
  } else {
    resumed.emplace(setup.resume(options.restartFile, resolved));
    for (const std::string& note : resumed->restart.notes()) output.log(note);
    output.begin(resumed->restart.step() + 1, resolved);
  }

  Run run(setup, comm, resolved);
  const double end = run.execute(resumed ? &resumed->restart : nullptr, resumed ? resumed->stage : 0);

  std::vector<std::string> summary = notes;
  if (resumed) summary.push_back(resumed->restart.whatCounts());
  for (std::size_t s = resumed ? resumed->stage : 0; s <= run.lastStage(); ++s)
    for (const std::string& line : setup.stages[s].solver->summary()) summary.push_back(line);
  output.report(model, summary, setup.errorNorms->evaluate(end));
}

}  // namespace pd
