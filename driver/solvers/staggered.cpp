#include "staggered.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "declarations.hpp"
#include "mechanics.hpp"

namespace pd {

namespace {

/// The solvers of static mechanics that this build has.
std::vector<std::string> mechanicsSolvers() {
  std::vector<std::string> names;
  for (const char* name : {"Adaptive Dynamic Relaxation", "QuasiStatic"})
    if (SolverRegistry::self().has(name)) names.emplace_back(name);
  return names;
}

}  // namespace

void Staggered::declareParameters(ParameterDeclarations& declare) {
  declare.integer("Load Steps", "Increments of the run, each of the same physical time.").required().atLeast(1);
  ParameterDeclarations& solvers =
      declare.sublist("Solvers", "Solvers by names of your choice, which run in this order within each load step.");
  StaggeredPart::declareParameters(solvers.sublist("*", "One of its solvers, and when it runs."));
  addDeclarations(declare.sublist("Diffusion",
                                  "With Mechanics, in place of Solvers: how the diffusing field is "
                                  "advanced, in each load step."),
                  SolverRegistry::self().find("Diffusion")->declare(), StaggeredPart::keysOfTheRun());
  ParameterDeclarations& mechanics =
      declare.sublist("Mechanics", "How equilibrium is found, after Diffusion in each load step: one of its lists.");
  for (const std::string& name : mechanicsSolvers())
    addDeclarations(mechanics.sublist(name, SolverRegistry::self().find(name)->brief),
                    SolverRegistry::self().find(name)->declare(), StaggeredPart::keysOfTheRun());
  mechanics.exactlyOneOf(mechanicsSolvers());
  declare.exactlyOneOf({"Solvers", "Diffusion"});
  declare.exactlyOneOf({"Solvers", "Mechanics"});
}

Staggered::Staggered(const Teuchos::ParameterList& given) {
  const auto parameters = completed<Staggered>(given, "Staggered");
  nLoadSteps_ = parameters.get<int>("Load Steps");
  hasNames_ = parameters.isSublist("Solvers");
  if (!hasNames_) {
    parts_.emplace_back("Diffusion", "Diffusion", parameters.sublist("Diffusion"));
    const Teuchos::ParameterList& mechanics = parameters.sublist("Mechanics");
    for (const std::string& name : mechanicsSolvers())
      if (mechanics.isSublist(name)) parts_.emplace_back("Mechanics", name, mechanics.sublist(name));
    return;
  }
  const Teuchos::ParameterList& solvers = parameters.sublist("Solvers");
  if (solvers.numParams() == 0)
    throw std::invalid_argument("Solvers is empty; it holds solvers by names of your choice");
  for (auto it = solvers.begin(); it != solvers.end(); ++it) {
    const std::string& name = solvers.name(it);
    try {
      parts_.emplace_back(name, solvers.sublist(name));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument("Solvers/" + name + ": " + error.what());
    }
    for (std::size_t other = 0; other + 1 < parts_.size(); ++other)
      if (parts_[other].isLike(parts_.back()))
        throw std::invalid_argument("Solvers: \"" + parts_[other].name() + "\" and \"" + name +
                                    "\" are the same solver of the same fields; remove one of them");
  }
}

FieldTable Staggered::describeFields() {
  FieldTable fields = SolverRegistry::self().find("Diffusion")->fields();
  fields.include(MechanicsFields());
  return fields;
}

/// Made when asked for: a part may watch a field that only the rest of the deck makes known.
const FieldTable& Staggered::fields() const {
  fields_ = FieldTable();
  for (const StaggeredPart& part : parts_) fields_.include(part.fields());
  return fields_;
}

std::vector<std::string> Staggered::fieldsWithFarField() const {
  std::vector<std::string> labels;
  for (const StaggeredPart& part : parts_)
    for (const std::string& label : part.solver().fieldsWithFarField()) labels.push_back(label);
  return labels;
}

bool Staggered::needsDensity() const {
  return std::any_of(parts_.begin(), parts_.end(),
                     [](const StaggeredPart& part) { return part.solver().needsDensity(); });
}

double Staggered::leastSteps(double t0, double t1) const {
  double n = nLoadSteps_;
  for (const StaggeredPart& part : parts_) n += part.leastSteps(nLoadSteps_, t0, t1);
  return n;
}

template <class Work>
void Staggered::withEachPart(const Work& work) {
  std::vector<std::string> troubles;
  bool areOfTheDeck = true;
  for (StaggeredPart& part : parts_) {
    try {
      work(part);
    } catch (const DeckError& error) {
      troubles.emplace_back(error.what());
    } catch (const RunError& error) {
      troubles.emplace_back(error.what());
      areOfTheDeck = false;
    }
  }
  if (troubles.empty()) return;
  const std::string all = fmt::format("{}", fmt::join(troubles, "\n"));
  if (areOfTheDeck) throw DeckError(all);
  throw RunError(all);
}

void Staggered::initialize(Simulation& simulation) {
  withEachPart([&](StaggeredPart& part) { part.initialize(simulation); });
}

void Staggered::rehearse(Simulation& simulation, double t, double dt) {
  withEachPart([&](StaggeredPart& part) { part.rehearse(simulation, t, dt); });
}

int Staggered::numberOfIncrements(Simulation&, double, double t1) {
  endTime_ = t1;
  return nLoadSteps_;
}

void Staggered::advance(Simulation& simulation, double t, double dt) {
  if (loadStep_ == 0)
    for (StaggeredPart& part : parts_) part.remember(simulation.model);
  ++loadStep_;
  const bool isLast = t + 1.5 * dt > endTime_;
  for (StaggeredPart& part : parts_) {
    const bool hasRun = part.advance(simulation, loadStep_, isLast, t, dt);
    if (hasRun && part.changesDamage()) nNewSources_ += simulation.conditions.updateDamageSources();
  }
}

std::vector<std::string> Staggered::summary() const {
  std::vector<std::string> lines;
  for (const StaggeredPart& part : parts_)
    for (const std::string& line : hasNames_ ? part.summary(loadStep_) : part.solver().summary()) lines.push_back(line);
  lines.push_back(fmt::format("Staggered: {} points of crack faces became sources", nNewSources_));
  return lines;
}

RestartState Staggered::restartState() const {
  RestartState state = {{"load steps", static_cast<double>(loadStep_)}, {"sources", static_cast<double>(nNewSources_)}};
  for (const StaggeredPart& part : parts_) state.addPart(part.name(), part.restartState());
  return state;
}

void Staggered::checkpointWritten() {
  for (const StaggeredPart& part : parts_) part.solver().checkpointWritten();
}

void Staggered::setRestartState(const RestartState& state) {
  loadStep_ = static_cast<long long>(state["load steps"]);
  nNewSources_ = static_cast<long long>(state["sources"]);
  for (StaggeredPart& part : parts_) part.setRestartState(state.part(part.name()));
}

void Staggered::modelHasChanged() {
  for (const StaggeredPart& part : parts_) part.solver().modelHasChanged();
}

PD_REGISTER_SOLVER(Staggered, "Staggered", "Several solvers in turn, each with its own steps, scale or criterion")

}  // namespace pd
