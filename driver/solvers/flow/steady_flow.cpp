#include "steady_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "carried_scalars.hpp"
#include "field_names.hpp"

namespace pd {

namespace {

/// To which a linear solve with a kept factor goes; the next Newton step takes care of the rest.
constexpr double keptFactorTolerance = 1e-4, newFactorTolerance = 1e-9;
/// Iterations of GMRES after which a new factor is cheaper.
constexpr int mostGmresIterations = 25;
/// A change above this part of the largest velocity is a new flow, for which the old factor is not tried.
constexpr double newFlowChange = 0.3;

/// Net flow into a closed part of the fluid above which its velocities contradict each other; what corners of lids let
/// through is below 1e-3, walls without a surface not much more.
constexpr double mostNetFlow = 0.02;

double flowNorm(const Communicator& comm, const std::vector<double>& values) {
  double square = 0.0;
  for (const double value : values) square += value * value;
  return std::sqrt(comm.sum(square));
}

struct FlowBlocks {
  const FlowLaw* law = nullptr;
  std::vector<int> numbers;
};

/// The blocks of fluid. Throws RunError where they are of different fluids.
FlowBlocks findFlowBlocks(Model& model) {
  FlowBlocks found;
  std::string first;
  for (PeridigmNS::Block& block : *model.blocks()) {
    const auto* material = dynamic_cast<const FlowMaterial*>(block.getMaterialModel().get());
    if (material == nullptr || material->flowLaw() == nullptr) continue;
    const FlowLaw& law = *material->flowLaw();
    if (found.law == nullptr) {
      found.law = &law;
      first = block.getName();
    } else if (law.density != found.law->density || law.viscosity != found.law->viscosity ||
               law.viscousKernel != found.law->viscousKernel || law.gradientHorizon != found.law->gradientHorizon ||
               law.fluxHorizon != found.law->fluxHorizon || law.family.horizon != found.law->family.horizon) {
      throw RunError("Steady Flow: the fluids of the blocks \"" + first + "\" and \"" + block.getName() +
                     "\" differ; give both one material and one Horizon");
    }
    found.numbers.push_back(block.getID());
  }
  return found;
}

}  // namespace

void SteadyFlow::declareParameters(ParameterDeclarations& declare) {
  LoadSteps::declareParameters(declare);
  declare
      .real("Relative Tolerance", "1",
            "Largest change of the velocity in the last Newton step, over the largest velocity.")
      .strictlyBetween(0.0, 1.0)
      .defaultTo(1e-8);
  declare.integer("Maximum Solver Iterations", "Newton steps for one flow.").atLeast(1).defaultTo(25);
  declare
      .real("Pressure Smoothing", "1",
            "c of the term c h^2/mu S p beside the divergence, h the spacing: fourth differences by which pressures "
            "that alternate from point to point are seen. 0 leaves them in. It is less where convection rules.")
      .between(0.0, 10.0)
      .defaultTo(0.05)
      .from("after Rhie & Chow, AIAA J. 21 (1983) 1525");
}

SteadyFlow::SteadyFlow(const Teuchos::ParameterList& given)
    : parameters_(completed<SteadyFlow>(given, "Steady Flow")),
      loadSteps_(parameters_, "Steady Flow"),
      tolerance_(parameters_.get<double>("Relative Tolerance")),
      maximumIterations_(parameters_.get<int>("Maximum Solver Iterations")) {}

void SteadyFlow::initialize(Simulation& simulation) {
  Model& model = simulation.model;
  const FlowBlocks blocks = findFlowBlocks(model);
  if (blocks.law == nullptr) throw RunError("Steady Flow: no block has a material for flows, as Navier Stokes is one");
  if (!model.discretization().symmetry.isAlongAxes())
    throw RunError("Steady Flow: planes of symmetry must be perpendicular to x, y or z");
  nComponents_ = static_cast<std::size_t>(model.discretization().dimension);
  if (nComponents_ < 2) throw RunError("Steady Flow: a flow needs two or three dimensions");
  law_ = blocks.law;
  flowBlocks_ = blocks.numbers;
  system_ = std::make_unique<RowSystem>(model.comm());
  for (PeridigmNS::Block& block : *model.blocks())
    for (const FieldHandle& field : {fields_.flow, fields_.opening})
      wantsFlows_ = wantsFlows_ || block.hasData(field.id(), PeridigmNS::PeridigmField::STEP_NONE);
  takeUpPhases(simulation);
  if (wantsFlows_) requireWayOut(simulation, equations_->geometry(), law_->fluxHorizon);
}

/// At first, where metal has dissolved since, and after a checkpoint, which holds no factors.
void SteadyFlow::takeUpPhases(Simulation& simulation) {
  Model& model = simulation.model;
  const std::vector<char> isSolid = solidPoints(model);
  if (mustRenew_) system_ = std::make_unique<RowSystem>(model.comm());
  if (equations_ && !mustRenew_ && !model.comm().any(isSolid != isSolid_)) return;
  mustRenew_ = false;
  isSolid_ = isSolid;
  equations_ = std::make_unique<FlowEquations>(simulation, *law_, flowBlocks_,
                                               parameters_.get<double>("Pressure Smoothing"), isSolid_);
  if (wantsFlows_) flows_ = std::make_unique<BondFlows>(simulation, equations_->geometry(), law_->fluxHorizon);
}

void SteadyFlow::rehearse(Simulation& simulation, double t, double dt) {
  const Timers::Scope timer(simulation.model.timers(), "flow operators");
  equations_->setTime(t + dt);
}

double SteadyFlow::largestVelocity(const std::vector<double>& change) const {
  double largest = 0.0;
  const auto nPoints = static_cast<std::size_t>(equations_->geometry().nPossible());
  for (std::size_t point = 0; point < nPoints; ++point)
    for (std::size_t a = 0; a < nComponents_; ++a)
      largest = std::max(largest, std::abs(change[point * (nComponents_ + 1) + a]));
  return largest;
}

/// change = -matrix^-1 residual. Returns the true relative residual.
double SteadyFlow::solveLinear(Simulation& simulation, const SparseRows& matrix, const std::vector<double>& residual,
                               bool mayKeepFactor, std::vector<double>& change) {
  const Timers::Scope timer(simulation.model.timers(), "flow solve");
  system_->setMatrix(matrix);
  std::vector<double> rightSide(residual.size());
  std::transform(residual.begin(), residual.end(), rightSide.begin(), [](double value) { return -value; });
  RowSolveReport report;
  if (mayKeepFactor && system_->hasFactor()) {
    change.assign(residual.size(), 0.0);
    report = system_->solve(rightSide, change, keptFactorTolerance, mostGmresIterations);
    nLinearIterations_ += report.iterations;
    if (report.hasConverged) return report.relativeResidual;
  }
  if (const std::string trouble = system_->factor(); !trouble.empty())
    throw RunError("Steady Flow: the linear solve failed: " + trouble);
  ++nFactors_;
  largestFactor_ = std::max(largestFactor_, system_->factorEntries());
  change.assign(residual.size(), 0.0);
  report = system_->solve(rightSide, change, newFactorTolerance, mostGmresIterations);
  nLinearIterations_ += report.iterations;
  if (!(report.relativeResidual < keptFactorTolerance))
    throw RunError(fmt::format(
        "Steady Flow: the linear solve left a residual of {:.3g}: the matrix is singular, or nearly so. With "
        "\"Pressure Smoothing: 0\" pressures that alternate from point to point are not seen",
        report.relativeResidual));
  return report.relativeResidual;
}

/// Adds the change, or less of it where the residual would grow much. Returns the part taken.
double SteadyFlow::takeStep(Simulation& simulation, const std::vector<double>& change, double normBefore) {
  constexpr double mayGrow = 2.0;
  double part = 1.0;
  equations_->add(part, change);
  for (int halving = 0; halving < 4; ++halving) {
    const double norm = flowNorm(simulation.model.comm(), equations_->residual(true));
    if (std::isfinite(norm) && norm <= mayGrow * normBefore) break;
    equations_->add(-0.5 * part, change);
    part *= 0.5;
  }
  return part;
}

void SteadyFlow::giveUp(double t, int iterations, double change, const std::string& why) const {
  throw RunError(fmt::format(
      "Steady Flow: load step {} (t = {:.6g} s): {} after {} Newton steps, the last of which changed the velocity by "
      "{:.3g} of the largest one; rho |v| h/mu of the spacing h is {:.3g}. Let velocities grow over several Load Steps "
      "(\"Velocity\" as a function of t), or refine; beyond some Reynolds number there is no steady flow",
      nLoadSteps_, t, why, iterations, change, equations_->largestCellReynolds()));
}

void SteadyFlow::advance(Simulation& simulation, double t, double dt) {
  Model& model = simulation.model;
  ++nLoadSteps_;
  takeUpPhases(simulation);
  simulation.conditions.applyPrescribed(t + dt);
  model.importGhosts("Velocity");
  model.importGhosts("Pressure");
  {
    const Timers::Scope timer(model.timers(), "flow operators");
    equations_->setTime(t + dt);
  }
  bool isStokes = equations_->largestSpeed() == 0.0;
  double relativeChange = isStokes ? 1.0 : 0.0;
  for (int iteration = 1;; ++iteration) {
    std::vector<double> residual, change;
    SparseRows matrix;
    {
      const Timers::Scope timer(model.timers(), "flow matrix");
      equations_->refreshSmoothing();
      residual = equations_->residual(!isStokes);
      matrix = equations_->matrix(!isStokes);
    }
    nUnknowns_ = model.comm().sum(static_cast<long long>(residual.size()));
    const double norm = flowNorm(model.comm(), residual);
    largestResidual_ =
        std::max(largestResidual_, solveLinear(simulation, matrix, residual, relativeChange < newFlowChange, change));
    ++nNewtonSteps_;
    const double part = isStokes ? 1.0 : takeStep(simulation, change, norm);
    if (isStokes) equations_->add(1.0, change);
    const double largest = std::max(equations_->largestSpeed(), equations_->rows().largestVelocity);
    const double changed = model.comm().max(largestVelocity(change));
    if (!std::isfinite(changed)) giveUp(t + dt, iteration, changed, "the velocity is no number");
    relativeChange = changed == 0.0 ? 0.0 : part * changed / largest;
    const bool isDone = !isStokes && part == 1.0 && relativeChange <= tolerance_;
    isStokes = false;
    if (isDone) break;
    if (iteration == maximumIterations_) giveUp(t + dt, iteration, relativeChange, "no steady flow");
  }
  if (const double netFlow = equations_->largestNetFlow(); netFlow > mostNetFlow)
    throw RunError(fmt::format(
        "Steady Flow: load step {} (t = {:.6g} s): walls and inlets let {:.2g} of the largest velocity, over the width "
        "of "
        "the fluid, into a part of it that has no Outflow, or out of it, and the fluid is incompressible. Give it an "
        "Outflow, or velocities that let out what they let in",
        nLoadSteps_, t + dt, netFlow));
  equations_->settle(t + dt);
  if (flows_) flows_->update(t + dt);
  cellReynolds_ = equations_->largestCellReynolds();
  leakage_ = equations_->leakage();
  divergence_ = equations_->largestDivergence();
  model.requireFinite("Velocity", static_cast<int>(nLoadSteps_));
  model.requireFinite("Pressure", static_cast<int>(nLoadSteps_));
  // For outputs: what the material makes of this flow over bonds from point to point.
  model.evaluateFluxDivergence(dt, fluxDivergenceField("Velocity"));
  model.acceptStep(t + dt, dt);
}

std::vector<std::string> SteadyFlow::summary() const {
  std::vector<std::string> lines{fmt::format(
      "Steady Flow: {} load steps, {} Newton steps, {} factors of {} unknowns ({:.3g} entries), {} "
      "iterations of GMRES; largest relative residual of a linear solve {:.3g}",
      nLoadSteps_, nNewtonSteps_, nFactors_, nUnknowns_, largestFactor_, nLinearIterations_, largestResidual_)};
  if (nLoadSteps_ > 0)
    lines.push_back(fmt::format(
        "Steady Flow: at the end rho |v| h/mu of the spacing h is at most {:.3g}; largest divergence {:.3g} 1/s; what "
        "walls of closed pockets let through {:.3g} 1/s; {} points beside jumps of the walls' velocity",
        cellReynolds_, divergence_, leakage_, equations_->rows().nAtJumps));
  if (nLoadSteps_ > 0 && flows_)
    lines.push_back(fmt::format(
        "Steady Flow: flows of bonds are balanced to {:.2g} of what passes a point; that took {:.2g} of the largest",
        flows_->largestImbalance(), flows_->largestCorrection()));
  return lines;
}

PD_REGISTER_SOLVER(SteadyFlow, "Steady Flow", "Steady flow of an incompressible fluid, load step by load step")

}  // namespace pd
