#include "steady_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "carried_scalars.hpp"
#include "field_names.hpp"
#include "flow_blocks.hpp"
#include "flow_preconditioner.hpp"

namespace pd {

namespace {

/// Of linear solves: the most exact, the least, and that of a flow's first one, of which nothing is known.
constexpr double tightestTolerance = 1e-4, loosestTolerance = 0.1, firstTolerance = 1e-2;
/// With an old factor Newton's method ends where the next step would change the velocity by this part of the tolerance,
/// by the largest ratio of change to residual so far, in any flow: where pressures alone change the last one says
/// little. With a factor of this flow that step takes two iterations, and leaves nothing but rounding; without one the
/// residuals are of inexact steps, whose ratio is another.
constexpr double enoughOfTolerance = 0.2;
/// Of that ratio, while no flow has told more: round bodies in channels have 0.06 to 0.9.
constexpr double leastChangePerResidual = 0.1;
/// Velocities below this part of the fastest flow's so far are rounding of a fluid at rest.
constexpr double restingPart = 1e-12;
/// Of what velocities of a fluid at rest are measured by (FlowEquations::speedOfRounding): rounding of its pressures
/// changes them by some 3e-10 of that with every step, on 5 points across as on 40.
constexpr double leastRestTolerance = 1e-8;
/// From a flow that was driven by more than this many times as much Newton's method does not start: it may end at one
/// that nothing drives, as from an outlet back into it.
constexpr double mostFall = 10.0;
/// With a factor of the very matrix.
constexpr double newFactorTolerance = 1e-6;
/// Iterations of GMRES after which a new factor is cheaper.
constexpr int mostGmresIterations = 25;
/// Without any factor, and vectors that GMRES keeps, of which 50 take 1.6 kB a point.
constexpr int mostIterations = 1000, keptVectors = 50;
/// With a preconditioner that is better, or fails.
constexpr int mostTrialIterations = 150;
/// A change above this part of the largest velocity is a new flow, for which the old factor is not tried.
constexpr double newFlowChange = 0.3;

double flowNorm(const Communicator& comm, const std::vector<double>& values) {
  double square = 0.0;
  for (const double value : values) square += value * value;
  return std::sqrt(comm.sum(square));
}

}  // namespace

void SteadyFlow::declareParameters(ParameterDeclarations& declare) {
  LoadSteps::declareParameters(declare);
  declare
      .real("Relative Tolerance", "1",
            "Largest change of the velocity in the last Newton step, or that a further one would make, over the "
            "largest velocity.")
      .strictlyBetween(0.0, 1.0)
      .defaultTo(1e-8);
  declare.integer("Maximum Solver Iterations", "Newton steps for one flow.").atLeast(1).defaultTo(25);
  declare
      .text("Linear Solver",
            "Direct: a factor of the matrix (MUMPS). GMRES: without the matrix, velocity and pressure in turn as a "
            "preconditioner. By default Direct in the plane and for up to 2000 points in space, where factors "
            "grow fast, and GMRES beyond.")
      .oneOf({"Direct", "GMRES"});
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
  const FlowBlocks blocks = findFlowBlocks(model, "Steady Flow");
  nComponents_ = static_cast<std::size_t>(model.discretization().dimension);
  law_ = blocks.law;
  flowBlocks_ = blocks.numbers;
  factor_ = std::make_unique<FlowFactor>(model.comm());
  for (PeridigmNS::Block& block : *model.blocks())
    for (const FieldHandle& field : {fields_.flow, fields_.opening})
      wantsFlows_ = wantsFlows_ || block.hasData(field.id(), PeridigmNS::PeridigmField::STEP_NONE);
  takeUpPhases(simulation);
  if (model.comm().sum(static_cast<long long>(equations_->geometry().fluid().size())) == 0)
    throw RunError(
        "Steady Flow: no point is fluid: those of blocks whose materials name a fluid are all metal, of walls or "
        "inlets, or beyond outflows. Look at the Material of the block between them, and at the node sets");
  if (wantsFlows_) requireWayOut(simulation, equations_->geometry(), law_->fluxHorizon);
}

/// At first, where metal has dissolved since, and after a checkpoint, which holds nothing of how flows were found.
void SteadyFlow::takeUpPhases(Simulation& simulation) {
  Model& model = simulation.model;
  const std::vector<char> isSolid = solidPoints(model);
  if (mustRenew_) {
    factor_ = std::make_unique<FlowFactor>(model.comm());
    precision_ = FactorPrecision::Single;
    changePerResidual_ = fastest_ = 0.0;
  }
  if (equations_ && !mustRenew_ && !model.comm().any(isSolid != isSolid_)) return;
  isSolid_ = isSolid;
  auto equations = std::make_unique<FlowEquations>(simulation, *law_, flowBlocks_,
                                                   parameters_.get<double>("Pressure Smoothing"), isSolid_);
  if (equations_ && !mustRenew_) equations->goOnFrom(*equations_);
  mustRenew_ = false;
  equations_ = std::move(equations);
  hasFactor_ = wantsFactor(simulation);
  convectsPressure_ = true;
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

bool SteadyFlow::wantsFactor(Simulation& simulation) const {
  if (parameters_.isParameter("Linear Solver")) return parameters_.get<std::string>("Linear Solver") == "Direct";
  const auto nPoints = simulation.model.comm().sum(static_cast<long long>(equations_->geometry().nPossible()));
  return isWorthFactoring(static_cast<int>(nComponents_), nPoints);
}

/// An error about as small as what Newton's method leaves of the change that is expected, or as the tolerance asks for
/// (after Eisenstat & Walker, SIAM J. Sci. Comput. 17 (1996) 16).
double SteadyFlow::linearTolerance(double expectedChange) const {
  constexpr double belowTolerance = 0.2 * enoughOfTolerance;
  if (!(expectedChange > 0.0)) return firstTolerance;
  return std::clamp(std::max(expectedChange, belowTolerance * tolerance_ / expectedChange), tightestTolerance,
                    loosestTolerance);
}

/// -matrix^-1 residual, to a relative residual of `tolerance`.
std::vector<double> SteadyFlow::newtonStep(Simulation& simulation, bool isStokes, bool mayKeepFactor, double tolerance,
                                           const std::vector<double>& residual) {
  std::vector<double> rightSide(residual.size()), change(residual.size(), 0.0);
  std::transform(residual.begin(), residual.end(), rightSide.begin(), [](double value) { return -value; });
  const GmresReport report = hasFactor_
                                 ? solveByFactor(simulation, isStokes, mayKeepFactor, tolerance, rightSide, change)
                                 : solveByIteration(simulation, isStokes, tolerance, rightSide, change);
  largestResidual_ = std::max(largestResidual_, report.relativeResidual);
  return change;
}

GmresReport SteadyFlow::solveByFactor(Simulation& simulation, bool isStokes, bool mayKeepFactor, double tolerance,
                                      const std::vector<double>& rightSide, std::vector<double>& change) {
  Timers& timers = simulation.model.timers();
  const auto matrix = [&](const double* x, double* y) { equations_->apply(!isStokes, x, y); };
  const auto precondition = [&](const double* r, double* z) { factor_->apply(*equations_, !isStokes, r, z); };
  const auto solve = [&](double relativeTolerance) {
    const Timers::Scope timer(timers, "flow solve");
    const GmresReport report = solveByGmres(simulation.model.comm(), matrix, precondition, rightSide, change,
                                            relativeTolerance, mostGmresIterations, mostGmresIterations);
    nLinearIterations_ += report.iterations;
    return report;
  };
  if (mayKeepFactor && factor_->isMadeFor(*equations_))
    if (const GmresReport report = solve(tolerance); report.hasConverged) return report;
  const auto solveAnew = [&] {
    makeFactor(simulation, isStokes);
    std::fill(change.begin(), change.end(), 0.0);
    return solve(newFactorTolerance);
  };
  GmresReport report = solveAnew();
  if (!report.hasConverged && precision_ == FactorPrecision::Single) {
    precision_ = FactorPrecision::Double;
    report = solveAnew();
  }
  if (!(report.relativeResidual < tightestTolerance))
    throw RunError(fmt::format(
        "Steady Flow: the linear solve left a residual of {:.3g}: the matrix is singular, or nearly so. With "
        "\"Pressure Smoothing: 0\" pressures that alternate from point to point are not seen",
        report.relativeResidual));
  return report;
}

void SteadyFlow::makeFactor(Simulation& simulation, bool isStokes) {
  const Timers::Scope timer(simulation.model.timers(), "flow factor");
  if (const std::string trouble = factor_->make(*equations_, !isStokes, precision_); !trouble.empty())
    throw RunError("Steady Flow: the linear solve failed: " + trouble);
  ++nFactors_;
  largestFactor_ = std::max(largestFactor_, factor_->entries());
}

/// The same without a factor, or a matrix.
GmresReport SteadyFlow::solveByIteration(Simulation& simulation, bool isStokes, double tolerance,
                                         const std::vector<double>& rightSide, std::vector<double>& change) {
  const Timers::Scope timer(simulation.model.timers(), "flow solve");
  const auto solve = [&](bool convectsPressure, int iterations) {
    const FlowPreconditioner preconditioner(simulation.model, *equations_, !isStokes, convectsPressure);
    const auto matrix = [&](const double* x, double* y) { equations_->apply(!isStokes, x, y); };
    const auto precondition = [&](const double* r, double* z) { preconditioner.apply(r, z); };
    const GmresReport report = solveByGmres(simulation.model.comm(), matrix, precondition, rightSide, change, tolerance,
                                            iterations, keptVectors);
    nLinearIterations_ += report.iterations;
    return report;
  };
  const auto& pockets = equations_->pockets().pockets;
  const bool isOpen = std::all_of(pockets.begin(), pockets.end(), [](const auto& pocket) { return pocket.isOpen; });
  if (convectsPressure_ && isOpen && !isStokes) {
    const GmresReport report = solve(true, mostTrialIterations);
    convectsPressure_ = report.hasConverged;
    if (report.hasConverged) return report;
    std::fill(change.begin(), change.end(), 0.0);
  }
  const GmresReport report = solve(false, mostIterations);
  if (!report.hasConverged)
    throw RunError(fmt::format(
        "Steady Flow: GMRES left a residual of {:.3g} after {} iterations. Let velocities grow over several Load Steps "
        "(\"Velocity\" as a function of t), refine where rho |v| h/mu of the spacing h, here {:.3g}, is well above 1, "
        "or take \"Linear Solver: Direct\", if there is memory for it. With \"Pressure Smoothing: 0\" pressures that "
        "alternate from point to point are not seen",
        report.relativeResidual, report.iterations, equations_->largestCellReynolds()));
  return report;
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

/// Whether a step of Stokes flow has left less of the residual than shows in its velocities, or what no further one
/// lessens. Where pressures balance a weight the flow is what little the linear solve has missed: with convection of
/// that Newton's method finds no rest any more, or a flow that nothing drives.
bool SteadyFlow::isStokesFlowFound(const Communicator& comm, double normBefore) const {
  constexpr double little = 0.05, mostLeft = 0.5;
  const double norm = flowNorm(comm, equations_->residual(false));
  return std::max(changePerResidual_, leastChangePerResidual) * norm <= little * equations_->largestSpeed() ||
         norm > mostLeft * normBefore;
}

/// What velocities and their changes are measured by, m/s: a fluid that comes to rest has no speed of its own.
/// Of what is slower than rounding of its pressures no less than what that leaves, whatever the tolerance: a slow flow
/// under a high pressure is asked for the tolerance of its own speed.
double SteadyFlow::scaleOfSpeed() const {
  const double speed = equations_->largestSpeed(), resting = restingSpeed();
  const double ofBoundaries = std::max(speed, equations_->rows().jumps.largestVelocity);
  return speed < resting ? std::max(ofBoundaries, leastRestTolerance / tolerance_ * resting) : ofBoundaries;
}

/// Velocities below it are rounding, m/s.
double SteadyFlow::restingSpeed() const { return std::max(equations_->speedOfRounding(), restingPart * fastest_); }

void SteadyFlow::takeUpSpeed() {
  const double speed = equations_->scaleOfSpeed();
  fastest_ = std::max(fastest_, speed);
  if (speed <= restingPart * fastest_) equations_->comeToRest();
}

void SteadyFlow::giveUp(double t, int iterations, double change, const std::string& why) const {
  // Of what has divergence, as beside corners at which the velocities of walls jump: lap v - 2/3 grad div v in a plane,
  // - 1/2 in space (flow_weights.hpp).
  const char* const ofKernel = law_->viscousKernel == kernels::ViscousKernel::Transverse
                                   ? "; \"Viscous Kernel: Transverse\" damps velocities that have divergence with a "
                                     "third of the viscosity (a half "
                                     "in space): take Laplacian, or points near enough that this number is below 3"
                                   : "";
  throw RunError(fmt::format(
      "Steady Flow: load step {} (t = {:.6g} s): {} after {} Newton steps, the last of which changed the velocity by "
      "{:.3g} of the largest one; rho |v| h/mu of the spacing h is {:.3g}. Let velocities grow over several Load Steps "
      "(\"Velocity\" as a function of t), or refine; beyond some Reynolds number there is no steady flow{}",
      nLoadSteps_, t, why, iterations, change, equations_->largestCellReynolds(), ofKernel));
}

void SteadyFlow::advance(Simulation& simulation, double t, double dt) {
  Model& model = simulation.model;
  ++nLoadSteps_;
  takeUpPhases(simulation);
  const std::vector<double> pressureBefore(model.field("Pressure"), model.field("Pressure") + model.nPoints());
  simulation.conditions.applyPrescribed(t + dt);
  model.importGhosts("Velocity");
  model.importGhosts("Pressure");
  {
    const Timers::Scope timer(model.timers(), "flow operators");
    equations_->setTime(t + dt);
  }
  const double speed = equations_->largestSpeed(), drive = equations_->drive();
  bool isStokes = speed == 0.0 || speed < restingSpeed() || drive_ > mostFall * drive, hasWholeStep = false;
  isStokes ? equations_->comeToRest() : equations_->followOutflows(pressureBefore);
  if (hasFactor_) {
    const Timers::Scope timer(model.timers(), "flow factor");
    factor_->follow(*equations_, !isStokes);
  }
  const long long nFactorsBefore = nFactors_;
  double relativeChange = isStokes ? 1.0 : 0.0;
  for (int iteration = 1;; ++iteration) {
    equations_->refreshSmoothing();
    const std::vector<double> residual = equations_->residual(!isStokes);
    nUnknowns_ = model.comm().sum(static_cast<long long>(residual.size()));
    const double norm = flowNorm(model.comm(), residual);
    const double expectedChange =
        iteration > 1 ? std::max(changePerResidual_, leastChangePerResidual) * norm / scaleOfSpeed() : 0.0;
    const bool mayEnd = hasFactor_ && nFactors_ == nFactorsBefore && hasWholeStep;
    if (mayEnd && expectedChange > 0.0 && expectedChange <= enoughOfTolerance * tolerance_) break;
    const bool mayKeepFactor = relativeChange < newFlowChange || (isStokes && iteration > 1);
    const double asked = isStokes ? firstTolerance : linearTolerance(expectedChange);
    const std::vector<double> change = newtonStep(simulation, isStokes, mayKeepFactor, asked, residual);
    ++nNewtonSteps_;
    const double part = isStokes ? 1.0 : takeStep(simulation, change, norm);
    hasWholeStep = !isStokes && part == 1.0;
    if (isStokes) equations_->add(1.0, change);
    const double largest = scaleOfSpeed();
    const double changed = model.comm().max(largestVelocity(change));
    if (!std::isfinite(changed)) giveUp(t + dt, iteration, changed, "the velocity is no number");
    relativeChange = changed == 0.0 ? 0.0 : part * changed / largest;
    if (!isStokes && relativeChange > tolerance_) changePerResidual_ = std::max(changePerResidual_, changed / norm);
    // A fluid at rest has residuals of rounding alone, which no step lessens.
    const double speedNow = equations_->largestSpeed();
    const bool isAtRest = !isStokes && changed <= tolerance_ * largest && largest > speedNow;
    if (isAtRest || (hasWholeStep && relativeChange <= tolerance_)) break;
    isStokes = isStokes && !isStokesFlowFound(model.comm(), norm);
    if (iteration == maximumIterations_) giveUp(t + dt, iteration, relativeChange, "no steady flow");
  }
  takeUpSpeed();
  drive_ = drive;
  requireNoNetFlow(equations_->largestNetFlow(),
                   fmt::format("Steady Flow: load step {} (t = {:.6g} s)", nLoadSteps_, t + dt),
                   "the fluid is incompressible");
  equations_->settle(t + dt);
  for (const std::string& line : outflows_.look(model, equations_->geometry())) simulation.output.log(line);
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
  const std::string factors =
      hasFactor_ ? fmt::format("{} factors of {} unknowns ({:.3g} entries)", nFactors_, nUnknowns_, largestFactor_)
                 : fmt::format("{} unknowns without a factor", nUnknowns_);
  std::vector<std::string> lines{fmt::format(
      "Steady Flow: {} load steps, {} Newton steps, {}, {} iterations of GMRES; largest relative residual of a linear "
      "solve {:.3g}",
      nLoadSteps_, nNewtonSteps_, factors, nLinearIterations_, largestResidual_)};
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
