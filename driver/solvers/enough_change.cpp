#include "enough_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../deck/vector3.hpp"
#include "Peridigm_Field.hpp"

namespace pd {

namespace {

/// Bounds of one change of the amount: the two are proportional for small changes only.
constexpr double mostGrowth = 2.0, leastGrowth = 0.25;
/// What a solver's tolerance and rounding leave of a value's change where nothing has changed, over its size.
constexpr double noChange = 1e-6;

bool isGlobal(Model& model, const std::string& label) {
  return model.hasField(label) &&
         PeridigmNS::FieldManager::self().getFieldSpec(label).relation == PeridigmNS::PeridigmField::GLOBAL;
}

/// Where the label is that of a column of a vector's history, as DragX of Drag.
std::string vectorOf(Model& model, const std::string& label) {
  if (label.empty() || std::string("XYZ").find(label.back()) == std::string::npos) return "";
  std::string vector = label.substr(0, label.size() - 1);
  return isGlobal(model, vector) && model.fieldWidth(vector) == 3 ? vector : "";
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
            "and at least a quarter of what it was; it stays where the value has changed by less than 1e-6 of its "
            "size.");
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

void EnoughChange::initialize(Simulation& simulation, const std::string& owner) {
  if (!isControlled()) return;
  Model& model = simulation.model;
  if (const std::string vector = vectorOf(model, label_); !isGlobal(model, label_) && !vector.empty())
    throw RunError(fmt::format("Staggered: {}: \"{}\" of When/Value is a component; give the vector, \"{}\"", owner,
                               label_, vector));
  if (!isGlobal(model, label_) || model.fieldWidth(label_) > 3 || !simulation.output.makesGlobal(label_))
    throw RunError(
        fmt::format("Staggered: {}: \"{}\" of When/Value is no value for the whole body that a compute of this run "
                    "gives; name the Output Label of one in Compute Class Parameters",
                    owner, label_));
  if (simulation.output.keepsEvaluations(label_))
    throw RunError(
        fmt::format("Staggered: {}: \"{}\" of When/Value counts from what its compute found at earlier outputs, which "
                    "looking at it between them would change; name one that depends on the state alone, as Flow_Force",
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
  simulation.output.evaluateGlobal(model, label_);
  const double* first = model.field(label_);
  Vector3 value{};
  std::copy(first, first + model.fieldWidth(label_), value.begin());
  const Vector3 before = value_;
  const bool hadValue = hasValue_;
  value_ = value;
  hasValue_ = true;
  if (!hadValue || change_ == 0.0) return;
  const double size = std::max(length(value), length(before)), changed = length(difference(value, before));
  if (!std::isfinite(changed) || changed <= noChange * size) {
    if (!hasWarned_)
      simulation.output.log(
          fmt::format("Staggered: warning: {}: \"{}\" of When/Value is {:g} after this run and {:g} after the last "
                      "one, from which nothing follows for Has Changed By; where it does not depend on what {} finds, "
                      "it cannot say when to run",
                      owner, label_, length(value), length(before), owner));
    hasWarned_ = true;
    return;
  }
  largestChange_ = std::max(largestChange_, changed / size);
  const double wanted = change_ * wanted_ * size / changed;
  amount_ = std::min(std::max(wanted, leastGrowth * amount_), mostGrowth * amount_);
}

RestartState EnoughChange::restartState() const {
  RestartState state = {{"amount", amount_},
                        {"has run", hasRun_ ? 1.0 : 0.0},
                        {"change", change_},
                        {"largest change", largestChange_},
                        {"has value", hasValue_ ? 1.0 : 0.0}};
  for (std::size_t a = 0; a < value_.size(); ++a) state.add("value " + std::to_string(a), value_[a]);
  return state;
}

void EnoughChange::setRestartState(const RestartState& state) {
  amount_ = state["amount"];
  hasRun_ = state["has run"] != 0.0;
  change_ = state["change"];
  largestChange_ = state["largest change"];
  hasValue_ = state["has value"] != 0.0;
  for (std::size_t a = 0; a < value_.size(); ++a) value_[a] = state["value " + std::to_string(a)];
}

}  // namespace pd
