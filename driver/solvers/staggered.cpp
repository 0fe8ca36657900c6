#include "staggered.hpp"

#include <fmt/format.h>

#include "declarations.hpp"

namespace pd {

namespace {

/// What the run as a whole says, and its parts therefore do not.
const std::vector<std::string> namesOfTheRun = {"Load Steps", "Number of Load Steps", "Time Steps"};

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
  addDeclarations(declare.sublist("Diffusion", "How the diffusing field is advanced."),
                  SolverRegistry::self().find("Diffusion")->declare(), namesOfTheRun);
  ParameterDeclarations& mechanics = declare.sublist("Mechanics", "How equilibrium is found: one of its lists.");
  for (const std::string& name : mechanicsSolvers())
    addDeclarations(mechanics.sublist(name, SolverRegistry::self().find(name)->brief),
                    SolverRegistry::self().find(name)->declare(), namesOfTheRun);
  mechanics.exactlyOneOf(mechanicsSolvers());
  declare.needs("Load Steps", {"Diffusion", "Mechanics"});
}

Staggered::Staggered(const Teuchos::ParameterList& given) {
  ParameterDeclarations declarations;
  declareParameters(declarations);
  const auto parameters = declarations.complete(given, "Staggered");
  nLoadSteps_ = parameters.get<int>("Load Steps");
  diffusion_ = SolverRegistry::self().create("Diffusion", parameters.sublist("Diffusion"));
  const Teuchos::ParameterList& mechanics = parameters.sublist("Mechanics");
  for (const std::string& name : mechanicsSolvers())
    if (mechanics.isSublist(name)) mechanics_ = SolverRegistry::self().create(name, mechanics.sublist(name));
}

std::vector<int> Staggered::fieldIds() const {
  std::vector<int> ids = diffusion_->fieldIds();
  for (const int id : mechanics_->fieldIds()) ids.push_back(id);
  return ids;
}

void Staggered::initialize(Simulation& simulation) {
  diffusion_->initialize(simulation);
  mechanics_->initialize(simulation);
}

void Staggered::advance(Simulation& simulation, double t, double dt) {
  diffusion_->advance(simulation, t, dt);
  mechanics_->advance(simulation, t, dt);
  nNewSources_ += simulation.conditions.updateDamageSources();
}

std::vector<std::string> Staggered::summary() const {
  std::vector<std::string> lines = diffusion_->summary();
  for (const std::string& line : mechanics_->summary()) lines.push_back(line);
  lines.push_back(fmt::format("Staggered: {} points of crack faces became sources", nNewSources_));
  return lines;
}

std::vector<double> Staggered::restartState() const {
  const std::vector<double> first = diffusion_->restartState(), second = mechanics_->restartState();
  std::vector<double> state = {static_cast<double>(nNewSources_), static_cast<double>(first.size())};
  state.insert(state.end(), first.begin(), first.end());
  state.insert(state.end(), second.begin(), second.end());
  return state;
}

void Staggered::setRestartState(const std::vector<double>& state) {
  nNewSources_ = static_cast<long long>(state.at(0));
  const auto middle = state.begin() + 2 + static_cast<std::ptrdiff_t>(state.at(1));
  diffusion_->setRestartState({state.begin() + 2, middle});
  mechanics_->setRestartState({middle, state.end()});
}

PD_REGISTER_SOLVER(Staggered, "Staggered", "Diffusion and mechanics in turn, with sources on new crack faces")

}  // namespace pd
