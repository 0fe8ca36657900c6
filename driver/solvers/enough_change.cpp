#include "enough_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "Peridigm_Field.hpp"

namespace pd {

namespace {

/// Bounds of one change of the amount: the two are proportional for small changes only.
constexpr double mostGrowth = 2.0, leastGrowth = 0.25;

double sizeOf(const std::vector<double>& values) {
  double square = 0.0;
  for (const double value : values) square += value * value;
  return std::sqrt(square);
}

}  // namespace

void EnoughChange::declareParameters(ParameterDeclarations& when) {
  when.real("Has Changed By", "unit of the field",
            "Change since the solver last ran, or since the start of the run, from which on it runs: the largest of a "
            "value at any point; with \"Measure: Volume\" times m3. With Value at first.")
      .positive()
      .required();
  when.text("Value",
            "Output Label of a compute that makes one value (or vector) of what the solver finds, such as the drag of "
            "a flow: after each run Has Changed By becomes what would have changed it by Value Change, at most twice "
            "and at least a quarter of what it was.");
  when.real("Value Change", "1", "Change of Value from run to run that is aimed at, over its size.")
      .strictlyBetween(0.0, 1.0);
  when.needs("Value", {"Value Change"});
  when.needs("Value Change", {"Value"});
}

EnoughChange::EnoughChange(const Teuchos::ParameterList& when) : amount_(when.get<double>("Has Changed By")) {
  if (!when.isParameter("Value")) return;
  label_ = when.get<std::string>("Value");
  wanted_ = when.get<double>("Value Change");
}

void EnoughChange::initialize(Model& model, const std::string& owner) const {
  if (!isControlled()) return;
  const bool isThere = model.hasField(label_) && PeridigmNS::FieldManager::self().getFieldSpec(label_).relation ==
                                                     PeridigmNS::PeridigmField::GLOBAL;
  if (!isThere)
    throw RunError(
        fmt::format("Staggered: {}: \"{}\" of When/Value is no value for the whole body that a compute of this run "
                    "gives; name the Output Label of one in Compute Class Parameters",
                    owner, label_));
}

void EnoughChange::solverHasRun(double change) {
  hasRun_ = true;
  change_ = change;
}

void EnoughChange::look(Simulation& simulation, const std::string& owner) {
  if (!isControlled() || !hasRun_) return;
  hasRun_ = false;
  Model& model = simulation.model;
  if (model.hasField("Displacement")) model.updateCoordinates();
  simulation.output.evaluateGlobals(model);
  const double* first = model.field(label_);
  const std::vector<double> value(first, first + model.fieldWidth(label_));
  const std::vector<double> before = value_;
  value_ = value;
  if (before.empty() || change_ == 0.0) return;
  std::vector<double> difference(value.size());
  for (std::size_t a = 0; a < value.size(); ++a) difference[a] = value[a] - before[a];
  const double size = std::max(sizeOf(value), sizeOf(before)), changed = sizeOf(difference);
  if (changed == 0.0)
    simulation.output.log(
        fmt::format("Staggered: warning: {}: \"{}\" of When/Value is {:g} after this run as after the last one; where "
                    "it does not depend on what {} finds, it cannot say when to run",
                    owner, label_, sizeOf(value), owner));
  const double wanted = changed > 0.0 ? change_ * wanted_ * size / changed : mostGrowth * amount_;
  amount_ = std::min(std::max(wanted, leastGrowth * amount_), mostGrowth * amount_);
}

RestartState EnoughChange::restartState() const {
  RestartState state = {{"amount", amount_},
                        {"has run", hasRun_ ? 1.0 : 0.0},
                        {"change", change_},
                        {"width", static_cast<double>(value_.size())}};
  for (std::size_t a = 0; a < value_.size(); ++a) state.add("value " + std::to_string(a), value_[a]);
  return state;
}

void EnoughChange::setRestartState(const RestartState& state) {
  if (!isControlled()) return;
  amount_ = state["amount"];
  hasRun_ = state["has run"] != 0.0;
  change_ = state["change"];
  value_.clear();
  for (int a = 0; a < static_cast<int>(state["width"]); ++a) value_.push_back(state["value " + std::to_string(a)]);
}

}  // namespace pd
