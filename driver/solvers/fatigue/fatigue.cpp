#include "fatigue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../mechanics.hpp"

namespace pd {

namespace {

constexpr double mostOverdrawn = 0.1;  ///< of a life, in blocks of fixed length
/// How many times as far as at first loads move before what bears them finds no equilibrium any more, because it has
/// come apart: the last bonds between two parts let them turn. Seen: 17 to 5e4.
constexpr double mostYielded = 10.0;
constexpr double mostMisjudged = 0.05;  ///< part of a life, by loads that change within steps, that needs no word

}  // namespace

void Fatigue::declareParameters(ParameterDeclarations& declare) {
  LoadBlocks::declareParameters(declare);
  declare
      .real(
          "Cycles Per Block", "1",
          "Steps of that many cycles, after each of which the bonds whose life is over break together. Without it a "
          "step ends with the next failure. Blocks by whose end a bond has been loaded for a tenth of a life too long "
          "are halved.")
      .positive();
  declare
      .integer(
          "Intervals",
          "Parts of equal length into which the cycles of the run are divided in any case, for output of long lives; "
          "loads that change with the number of cycles are followed at their ends and at failures.")
      .defaultTo(1)
      .atLeast(1);
  declare
      .integer("Maximum Breakage Passes",
               "Equilibria after one another in which the damage model's static limit breaks bonds. A crack that needs "
               "more runs by itself, which ends the run.")
      .defaultTo(100)
      .atLeast(1);
  CrackControl::declareParameters(declare);
  Equilibrium::declareParameters(declare);
}

FieldTable Fatigue::describeFields() { return Fields(CrackControl(defaultsOf<Fatigue>())); }

Fatigue::Fatigue(const Teuchos::ParameterList& given)
    : control_(completed<Fatigue>(given, "Fatigue")),
      fields_(control_),
      loads_(completed<Fatigue>(given, "Fatigue")),
      equilibrium_(completed<Fatigue>(given, "Fatigue"), "Fatigue") {
  const auto parameters = completed<Fatigue>(given, "Fatigue");
  if (parameters.isParameter("Cycles Per Block")) cyclesPerBlock_ = parameters.get<double>("Cycles Per Block");
  nIntervals_ = parameters.get<int>("Intervals");
  maximumPasses_ = parameters.get<int>("Maximum Breakage Passes");
  if (cyclesPerBlock_ > 0.0 && nIntervals_ > 1)
    throw std::invalid_argument("Fatigue: \"Cycles Per Block\" and \"Intervals\" both divide the run; remove one");
  if (loads_.areSeveral() && control_.setsLoad())
    throw std::invalid_argument(
        "Fatigue: \"Load Blocks\" and the crack (\"Range\" of \"Stress Intensity\" or \"Load By Crack Length\") both "
        "say what the load is; remove one");
}

double Fatigue::leastSteps(double t0, double t1) const {
  constexpr double most = 1e7;
  if (loads_.count(t0, t1) > most)
    throw RunError(fmt::format("Fatigue: \"Load Blocks\" make {:g} steps; give each the cycles of many repetitions",
                               loads_.count(t0, t1)));
  if (cyclesPerBlock_ == 0.0) return nIntervals_;
  const double n = std::ceil((t1 - t0) / cyclesPerBlock_ * (1.0 - 1e-12));
  if (n > most) throw RunError(fmt::format("Fatigue: \"Cycles Per Block\" makes {:g} steps; take longer blocks", n));
  return n;
}

int Fatigue::numberOfIncrements(Simulation&, double t0, double t1) { return static_cast<int>(leastSteps(t0, t1)); }

double Fatigue::incrementEnd(int increment, int nIncrements, double t0, double t1) const {
  if (increment >= nIncrements) return t1;
  return cyclesPerBlock_ > 0.0 ? t0 + increment * cyclesPerBlock_ : t0 + (t1 - t0) * increment / nIncrements;
}

void Fatigue::initialize(Simulation& simulation) {
  Model& model = simulation.model;
  requireMechanics(model, "Fatigue");
  equilibrium_.requireSprings(model);
  bool someoneTires = false;
  for (PeridigmNS::Block& block : *model.blocks()) {
    if (block.getDamageModel().is_null()) continue;
    const auto ids = block.getDamageModel()->FieldIds();
    someoneTires = someoneTires || std::find(ids.begin(), ids.end(), fields_.lossRate.id()) != ids.end();
  }
  if (!model.comm().any(someoneTires))
    throw RunError(
        "Fatigue: no block has a damage model in which cycles take life; give one \"Remaining Life\" or "
        "\"Cumulative Fatigue\"");
  for (const char* label : {"Displacement", "Damage"}) model.fieldAtN(label);  // kept from now on
  control_.initialize(model);
  *model.field(fields_.cycles) = *model.field(fields_.range) = *model.field(fields_.peak) = 0.0;
}

void Fatigue::rehearse(Simulation& simulation, double t, double) {
  equilibrium_.requireWindow(simulation);
  equilibrium_.findSupports(simulation);
  equilibrium_.requireHeldLoads(simulation, t);
}

bool Fatigue::passCycles(Simulation& simulation, double cycles) {
  Model& model = simulation.model;
  *model.field(fields_.cycles) = cycles;
  model.evaluateDamage(cycles);
  return bondDamageSum_.of(model) > bondDamage_ * (1.0 + 1e-12);
}

/// Whether the load breaks bonds in its first cycle.
bool Fatigue::breakAtOnce(Simulation& simulation, double t) {
  const bool hasBroken = passCycles(simulation, 0.0);
  if (hasBroken && !hasBrokenOutside_ && equilibrium_.breaksOutsideWindow(simulation.model)) {
    hasBrokenOutside_ = true;
    simulation.output.log(
        fmt::format("Fatigue: warning: after {:.6g} cycles bonds outside the window break at once, at "
                    "strains that are estimates; see what the run does without Tip Window",
                    t));
  }
  return hasBroken;
}

Fatigue::Worst Fatigue::worst(Model& model) const {
  const double *rate = model.field(fields_.lossRate), *overdrawn = model.field(fields_.overdrawn);
  Worst worst{0.0, 0.0};
  for (int i = 0; i < model.nOwned(); ++i) {
    worst.lossRate = std::max(worst.lossRate, rate[i]);
    worst.overdrawn = std::max(worst.overdrawn, overdrawn[i]);
  }
  return {model.comm().max(worst.lossRate), model.comm().max(worst.overdrawn)};
}

void Fatigue::noteBreakage(Simulation& simulation, double t) {
  Model& model = simulation.model;
  const double *damage = model.field("Damage"), *before = model.fieldAtN("Damage");
  double* first = model.field(fields_.firstBreak);
  const double after = bondDamageSum_.of(model);
  nBroken_ += std::llround(0.5 * (after - bondDamage_));
  bondDamage_ = after;
  ++nEvents_;
  std::array<double, 4> mine{}, all{};
  for (int i = 0; i < model.nOwned(); ++i) {
    if (damage[i] == before[i]) continue;
    if (first[i] == 0.0) first[i] = t;
    for (std::size_t d = 0; d < 3; ++d) mine[d] += model.discretization().x[3 * static_cast<std::size_t>(i) + d];
    mine[3] += 1.0;
  }
  if (nEvents_ > 1) return;
  model.comm().SumAll(mine.data(), all.data(), 4);
  firstBreak_ = t;
  for (std::size_t d = 0; d < 3; ++d) firstPlace_[d] = all[d] / all[3];
  simulation.output.log(
      fmt::format("Fatigue: the first bond breaks after {:.6g} cycles at x = {:.6g}, y = {:.6g}, z = "
                  "{:.6g} m",
                  t, firstPlace_[0], firstPlace_[1], firstPlace_[2]));
}

/// False where loads have torn off what they act on, or nothing is left that could bear them: there reasonToStop_ says
/// so, and displacements are those of the equilibrium before.
bool Fatigue::findEquilibrium(Simulation& simulation, double t, bool fromRest) {
  if (hasStarted_)
    if (const std::string loose = equilibrium_.loadsNothingHolds(simulation, t); !loose.empty()) {
      reasonToStop_ = fmt::format("the body has come apart after {:.6g} cycles: {}", t, loose);
      return false;
    }
  try {
    fromRest ? equilibrium_.findFromRest(simulation, t) : equilibrium_.find(simulation, t);
  } catch (const NoEquilibrium& error) {
    if (!hasStarted_ || error.iterationsAreUsedUp) throw;
    const double yielded = equilibrium_.yielded(simulation, t);
    if (yielded < mostYielded) throw;
    reasonToStop_ = fmt::format(
        "the body has come apart after {:.6g} cycles: a load moved {:.3g} times as far as at first before, and now "
        "there is no equilibrium: {}",
        t, yielded, error.trouble);
    Model& model = simulation.model;
    std::copy_n(model.fieldAtN("Displacement"), 3LL * model.nPoints(), model.field("Displacement"));
    model.updateCoordinates();
    return false;
  }
  return true;
}

void Fatigue::settle(Simulation& simulation, double t, bool fromRest) {
  simulation.output.stateHasChanged();
  for (int pass = 0;; ++pass) {
    if (!equilibrium_.keepsTogether()) {
      equilibrium_.findSupports(simulation);
      if (hasStarted_ && equilibrium_.countLoadedParts(simulation, t) != nLoadedParts_) {
        reasonToStop_ = fmt::format("the body has come apart after {:.6g} cycles", t);
        return;
      }
    }
    if (!hasStarted_) equilibrium_.requireHeldLoads(simulation, t);
    if (!findEquilibrium(simulation, t, fromRest && pass == 0)) return;
    // While a crack runs, strains far from it change too fast for estimates.
    if (pass > 0) equilibrium_.complete(simulation, t);
    if (hasStarted_ && equilibrium_.carriesNothing())
      reasonToStop_ =
          fmt::format("after {:.6g} cycles the body carries a thousandth of its load: it has come apart", t);
    const bool hasBroken = breakAtOnce(simulation, t);
    ratesAreKnown_ = !hasBroken;
    if (hasBroken) noteBreakage(simulation, t);
    simulation.model.acceptStep(t, 0.0);
    if (!hasBroken || !reasonToStop_.empty()) return;
    ++nPasses_;
    if (pass + 1 == maximumPasses_) {
      reasonToStop_ = fmt::format("after {:.6g} cycles the crack runs at the largest load", t);
      return;
    }
  }
}

void Fatigue::start(Simulation& simulation, double t) {
  bondDamage_ = bondDamageSum_.of(simulation.model);
  nLoadedParts_ = equilibrium_.countLoadedParts(simulation, t);
  *simulation.model.field(fields_.peak) = control_.setsLoad() ? 0.0 : loads_.at(t).peak;
  settle(simulation, t, true);
  hasStarted_ = isSettled_ = true;
}

void Fatigue::setLoad(Simulation& simulation, double t) {
  simulation.output.stateIsSettled();
  const LoadBlocks::Load load = loads_.at(t);
  CrackControl::Outcome outcome = control_.look(simulation, t, load.peak, load.ratio);
  if (equilibrium_.completeForComputes(simulation, t, control_.looks())) {
    ratesAreKnown_ = false;
    simulation.output.stateIsSettled();
    outcome = control_.look(simulation, t, load.peak, load.ratio);
  }
  double &range = *simulation.model.field(fields_.range), &peak = *simulation.model.field(fields_.peak);
  const double newRange = (1.0 - load.ratio) * outcome.peak;
  ratesAreKnown_ = ratesAreKnown_ && range == newRange && peak == outcome.peak;
  range = newRange;
  peak = outcome.peak;
  if (reasonToStop_.empty()) reasonToStop_ = outcome.reason;
}

/// A block, or as many halves of it as it takes to break no bond much too late. Returns the cycles passed.
double Fatigue::passBlock(Simulation& simulation, double cycles, bool& hasBroken) {
  simulation.beginStep();
  while (true) {
    hasBroken = passCycles(simulation, cycles);
    if (worst(simulation.model).overdrawn <= mostOverdrawn) return cycles;
    simulation.takeBackStep();
    cycles *= 0.5;
    ++nHalved_;
  }
}

/// Bonds that fail nearly together break together, when what some have left of their lives is what others have
/// overdrawn, or the first of them is overdrawn by as much as its model tolerates: the many with much left that wear
/// slowly do not outvote the few that wear fast. Returns the cycles passed, at most `most`.
double Fatigue::passToFailure(Simulation& simulation, double cycles, double most, bool& hasBroken) {
  Model& model = simulation.model;
  hasBroken = passCycles(simulation, cycles);
  if (!hasBroken) return cycles;
  const double *left = model.field(fields_.lifeLeft), *rate = model.field(fields_.rateOfFailed);
  const double* overdrawRate = model.field(fields_.overdrawRate);
  std::array<double, 2> mine{}, all{};
  double fastest = 0.0;
  for (int i = 0; i < model.nOwned(); ++i) {
    mine[0] += left[i];
    mine[1] += rate[i];
    fastest = std::max(fastest, overdrawRate[i]);
  }
  model.comm().SumAll(mine.data(), all.data(), 2);
  fastest = model.comm().max(fastest);
  const double even = all[1] > 0.0 ? all[0] / all[1] : 0.0, tolerated = fastest > 0.0 ? 1.0 / fastest : even;
  const double more = std::min({even, tolerated, most - cycles});
  if (more <= 1e-9 * cycles) return cycles;
  passCycles(simulation, cycles + more);
  return cycles + more;
}

/// A step without failures wore bonds at the rate of its first cycle. Had the load not changed, the worst of them would
/// lose rateBefore (1 - rateBefore cycles)^-1 of its remaining life in a cycle after it; half the difference is what
/// the step is wrong by.
void Fatigue::watchLoad(Simulation& simulation, double rateBefore, double cycles, double reached) {
  const double rate = worst(simulation.model).lossRate * std::max(1.0 - rateBefore * cycles, 0.0);
  const bool wasSmall = misjudgedLife_ <= mostMisjudged;
  misjudgedLife_ += 0.5 * std::abs(rate - rateBefore) * cycles;
  if (wasSmall && misjudgedLife_ > mostMisjudged)
    simulation.output.log(
        fmt::format("Fatigue: warning: loads change within the {:.6g} cycles up to {:.6g}, in which "
                    "bonds wear at the load of the first one; give more Intervals",
                    cycles, reached));
}

void Fatigue::completeFields(Simulation& simulation, double t) {
  if (equilibrium_.complete(simulation, t)) ratesAreKnown_ = false;
}

double Fatigue::advanceToEvent(Simulation& simulation, double t, double end) {
  Model& model = simulation.model;
  const bool isAtWork = equilibrium_.hasSupports();
  equilibrium_.startIncrement(simulation);
  if (!isAtWork) equilibrium_.requireWindow(simulation);
  if (!hasStarted_) start(simulation, t);
  if (!isSettled_) settle(simulation, t, false);
  isSettled_ = true;
  if (!equilibrium_.hasSupports()) equilibrium_.findSupports(simulation);
  if (!isAtWork) setLoad(simulation, t);  // the start, or a restart
  if (!reasonToStop_.empty()) return t;
  const double stop = std::min(end, loads_.at(t).end);
  const long long nEventsBefore = nEvents_;
  double cycles = stop - t;
  bool hasBroken = !ratesAreKnown_ && breakAtOnce(simulation, t);
  const double rateBefore = worst(model).lossRate;
  if (hasBroken) {
    cycles = 0.0;
  } else if (cyclesPerBlock_ > 0.0) {
    cycles = passBlock(simulation, cycles, hasBroken);
  } else {
    // A step must not be shorter than rounding of t.
    if (rateBefore > 0.0 && 1.0 / rateBefore < cycles * (1.0 - 1e-12)) cycles = 1.0 / rateBefore;
    cycles = passToFailure(simulation, cycles, stop - t, hasBroken);
  }
  const double reached = cycles < stop - t ? t + cycles : stop;
  if (hasBroken) noteBreakage(simulation, reached);
  model.acceptStep(reached, cycles);
  ratesAreKnown_ = false;
  settle(simulation, reached, false);
  if (nEvents_ == nEventsBefore && reasonToStop_.empty()) watchLoad(simulation, rateBefore, cycles, reached);
  if (reasonToStop_.empty()) setLoad(simulation, reached);
  model.requireFinite("Displacement", static_cast<int>(nEvents_));
  return reached;
}

RestartState Fatigue::restartState() const {
  RestartState state = {{"has started", hasStarted_ ? 1.0 : 0.0},
                        {"loaded parts", static_cast<double>(nLoadedParts_)},
                        {"bond damage", bondDamage_},
                        {"events", static_cast<double>(nEvents_)},
                        {"broken bonds", static_cast<double>(nBroken_)},
                        {"halved blocks", static_cast<double>(nHalved_)},
                        {"passes", static_cast<double>(nPasses_)},
                        {"misjudged life", misjudgedLife_},
                        {"cycles to the first break", firstBreak_},
                        {"x of the first break", firstPlace_[0]},
                        {"y of the first break", firstPlace_[1]},
                        {"z of the first break", firstPlace_[2]}};
  state.addPart("equilibrium", equilibrium_.restartState());
  return state;
}

void Fatigue::setRestartState(const RestartState& state) {
  hasStarted_ = isSettled_ = state["has started"] != 0.0;
  nLoadedParts_ = static_cast<int>(state["loaded parts"]);
  bondDamage_ = state["bond damage"];
  nEvents_ = static_cast<long long>(state["events"]);
  nBroken_ = static_cast<long long>(state["broken bonds"]);
  nHalved_ = static_cast<long long>(state["halved blocks"]);
  nPasses_ = static_cast<long long>(state["passes"]);
  misjudgedLife_ = state["misjudged life"];
  firstBreak_ = state["cycles to the first break"];
  firstPlace_ = {state["x of the first break"], state["y of the first break"], state["z of the first break"]};
  equilibrium_.setRestartState(state.part("equilibrium"));
}

std::vector<std::string> Fatigue::summary() const {
  std::vector<std::string> lines;
  lines.push_back(
      nEvents_ == 0
          ? std::string("Fatigue: no bond has broken (run-out)")
          : fmt::format("Fatigue: {} bonds broke in {} events, the first after {:.6g} cycles at x = {:.6g}, y "
                        "= {:.6g}, z = {:.6g} m; {} further equilibria after bonds broke at once, {} blocks "
                        "halved",
                        nBroken_, nEvents_, firstBreak_, firstPlace_[0], firstPlace_[1], firstPlace_[2], nPasses_,
                        nHalved_));
  if (!reasonToStop_.empty()) lines.push_back("Fatigue: ended since " + reasonToStop_);
  if (misjudgedLife_ > mostMisjudged)
    lines.push_back(
        fmt::format("Fatigue: warning: loads changed within steps, by which lives may be wrong by {:.2g} of "
                    "themselves; give more Intervals",
                    misjudgedLife_));
  for (const std::string& line : equilibrium_.summary()) lines.push_back(line);
  return lines;
}

PD_REGISTER_SOLVER(Fatigue, "Fatigue", "Cycles of load that take life of bonds, from one failure to the next")

}  // namespace pd
