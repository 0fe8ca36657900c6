#include "corrosion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "../declarations.hpp"
#include "../diffusion/scalar_unknown.hpp"
#include "dissolve_loose_metal.hpp"
#include "field_names.hpp"
#include "transport_methods.hpp"

namespace pd {

namespace {

/// Throws RunError where a point that can dissolve has less than no metal, or more than the solid or, electrolyte,
/// `fullest` times saturation, by more than the share `slack` of saturation.
void requireConcentrations(Model& model, const std::string& field, double fullest, double slack) {
  const double* concentration = model.field(field);
  const double *solid = model.field("Solid_Concentration"), *saturation = model.field("Saturation_Concentration");
  std::string message;
  for (int i = 0; i < model.nOwned() && message.empty(); ++i) {
    const double most = solid[i] == 0.0 ? fullest * saturation[i] : std::max(solid[i], saturation[i]);
    const double beyond = slack * saturation[i];
    if (saturation[i] == 0.0) continue;  // of a block that does not dissolve
    if (concentration[i] >= -beyond && concentration[i] <= most + beyond) continue;
    const auto point = static_cast<std::size_t>(i);
    const double* x = model.discretization().x.data() + 3 * point;
    message = fmt::format(
        "Corrosion: concentration {:g} mol/m3 at point {} (x = {:g}, y = {:g}, z = {:g} m) is not between 0 and the "
        "{:g} of the metal; look at the initial and prescribed concentrations\n",
        concentration[i], model.discretization().globalIds[point] + 1, x[0], x[1], x[2], most);
  }
  if (model.comm().any(!message.empty())) throw RunError(model.comm().gather(message));
}

/// Throws RunError where no block dissolves, or one does without a damage model that changes its phase.
void requireDissolution(Model& model, const std::string& field) {
  const int saturation = fields::saturationConcentration().id();
  bool isAny = false;
  for (PeridigmNS::Block& block : *model.blocks()) {
    const FieldTable material = fieldsIn(*block.getMaterialModel());
    const FieldUse* use = material.find(saturation);
    if (use == nullptr || use->access != FieldAccess::Writes) continue;
    if (material.rateOf(field) < 0)
      throw RunError("Corrosion: the metal of " + block.getName() + " dissolves, but not into \"" + field +
                     "\"; give its material and this solver the same \"Concentration Field\"");
    const FieldTable* damage = block.getDamageModel().is_null() ? nullptr : fieldTableOf(*block.getDamageModel());
    const bool isFollowed =
        !block.getDamageModel().is_null() && (damage == nullptr || damage->find(saturation) != nullptr);
    if (!isFollowed)
      throw RunError("Corrosion: the metal of " + block.getName() +
                     " dissolves, and needs a damage model that changes its phase (\"Dissolution\")");
    isAny = true;
  }
  if (!isAny)
    throw RunError(
        "Corrosion: no block has a material that dissolves (\"Corrosion Dissolution\"), with a damage model that "
        "changes its phase (\"Dissolution\")");
}

}  // namespace

void Corrosion::declareParameters(ParameterDeclarations& declare) {
  declare.integer("Load Steps", "Increments of the run: what output counts.").defaultTo(1).atLeast(1);
  declare.text("Concentration Field", "Label of the metal ions' concentration, as of the material.")
      .defaultTo("Concentration");
  declareTransportMethods(declare);
  declare
      .real("Fixed dt", "s",
            "Time step; without it, steps follow the tolerance and the front. Divided where the front would move more "
            "than twice Front Limit.")
      .positive();
  declare
      .real("Relative Tolerance", "1", "Error of one step, root of its mean square in the electrolyte, of saturation.")
      .defaultTo(1e-2)
      .positive();
  declare
      .real(
          "Front Limit", "1",
          "Most of a solid point's metal that a step should take, and half of what it may: how many spacings the front "
          "moves, about.")
      .defaultTo(0.5)
      .positive();
  declare.real("Maximum dt", "s", "Longest step; by default an increment.").positive();
}

Corrosion::Corrosion(const Teuchos::ParameterList& given) {
  const auto parameters = completed<Corrosion>(given, "Corrosion");
  field_ = parameters.get<std::string>("Concentration Field");
  rateField_ = fluxDivergenceField(field_);
  fields_ = Fields(field_);
  transport_ = makeTransportStep(parameters);
  const auto method = parameters.get<std::string>("Method");
  isByNewton_ = (method == "Backward Euler" || method == "SDIRK2") &&
                parameters.get<std::string>("Nonlinear Solver") == "Newton Krylov";
  nIncrements_ = parameters.get<int>("Load Steps");
  if (parameters.isParameter("Fixed dt")) fixedStep_ = parameters.get<double>("Fixed dt");
  tolerance_ = parameters.get<double>("Relative Tolerance");
  // A run that goes on from a checkpoint starts with what the tolerance of its steps has left.
  slack_ = std::max(1e-6, 10.0 * parameters.get<double>("Solver Tolerance"));
  frontLimit_ = parameters.get<double>("Front Limit");
  largestStep_ = parameters.isParameter("Maximum dt") ? parameters.get<double>("Maximum dt")
                                                      : std::numeric_limits<double>::infinity();
}

double Corrosion::leastSteps(double t0, double t1) const {
  const double longest = fixedStep_ > 0.0 ? std::min(fixedStep_, largestStep_) : largestStep_;
  return std::max(static_cast<double>(nIncrements_), (t1 - t0) / longest);
}

void Corrosion::initialize(Simulation& simulation) {
  Model& model = simulation.model;
  requireDissolution(model, field_);
  if (rateIsAsymmetric(model, field_) && !isByNewton_)
    throw RunError("Corrosion: a flow carries \"" + field_ +
                   "\", which takes \"Method: Backward Euler\" or SDIRK2 with \"Nonlinear Solver: Newton Krylov\"");
  requireConcentrations(model, field_, transport_->fullest(), slack_);
  initialMetal_ = metal(simulation);
}

double Corrosion::metal(Simulation& simulation) const {
  Model& model = simulation.model;
  const std::vector<char>& isHeld = simulation.conditions.valueIsPrescribed(field_);
  const double *volume = model.field("Volume"), *concentration = model.field(fields_.concentration);
  const double* saturation = model.field(fields_.saturation);
  double sum = 0.0;
  for (int i = 0; i < model.nOwned(); ++i)
    if (isHeld[static_cast<std::size_t>(i)] == 0 && saturation[i] > 0.0) sum += volume[i] * concentration[i];
  return model.comm().sum(sum);
}

double Corrosion::frontAdvance(Simulation& simulation) const {
  Model& model = simulation.model;
  const double* concentration = model.field(fields_.concentration);
  const double *solid = model.field(fields_.solid), *saturation = model.field(fields_.saturation);
  double largest = 0.0;
  for (const auto& [i, before] : untouched_)
    largest = std::max(largest, (before - concentration[i]) / (solid[i] - saturation[i]));
  return model.comm().max(largest);
}

/// Away from the interface, where rates jump as points change phase.
double Corrosion::timeError(Simulation& simulation, double h) const {
  Model& model = simulation.model;
  if (nSteps_ == 0) return 0.0;
  const double *volume = model.field("Volume"), *saturation = model.field(fields_.saturation);
  const double *area = model.field(fields_.area), *lastRate = model.field(fields_.lastRate);
  double square = 0.0, total = 0.0;
  for (std::size_t k = 0; k < lists_.liquid().size(); ++k) {
    const int i = lists_.liquid()[k];
    if (transport_->isUnknown()[k] == 0 || area[i] > 0.0 || std::isnan(lastRate[i])) continue;
    const double error = transport_->error(k, lastRate[i], h) / saturation[i];
    square += volume[i] * error * error;
    total += volume[i];
  }
  total = model.comm().sum(total);
  return total > 0.0 ? std::sqrt(model.comm().sum(square) / total) : 0.0;
}

void Corrosion::evaluateDamage(Model& model, double h) {
  model.evaluateDamage(h);
  const double* concentration = model.field(fields_.concentration);
  const std::vector<int> reached = lists_.update(model);
  model.touch(reached);
  for (const int i : reached) untouched_.push_back({i, concentration[i]});
}

bool Corrosion::carryOver(Simulation& simulation, double h) {
  Model& model = simulation.model;
  double *concentration = model.field(fields_.concentration), *demand = model.field(fields_.demand);
  const double *saturation = model.field(fields_.saturation), *rate = model.field(fields_.rate);
  double* salt = model.field(fields_.salt);
  const auto fillLiquid = [&](double* values, double value) {
    for (const int i : lists_.liquid()) values[i] = value;
    std::fill(values + model.nOwned(), values + model.nPoints(), value);
  };
  // Each pass reaches a horizon further.
  constexpr int maximumPasses = 20;
  for (int pass = 0; pass < maximumPasses; ++pass) {
    std::vector<std::pair<int, double>> debts;
    for (const int i : lists_.dissolving())
      if (concentration[i] < saturation[i]) {
        debts.emplace_back(i, saturation[i] - concentration[i]);
        concentration[i] = saturation[i];
      }
    model.importGhosts(field_);
    evaluateDamage(model, h);
    if (!model.comm().any(!debts.empty())) break;
    // With the electrolyte at one concentration and salt on all surfaces, nothing flows but the demand.
    const std::vector<int> liquid = lists_.liquid();
    std::vector<double> present, covered;
    for (const int i : liquid) {
      present.push_back(concentration[i]);
      covered.push_back(salt[i]);
    }
    fillLiquid(concentration, 0.0);
    fillLiquid(salt, 1.0);
    // What a demand of 1 brings, with the new interface.
    for (const auto& debt : debts) demand[debt.first] = 1.0;
    model.importGhosts("Dissolution_Demand");
    model.evaluateFluxDivergence(h, rateField_);
    for (const auto& [i, debt] : debts) demand[i] = rate[i] > 0.0 ? debt / rate[i] : 0.0;
    model.importGhosts("Dissolution_Demand");
    model.evaluateFluxDivergence(h, rateField_, true);
    for (std::size_t k = 0; k < liquid.size(); ++k) {
      concentration[liquid[k]] = present[k] + rate[liquid[k]];
      salt[liquid[k]] = covered[k];
    }
    for (const int i : lists_.dissolving()) concentration[i] += rate[i];
    for (const auto& [i, debt] : debts) concentration[i] -= debt;
    fillLiquid(demand, 0.0);
  }
  model.importGhosts(field_);
  bool owes = false;
  for (const int i : lists_.liquid()) owes = owes || concentration[i] < -1e-6 * saturation[i];
  for (const int i : lists_.dissolving()) owes = owes || concentration[i] < -1e-6 * saturation[i];
  return !model.comm().any(owes);
}

bool Corrosion::step(Simulation& simulation, double t, double h) {
  Model& model = simulation.model;
  const double* concentration = model.field(fields_.concentration);
  simulation.beginStep(lists_.liquid());
  model.touch(lists_.dissolving());
  const std::vector<double> before(concentration, concentration + (model.hasField("Loose") ? model.nOwned() : 0));
  untouched_.clear();
  for (const int i : lists_.dissolving()) untouched_.push_back({i, concentration[i]});
  if (!transport_->solve(simulation, lists_, t, h)) {
    simulation.takeBackStep();
    if (h < shortestTried_)
      throw RunError(
          fmt::format("Corrosion: t = {:.6g} s: {}. Raise \"Solver Tolerance\", or allow more linear iterations", t,
                      transport_->trouble()));
    return false;
  }
  advance_ = frontAdvance(simulation);
  error_ = timeError(simulation, h);
  surface_.take(model, transport_->points());
  const bool isTooLong =
      advance_ > 2.0 * frontLimit_ || (fixedStep_ == 0.0 && error_ > std::exp2(transport_->order() + 1) * tolerance_);
  if (isTooLong || !carryOver(simulation, h)) {
    simulation.takeBackStep();
    lists_.reset(model);
    if (h < shortestTried_) throw RunError(fmt::format("Corrosion: t = {:.6g} s: the front moves without end", t));
    return false;
  }
  if (!before.empty()) {
    dissolveLooseMetalFirst(model, field_, before, h);
    lists_.update(model);
  }
  const double* volume = model.field("Volume");
  double left = 0.0;
  double* lastRate = model.field(fields_.lastRate);
  for (std::size_t k = 0; k < transport_->points().size(); ++k) {
    const int i = transport_->points()[k];
    left += volume[i] * h * (transport_->isUnknown()[k] == 0 ? transport_->rate()[k] : -transport_->inflow()[k]);
    lastRate[i] = transport_->isUnknown()[k] != 0 ? transport_->endRate()[k] : std::numeric_limits<double>::quiet_NaN();
  }
  outflow_ += model.comm().sum(left);
  model.acceptStep(t + h, h);
  return true;
}

double Corrosion::nextStep(double h) const {
  const double byFront = advance_ > 0.0 ? frontLimit_ / advance_ : 2.0;
  const double byError = error_ > 0.0 ? 0.9 * std::pow(tolerance_ / error_, 1.0 / (transport_->order() + 1)) : 2.0;
  const double next = h * std::clamp(std::min(byFront, byError), 0.2, 2.0);
  // Of a ladder of steps, lest they carry what rounding leaves, different on every number of ranks, from step to step.
  constexpr double rungsPerOctave = 4.0;
  return std::exp2(std::floor(rungsPerOctave * std::log2(next) + 1e-6) / rungsPerOctave);
}

void Corrosion::advance(Simulation& simulation, double t, double dt) {
  requireFlow(simulation.model, field_, "Corrosion");
  const double end = t + dt;
  constexpr double ceilingGrowth = 1.1;  // what has failed is tried again only after some steps
  double now = t;
  if (proposedStep_ == 0.0) proposedStep_ = fixedStep_ > 0.0 ? fixedStep_ : 1e-4 * dt;
  shortestTried_ = 1e-10 * dt;
  surface_.hide(simulation.model);
  lists_.reset(simulation.model);
  if (nSteps_ == 0) {
    double* lastRate = simulation.model.field(fields_.lastRate);
    std::fill(lastRate, lastRate + simulation.model.nPoints(), std::numeric_limits<double>::quiet_NaN());
  }
  transport_->forget();
  if (mustForgetFactors_) transport_->forgetFactors();  // as a run does that goes on from there
  mustForgetFactors_ = false;
  while (end - now > 1e-12 * dt) {
    const double wanted = std::min({proposedStep_, largestStep_, end - now});
    // No sliver of a step is left before the end.
    const double left = end - now;
    const double h = wanted >= left * (1.0 - 1e-9)              ? left
                     : wanted > 0.5 * left && fixedStep_ == 0.0 ? 0.5 * left
                                                                : wanted;
    const bool isTaken = step(simulation, now, h);
    if (isTaken) {
      ++nSteps_;
      now += h;
      shortest_ = shortest_ == 0.0 ? h : std::min(shortest_, h);
      longest_ = std::max(longest_, h);
      ceiling_ *= ceilingGrowth;
      simulation.model.requireFinite(field_, static_cast<int>(nSteps_));
    } else {
      ++nRejected_;
      ceiling_ = 0.75 * h;
    }
    if (fixedStep_ > 0.0) {
      const double growth = advance_ < 0.9 * frontLimit_ ? 2.0 : 1.0;
      proposedStep_ = isTaken ? std::min(fixedStep_, growth * proposedStep_) : 0.5 * h;
    } else {
      const double next = isTaken ? nextStep(h) : std::min(0.5 * h, nextStep(h));
      // A step that was cut to meet the end says nothing about longer ones.
      proposedStep_ = isTaken && h < proposedStep_ ? std::max(next, std::min(proposedStep_, 2.0 * h)) : next;
      proposedStep_ = std::min(proposedStep_, ceiling_);
    }
  }
  // pH and what else follows from concentrations, for results.
  simulation.model.evaluateFluxDivergence(0.0, rateField_);
  surface_.show(simulation.model);
  balance_ = std::abs(metal(simulation) + outflow_ - initialMetal_) / std::max(initialMetal_, 1e-300);
}

std::vector<std::string> Corrosion::summary() const {
  return {fmt::format("Corrosion: {} steps of {:.3g} to {:.3g} s, {} rejected; {}", nSteps_, shortest_, longest_,
                      nRejected_, transport_->work()),
          fmt::format("Corrosion: metal in solid and electrolyte {:.6g} mol at the start, {:.6g} mol have left through "
                      "prescribed points and far fields; the balance is off by {:.2g} of it",
                      initialMetal_, outflow_, balance_)};
}

RestartState Corrosion::restartState() const {
  return {{"proposed step", proposedStep_},
          {"metal at the start", initialMetal_},
          {"outflow", outflow_},
          {"steps", static_cast<double>(nSteps_)},
          {"rejected steps", static_cast<double>(nRejected_)},
          {"shortest step", shortest_},
          {"longest step", longest_},
          {"longest step to try", ceiling_}};
}

void Corrosion::setRestartState(const RestartState& state) {
  proposedStep_ = state["proposed step"];
  if (fixedStep_ > 0.0) proposedStep_ = std::min(proposedStep_, fixedStep_);
  initialMetal_ = state["metal at the start"];
  outflow_ = state["outflow"];
  nSteps_ = static_cast<long long>(state["steps"]);
  nRejected_ = static_cast<long long>(state["rejected steps"]);
  shortest_ = state["shortest step"];
  longest_ = state["longest step"];
  ceiling_ = state["longest step to try"];
}

PD_REGISTER_SOLVER(Corrosion, "Corrosion", "Dissolution of metal and transport of its ions")

}  // namespace pd
