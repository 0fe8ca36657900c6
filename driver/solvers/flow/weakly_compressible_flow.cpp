#include "weakly_compressible_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../diffusion/rate_integrator.hpp"
#include "field_names.hpp"
#include "flow_blocks.hpp"

namespace pd {

namespace {

constexpr const char* solverName = "Weakly Compressible Flow";
/// Steps between two looks at velocities and pressures.
constexpr int watchEvery = 8;
/// Part of the pressure at which the fluid has no density that pressures stay above.
constexpr double mostTension = 0.5;

}  // namespace

void WeaklyCompressibleFlow::declareParameters(ParameterDeclarations& declare) {
  LoadSteps::declareParameters(declare);
  declare
      .real("Sound Speed", "m/s",
            "Of the fluid at rest. Ten times the largest velocity make changes of density of about 1 %, and steps ten "
            "times shorter than the flow needs; differences from an incompressible flow fall with its square.")
      .positive()
      .required();
  declare
      .real("Largest Mach Number", "1",
            "Largest velocity over the Sound Speed; the run ends where the flow is faster. Steps are stable up to it.")
      .between(0.001, 0.5)
      .defaultTo(0.2);
  declare
      .integer("Tait Exponent",
               "n of p = rho0 c^2/n [(rho/rho0)^n - 1]; 1 makes the density follow the pressure in proportion.")
      .atLeast(1)
      .defaultTo(7)
      .from("water: Monaghan, J. Comput. Phys. 110 (1994) 399");
  declare
      .real("Density Diffusion", "1",
            "eta of the diffusivity eta c h of the density, c the Sound Speed, h the spacing, on fourth differences, "
            "by which pressures that alternate from point to point decay. 0 leaves them in. It is less where viscosity "
            "rules a bond.")
      .between(0.0, 10.0)
      .defaultTo(0.1);
  declare
      .real("Time Step", "s",
            "Longest step; load steps are cut into equal ones. Without it, the critical one times the safety factor.")
      .positive();
  declare.real("Safety Factor", "1", "Part of the critical step that is used where \"Time Step\" is not given.")
      .strictlyBetween(0.0, 1.0)
      .defaultTo(0.9);
  declare.flag("Allow Unstable Step", "Run even where the time step is above the critical one.").defaultTo(false);
}

WeaklyCompressibleFlow::WeaklyCompressibleFlow(const Teuchos::ParameterList& given)
    : parameters_(completed<WeaklyCompressibleFlow>(given, solverName)),
      loadSteps_(parameters_, solverName),
      largestMach_(parameters_.get<double>("Largest Mach Number")),
      safetyFactor_(parameters_.get<double>("Safety Factor")),
      allowUnstableStep_(parameters_.get<bool>("Allow Unstable Step")) {
  fluid_.soundSpeed = parameters_.get<double>("Sound Speed");
  fluid_.exponent = parameters_.get<int>("Tait Exponent");
  if (parameters_.isParameter("Time Step")) timeStep_ = parameters_.get<double>("Time Step");
}

double WeaklyCompressibleFlow::leastSteps(double t0, double t1) const {
  const double count = loadSteps_.count(t0, t1);
  return timeStep_ > 0.0 ? std::max(count, (t1 - t0) / timeStep_) : count;
}

void WeaklyCompressibleFlow::initialize(Simulation& simulation) {
  const FlowBlocks blocks = findFlowBlocks(simulation.model, solverName);
  law_ = blocks.law;
  flowBlocks_ = blocks.numbers;
  fluid_.density = law_->density;
  fluid_.viscosity = law_->viscosity;
}

void WeaklyCompressibleFlow::rehearse(Simulation& simulation, double t, double dt) {
  prepare(simulation, t + dt);
  requireStableStep(dt / numberOfSteps(dt));
}

/// Rows of the boundaries at time t, where there are none yet, metal has dissolved, or jumps of walls' velocities may
/// have come or gone; and what follows from them.
void WeaklyCompressibleFlow::prepare(Simulation& simulation, double t) {
  Model& model = simulation.model;
  const Timers::Scope timer(model.timers(), "flow operators");
  const std::vector<char> isSolid = solidPoints(model);
  const bool isFirst = !geometry_, isNew = isFirst || model.comm().any(isSolid != isSolid_);
  if (isNew) {
    isSolid_ = isSolid;
    rates_.reset();
    geometry_ = std::make_unique<FlowGeometry>(simulation, *law_, flowBlocks_, isSolid_);
    markFluid(model, *geometry_);
  }
  if (!rates_ || geometry_->wallsChangeWithTime()) {
    rates_.reset();
    rates_ = std::make_unique<FlowRates>(simulation, *geometry_, makeFlowRows(*geometry_, model.comm(), t), fluid_,
                                         parameters_.get<double>("Density Diffusion"));
  }
  requireMach(rates_->rows().jumps.largestVelocity, "walls or inlets have", t);
  // A run that goes on from a checkpoint has the step that it had.
  if (criticalStep_ == 0.0 || (isNew && !isFirst)) findCriticalStep(simulation);
  if (!isNew) return;
  for (kernels::FlowState* state : {&state_, &stage_, &sum_, &change_}) *state = rates_->makeState();
}

void WeaklyCompressibleFlow::findCriticalStep(Simulation& simulation) {
  limits_ = findFlowTimeSteps(*rates_, simulation.model.comm());
  criticalStep_ = limits_.all / (1.0 + largestMach_);
  simulation.output.log(fmt::format(
      "{}: critical step {:.6g} s up to Mach number {:g}; at rest {:.6g} s, of sound alone {:.6g} s, of viscosity "
      "{:.6g} s, of density diffusion {:.6g} s",
      solverName, criticalStep_, largestMach_, limits_.all, limits_.acoustics, limits_.viscosity, limits_.diffusion));
}

int WeaklyCompressibleFlow::numberOfSteps(double dt) const {
  return equalSteps(dt, timeStep_ > 0.0 ? timeStep_ : safetyFactor_ * criticalStep_);
}

/// CFL, viscous and density diffusion numbers of a step.
std::string WeaklyCompressibleFlow::numbers(double step) const {
  const double h = rates_->leastSpacing();
  return fmt::format(
      "CFL number (c + |v|) dt/h {:.3g}, viscous number nu dt/h^2 {:.3g}, density diffusion number "
      "D dt/h^2 {:.3g}",
      fluid_.soundSpeed * (1.0 + largestMach_) * step / h, fluid_.viscosity / fluid_.density * step / (h * h),
      rates_->largestDiffusionNumber() * step);
}

void WeaklyCompressibleFlow::requireStableStep(double step) const {
  if (step <= criticalStep_ || allowUnstableStep_) return;
  throw RunError(fmt::format(
      "{}: the time step {:.6g} s is above the critical one, {:.6g} s: {}; at the limit they are {}. Lower \"Time "
      "Step\" or leave it out; or lower \"Sound Speed\" or \"Density Diffusion\", whichever has the shortest step of "
      "its own (the log tells them); or set \"Allow Unstable Step: true\"",
      solverName, step, criticalStep_, numbers(step), numbers(criticalStep_)));
}

void WeaklyCompressibleFlow::requireMach(double speed, const std::string& what, double t) const {
  if (speed <= largestMach_ * fluid_.soundSpeed) return;
  throw RunError(fmt::format(
      "{}: t = {:.6g} s: {} {:.6g} m/s, a Mach number of {:.3g}, above \"Largest Mach Number: {:g}\". Give a \"Sound "
      "Speed\" of {:.3g} m/s or more; steps are shorter by as much",
      solverName, t, what, speed, speed / fluid_.soundSpeed, largestMach_, speed / std::min(largestMach_, 0.1)));
}

/// The classic method: k1 at t, k2 and k3 at t + dt/2, k4 at t + dt.
void WeaklyCompressibleFlow::step(Timers& timers, double t, double dt) {
  struct Stage {
    double time, share;   ///< of dt; in the sum
    double nextFraction;  ///< of dt, up to the next stage; 0: none
  };
  static constexpr Stage stages[] = {
      {0.0, 1.0 / 6.0, 0.5}, {0.5, 1.0 / 3.0, 0.5}, {0.5, 1.0 / 3.0, 1.0}, {1.0, 1.0 / 6.0, 0.0}};
  const int n = rates_->dimension(), count = rates_->nOwned();
  kernels::FlowState* at = &state_;
  for (const Stage& stage : stages) {
    rates_->evaluate(*at, t + stage.time * dt, change_);
    const Timers::Scope timer(timers, "flow update");
    kernels::advanceFlow(n, count, at == &state_ ? state_ : sum_, stage.share * dt, change_, sum_);
    if (stage.nextFraction > 0.0) kernels::advanceFlow(n, count, state_, stage.nextFraction * dt, change_, stage_);
    at = &stage_;
  }
  std::swap(state_, sum_);
}

/// Throws RunError where the flow is too fast, pulls too much, or is no number.
void WeaklyCompressibleFlow::watch(Model& model, double t) {
  const double least = mostTension * fluid_.leastPressure();
  double square = 0.0;
  bool isFinite = true, hasTension = false;
  for (const int point : geometry_->fluid()) {
    double own = 0.0;
    for (int a = 0; a < rates_->dimension(); ++a) own += state_.velocity[a][point] * state_.velocity[a][point];
    square = std::max(square, own);
    isFinite = isFinite && std::isfinite(own) && std::isfinite(state_.pressure[0][point]);
    hasTension = hasTension || state_.pressure[0][point] < least;
  }
  speed_ = std::sqrt(model.comm().max(square));
  highestMach_ = std::max(highestMach_, speed_ / fluid_.soundSpeed);
  isFinite = !model.comm().any(!isFinite);
  hasTension = model.comm().any(hasTension);
  if (isFinite && !hasTension && speed_ <= largestMach_ * fluid_.soundSpeed) return;
  if (!isFinite)  // nor written: fields that are not finite would have a message of their own
    throw RunError(
        fmt::format("{}: t = {:.6g} s: velocities or pressures are no longer finite: the flow is not stable. Lower "
                    "\"Time Step\", or give a larger \"Sound Speed\" or \"Density Diffusion\" or closer points; look "
                    "at the values of the conditions, too",
                    solverName, t));
  rates_->write(state_);
  requireMach(speed_, "the flow has reached", t);
  throw RunError(
      fmt::format("{}: t = {:.6g} s: the pressure has fallen below {:.6g} Pa, half of that at which the fluid has no "
                  "density. Give a "
                  "larger \"Sound Speed\", or pressures of outflows that are nearer to zero",
                  solverName, t, least));
}

void WeaklyCompressibleFlow::requireBalance(double t) const {
  const double ofWalls = rates_->rows().jumps.largestVelocity;
  const double netFlow = rates_->largestNetFlow(std::max(speed_, ofWalls));
  if (ofWalls == 0.0) return;
  requireNoNetFlow(netFlow, fmt::format("{}: t = {:.6g} s", solverName, t), "its mass is kept");
}

void WeaklyCompressibleFlow::advance(Simulation& simulation, double t, double dt) {
  Model& model = simulation.model;
  ++nLoadSteps_;
  prepare(simulation, t + dt);
  const int count = numberOfSteps(dt);
  const double step = dt / count;
  requireStableStep(step);
  usedStep_ = std::max(usedStep_, step);
  rates_->read(state_);
  const double mass = rates_->excessMass(state_);
  for (int k = 0; k < count; ++k) {
    this->step(model.timers(), t + k * step, step);
    if ((k + 1) % watchEvery == 0 || k + 1 == count) watch(model, t + (k + 1) * step);
  }
  nSteps_ += count;
  requireBalance(t + dt);
  massChange_ = std::max(massChange_, std::abs(rates_->excessMass(state_) - mass));
  rates_->write(state_);
  simulation.conditions.applyPrescribed(t + dt);
  model.importGhosts("Velocity");
  model.importGhosts("Pressure");
  // For outputs: what the material makes of this flow over bonds from point to point.
  model.evaluateFluxDivergence(dt, fluxDivergenceField("Velocity"));
  model.acceptStep(t + dt, dt);
}

RestartState WeaklyCompressibleFlow::restartState() const {
  return {{"critical step", criticalStep_},
          {"steps", static_cast<double>(nSteps_)},
          {"load steps", static_cast<double>(nLoadSteps_)}};
}

void WeaklyCompressibleFlow::setRestartState(const RestartState& state) {
  criticalStep_ = state["critical step"];
  nSteps_ = static_cast<long long>(state["steps"]);
  nLoadSteps_ = static_cast<long long>(state["load steps"]);
}

std::vector<std::string> WeaklyCompressibleFlow::summary() const {
  if (nSteps_ == 0) return {fmt::format("{}: no steps", solverName)};
  return {fmt::format("{}: {} steps in {} load steps, the longest {:.6g} s = {:.4g} of the critical one, {:.6g} s: {}; "
                      "at the limit {}",
                      solverName, nSteps_, nLoadSteps_, usedStep_, usedStep_ / criticalStep_, criticalStep_,
                      numbers(usedStep_), numbers(criticalStep_)),
          fmt::format("{}: largest Mach number {:.3g}; mass of parts that nothing leaves kept to {:.2g} of itself in a "
                      "load step; {:.3g} of the bonds share their weights with those beside them",
                      solverName, highestMach_, massChange_, rates_->uniformShare())};
}

PD_REGISTER_SOLVER(WeaklyCompressibleFlow, "Weakly Compressible Flow",
                   "Transient flow of a slightly compressible fluid, by explicit steps")

}  // namespace pd
