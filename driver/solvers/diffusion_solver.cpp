#include "diffusion_solver.hpp"

#include <map>

#include "declarations.hpp"
#include "diffusion/scalar_unknown.hpp"

namespace pd {

namespace {

constexpr const char* name = "Diffusion";

/// Which integrators declare the parameter `name`.
std::vector<std::string> methodsWith(const std::string& name) {
  std::vector<std::string> methods;
  for (const std::string& method : RateIntegratorRegistry::self().names())
    if (RateIntegratorRegistry::self().find(method)->declare().find(name) != nullptr) methods.push_back(method);
  return methods;
}

bool isDefault(const Parameter& parameter, const Teuchos::ParameterList& given) {
  ParameterDeclarations alone;
  alone.real(parameter.name, "", "") = parameter;
  const Teuchos::ParameterList defaults = alone.complete(Teuchos::ParameterList(), "");
  return defaults.isParameter(parameter.name) &&
         defaults.getEntry(parameter.name).getAny(false) == given.getEntry(parameter.name).getAny(false);
}

}  // namespace

void Diffusion::declareParameters(ParameterDeclarations& declare) {
  declare.text("Field", "The scalar point field that is advanced.").defaultTo("Concentration");
  declare.text("Method", "Time integrator.").defaultTo("RKL").oneOf(RateIntegratorRegistry::self().names());
  declare.integer("Load Steps", "Increments of the run: what output counts.").defaultTo(1).atLeast(1);
  ParameterDeclarations methods;
  for (const std::string& method : RateIntegratorRegistry::self().names())
    addDeclarations(methods, RateIntegratorRegistry::self().find(method)->declare());
  // Each says which methods use it.
  ParameterDeclarations marked;
  for (Parameter parameter : methods.parameters()) {
    parameter.meaning += " (Method: " + commaList(methodsWith(parameter.name)) + ".)";
    marked.real(parameter.name, "", "") = parameter;
  }
  addDeclarations(marked, methods);
  addDeclarations(declare, marked);
}

Diffusion::Diffusion(const Teuchos::ParameterList& given)
    : parameters_(completed<Diffusion>(given, name)), fields_(parameters_) {
  ParameterDeclarations declarations;
  declareParameters(declarations);
  field_ = parameters_.get<std::string>("Field");
  nIncrements_ = parameters_.get<int>("Load Steps");
  if (parameters_.isParameter("Sub Steps")) nSubSteps_ = parameters_.get<int>("Sub Steps");
  if (parameters_.isParameter("Time Step")) timeStep_ = parameters_.get<double>("Time Step");

  method_ = parameters_.get<std::string>("Method");
  const ParameterDeclarations own = RateIntegratorRegistry::self().find(method_)->declare();
  std::string mistakes;
  for (auto it = parameters_.begin(); it != parameters_.end(); ++it) {
    const std::string& name = parameters_.name(it);
    const bool isCommon = name == "Field" || name == "Method" || name == "Load Steps";
    if (isCommon || own.find(name) != nullptr || own.findSublist(name) != nullptr) continue;
    const Parameter* parameter = declarations.find(name);
    if (parameter != nullptr && isDefault(*parameter, parameters_)) continue;
    mistakes += (mistakes.empty() ? "" : "\n") +
                ("Diffusion: \"" + name + "\" has no meaning with Method: " + method_) + " (it belongs to " +
                commaList(methodsWith(name)) + ")";
  }
  if (!mistakes.empty()) throw std::invalid_argument(mistakes);
  integrator_ = RateIntegratorRegistry::self().create(method_, entriesKnownTo(own, parameters_));
}

double Diffusion::leastSteps(double t0, double t1) const {
  return timeStep_ > 0.0 ? (t1 - t0) / timeStep_ : nIncrements_ * nSubSteps_;
}

void Diffusion::initialize(Simulation& simulation) {
  requireFluxDivergence(simulation.model, field_, "Diffusion");
  const bool isImplicit = parameters_.isParameter("Linear Solver");
  if (rateIsAsymmetric(simulation.model, field_) &&
      (!isImplicit || parameters_.get<std::string>("Linear Solver") == "CG"))
    throw RunError("Diffusion: a flow carries \"" + field_ +
                   "\", which takes an implicit Method (Implicit Euler or TR-BDF2) with \"Linear Solver: GMRES\", "
                   "\"Preconditioner: ILU\", or \"Linear Solver: Direct\"");
  integrator_->initialize(simulation, field_);
}

void Diffusion::advance(Simulation& simulation, double t, double dt) {
  requireFlow(simulation.model, field_, name);
  integrator_->advance(simulation, field_, t, dt);
  simulation.model.acceptStep(t + dt, dt);
}

RestartState Diffusion::restartState() const {
  RestartState state;
  state.addPart(method_, integrator_->restartState());
  return state;
}

std::vector<std::string> Diffusion::summary() const {
  std::vector<std::string> lines = integrator_->summary();
  for (std::string& line : lines) line = "Diffusion of " + field_ + ": " + line;
  return lines;
}

PD_REGISTER_SOLVER(Diffusion, "Diffusion", "Transient nonlocal diffusion of a scalar field")

}  // namespace pd
