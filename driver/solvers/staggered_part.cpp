#include "staggered_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "Peridigm_Field.hpp"
#include "declarations.hpp"

namespace pd {

using PeridigmNS::FieldManager;
namespace PeridigmField = PeridigmNS::PeridigmField;

namespace {

/// Sets the time scale of conditions, and back to the run's.
class TimeScale {
 public:
  TimeScale(BoundaryConditions& conditions, double scale) : conditions_(conditions) { conditions_.setTimeScale(scale); }
  ~TimeScale() { conditions_.setTimeScale(1.0); }
  TimeScale(const TimeScale&) = delete;
  TimeScale& operator=(const TimeScale&) = delete;

 private:
  BoundaryConditions& conditions_;
};

/// The solvers that can be parts: all but the one that they are parts of.
std::vector<std::string> solverNames() {
  std::vector<std::string> names = SolverRegistry::self().names();
  names.erase(std::remove(names.begin(), names.end(), "Staggered"), names.end());
  return names;
}

std::size_t nOwnedValues(const Model& model, const std::string& label) {
  return static_cast<std::size_t>(model.fieldWidth(label)) * static_cast<std::size_t>(model.nOwned());
}

}  // namespace

const std::vector<std::string>& StaggeredPart::keysOfTheRun() {
  // Increments by Peridigm's critical step would not meet the end of a load step.
  static const std::vector<std::string> keys = {"Load Steps", "Number of Load Steps", "Time Steps", "Critical Step"};
  return keys;
}

void StaggeredPart::declareParameters(ParameterDeclarations& declare) {
  for (const std::string& name : solverNames()) {
    const auto* plugin = SolverRegistry::self().find(name);
    addDeclarations(declare.sublist(name, plugin->brief), plugin->declare(), keysOfTheRun());
  }
  declare.exactlyOneOf(solverNames());
  declare
      .integer("Sub Steps",
               "Equal increments in which the solver advances each time that it runs; by default as many as it chooses "
               "itself, one where it has no choice.")
      .atLeast(1);
  declare
      .integer(
          "Every",
          "The solver runs in load steps whose number is a multiple of this, and in the last one, over all the time "
          "since it last ran. With When, in load steps that either of them asks for.")
      .atLeast(1);
  ParameterDeclarations& when = declare.sublist(
      "When",
      "The solver runs in load steps that find a field changed, and in the last one, over all the time since it "
      "last ran.");
  when.text("Field", "The field of points that is looked at.").required();
  EnoughChange::declareParameters(when);
  when.text("Measure",
            "What counts of the change: the largest at any point, or its size integrated over the body: of Damage of "
            "dissolving metal the volume that has dissolved.")
      .oneOf({"Largest", "Volume"})
      .defaultTo("Largest");
  when.flag("At Start", "It runs in the first load step, too: others need what it finds, as a flow.").defaultTo(false);
  declare
      .real("Time Scale", "1", "Seconds of this solver in one second of the run. Conditions keep the time of the run.")
      .defaultTo(1.0)
      .positive();
}

StaggeredPart::StaggeredPart(std::string name, const std::string& solver, const Teuchos::ParameterList& parameters)
    : name_(std::move(name)), solverName_(solver), solver_(SolverRegistry::self().create(solver, parameters)) {}

StaggeredPart::StaggeredPart(std::string name, const Teuchos::ParameterList& entry) : name_(std::move(name)) {
  for (const std::string& solver : solverNames())
    if (entry.isSublist(solver)) {
      solverName_ = solver;
      solver_ = SolverRegistry::self().create(solver, entry.sublist(solver));
    }
  if (entry.isParameter("Sub Steps")) nSubSteps_ = entry.get<int>("Sub Steps");
  const bool hasWhen = entry.isSublist("When");
  every_ = entry.isParameter("Every") ? entry.get<int>("Every") : (hasWhen ? 0 : 1);
  timeScale_ = entry.get<double>("Time Scale");
  if (!hasWhen) return;
  watchedField_ = entry.sublist("When").get<std::string>("Field");
  enough_ = EnoughChange(entry.sublist("When"));
  runsAtStart_ = entry.sublist("When").get<bool>("At Start");
  isOfVolume_ = entry.sublist("When").get<std::string>("Measure") == "Volume";
}

std::string StaggeredPart::memoryField() const {
  std::string label = name_ + "_Last_" + watchedField_;
  std::replace(label.begin(), label.end(), ' ', '_');
  return label;
}

FieldTable StaggeredPart::fields() const {
  struct Fields : FieldTable {
    explicit Fields(const FieldTable& solver) { include(solver); }
    using FieldTable::reads;
    using FieldTable::writes;
  } fields(solver_->fields());
  if (watchedField_.empty() || !FieldManager::self().hasField(watchedField_)) return std::move(fields);
  const PeridigmNS::FieldSpec watched = FieldManager::self().getFieldSpec(watchedField_);
  FieldDescription field = pd::fields::pointScalar(watchedField_, "unit of the field", "What the part watches.");
  field.relation = watched.relation;
  field.length = watched.length;
  field.temporal = watched.temporal;
  fields.reads(field);
  FieldDescription memory = pd::fields::pointScalar(memoryField(), "unit of the field",
                                                    watchedField_ + " when the part " + name_ + " last ran.");
  memory.length = watched.length;
  fields.writes(memory.state());
  return std::move(fields);
}

double StaggeredPart::leastSteps(int nLoadSteps, double t0, double t1) const {
  const double nRuns = every_ > 0 ? std::ceil(static_cast<double>(nLoadSteps) / every_) : 1.0;
  const double share = (t1 - t0) / nRuns;
  const double start = timeScale_ * t0;
  return nRuns * std::max<double>(nSubSteps_, solver_->leastSteps(start, start + timeScale_ * share));
}

bool StaggeredPart::changesDamage() const {
  const std::vector<FieldUse>& uses = solver_->fields().uses();
  return std::any_of(uses.begin(), uses.end(), [](const FieldUse& use) {
    return use.field.label == "Displacement" || use.field.label == "Damage";
  });
}

bool StaggeredPart::isLike(const StaggeredPart& other) const {
  return solverName_ == other.solverName_ && solver_->fields().ids() == other.solver_->fields().ids();
}

void StaggeredPart::initialize(Simulation& simulation) {
  solver_->initialize(simulation);
  enough_.initialize(simulation, name_);
}

void StaggeredPart::rehearse(Simulation& simulation, double t, double dt) {
  const TimeScale scale(simulation.conditions, timeScale_);
  t *= timeScale_;
  dt *= timeScale_ * std::max(1, every_);
  solver_->rehearse(simulation, t, dt / numberOfIncrements(simulation, t, t + dt));
}

void StaggeredPart::remember(Model& model) {
  if (watchedField_.empty()) return;
  std::copy_n(model.field(watchedField_), nOwnedValues(model, watchedField_), model.field(memoryField()));
}

double StaggeredPart::changeOf(Model& model) const {
  const double *now = model.field(watchedField_), *before = model.field(memoryField());
  const std::size_t n = nOwnedValues(model, watchedField_);
  if (isOfVolume_) {
    const auto width = static_cast<std::size_t>(model.fieldWidth(watchedField_));
    const double* volume = model.field("Volume");
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) sum += std::abs(now[i] - before[i]) * volume[i / width];
    return model.comm().sum(sum);
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, std::abs(now[i] - before[i]));
  return model.comm().max(largest);
}

bool StaggeredPart::isDue(Model& model, long long number) const {
  return (every_ > 0 && number % every_ == 0) || (runsAtStart_ && number == 1) ||
         (!watchedField_.empty() && changeOf(model) >= enough_.amount());
}

int StaggeredPart::numberOfIncrements(Simulation& simulation, double t0, double t1) const {
  const int needed = solver_->numberOfIncrements(simulation, t0, t1);
  if (nSubSteps_ == 0) return needed;
  if (nSubSteps_ < needed)
    throw RunError(
        fmt::format("Staggered: {}: {} needs {} increments from {:g} to {:g} s of its time, more than \"Sub "
                    "Steps: {}\"; raise it or leave it out",
                    name_, solverName_, needed, t0, t1, nSubSteps_));
  return nSubSteps_;
}

bool StaggeredPart::advance(Simulation& simulation, long long number, bool isLast, double t, double dt) {
  enough_.look(simulation, name_);
  if (!isLast && !isDue(simulation.model, number)) {
    if (!behindSince_) behindSince_ = t;
    return false;
  }
  if (behindSince_) {
    dt = t + dt - *behindSince_;
    t = *behindSince_;
    behindSince_.reset();
  }
  if (enough_.isControlled()) enough_.solverHasRun(changeOf(simulation.model));
  const TimeScale scale(simulation.conditions, timeScale_);
  t *= timeScale_;
  dt *= timeScale_;
  const int n = numberOfIncrements(simulation, t, t + dt);
  solver_->fieldsHaveChanged();
  for (int k = 0; k < n; ++k) {
    const double start = t + dt * k / n;
    solver_->advance(simulation, start, n == 1 ? dt : t + dt * (k + 1) / n - start);
  }
  ++nRuns_;
  remember(simulation.model);
  return true;
}

std::vector<std::string> StaggeredPart::summary(long long nLoadSteps) const {
  std::vector<std::string> lines = {fmt::format("{} ran in {} of {} load steps", solverName_, nRuns_, nLoadSteps)};
  if (enough_.isControlled())
    lines.push_back(fmt::format(
        "a change of {:.3g} of {} was enough at the end; {} changed by up to {:.3g} % between two runs before "
        "the last",
        enough_.amount(), watchedField_, enough_.label(), 100.0 * enough_.largestChange()));
  for (const std::string& line : solver_->summary()) lines.push_back(line);
  for (std::string& line : lines) line = name_ + ": " + line;
  return lines;
}

RestartState StaggeredPart::restartState() const {
  RestartState state = {{"runs", static_cast<double>(nRuns_)},
                        {"is behind", behindSince_ ? 1.0 : 0.0},
                        {"is behind since", behindSince_.value_or(0.0)}};
  state.addPart(solverName_, solver_->restartState());
  if (enough_.isControlled()) state.addPart("When", enough_.restartState());
  return state;
}

void StaggeredPart::setRestartState(const RestartState& state) {
  nRuns_ = static_cast<long long>(state["runs"]);
  if (state["is behind"] != 0.0) behindSince_ = state["is behind since"];
  solver_->setRestartState(state.part(solverName_));
  if (enough_.isControlled()) enough_.setRestartState(state.part("When"));
}

}  // namespace pd
