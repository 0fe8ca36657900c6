#include "condition.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>

namespace pd {

namespace {

struct Type {
  ConditionKind kind;
  std::string field;  ///< empty: the key Field
};

const std::map<std::string, Type>& types() {
  static const std::map<std::string, Type> known = {
      {"Initial Displacement", {ConditionKind::InitialDisplacement, "Displacement"}},
      {"Initial Velocity", {ConditionKind::InitialVelocity, "Velocity"}},
      {"Initial Value", {ConditionKind::InitialValue, ""}},
      {"Initial Temperature", {ConditionKind::InitialValue, "Temperature"}},
      {"Initial Concentration", {ConditionKind::InitialValue, "Concentration"}},
      {"Prescribed Displacement", {ConditionKind::PrescribedDisplacement, "Displacement"}},
      {"Prescribed Value", {ConditionKind::PrescribedValue, ""}},
      {"Prescribed Temperature", {ConditionKind::PrescribedValue, "Temperature"}},
      {"Prescribed Concentration", {ConditionKind::PrescribedValue, "Concentration"}},
      {"Body Force", {ConditionKind::BodyForce, "Force_Density"}},
      {"Traction", {ConditionKind::Traction, "Force_Density"}},
      {"No Failure", {ConditionKind::NoFailure, "No_Failure"}},
      {"Saturated Crack Faces", {ConditionKind::SaturatedCrackFaces, ""}},
      {"Far Field Concentration", {ConditionKind::FarField, "Concentration"}},
  };
  return known;
}

/// Peridigm takes names of node sets with any case and with blanks or underscores.
std::string plainName(const std::string& name) {
  std::string result;
  for (const char c : name) result += c == ' ' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  while (!result.empty() && result.back() == '_') result.pop_back();
  return result;
}

std::vector<int> pointsOf(const DeckNode& node, const Discretization& discretization) {
  const DeckNode setNode = node["Node Set"];
  if (!setNode) {
    std::vector<int> all(static_cast<std::size_t>(discretization.nPoints));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }
  const std::string name = setNode.text();
  std::string known;
  for (const auto& [other, points] : discretization.nodeSets) {
    if (plainName(other) == plainName(name)) return points;
    known += (known.empty() ? "\"" : ", \"") + other + "\"";
  }
  throw DeckError(setNode.place() + ": no node set \"" + name + "\" (node sets: " + (known.empty() ? "none" : known) +
                  ")");
}

int componentOf(const DeckNode& node) {
  const std::string name = node.text("Coordinate", "x");
  if (name.size() == 1) {
    const auto letter = std::string("xyz").find(static_cast<char>(std::tolower(static_cast<unsigned char>(name[0]))));
    if (letter != std::string::npos) return static_cast<int>(letter);
  }
  throw DeckError(node["Coordinate"].place() + ": Coordinate is \"" + name + "\", must be x, y or z");
}

DeckNode needed(const DeckNode& node, const std::string& key) {
  if (!node[key]) throw DeckError(node.keyPlace() + ": this condition needs the key \"" + key + "\"");
  return node[key];
}

Condition readCondition(const std::string& name, const DeckNode& node, const Discretization& discretization) {
  const std::string typeName = needed(node, "Type").text();
  const auto type = types().find(typeName);
  if (type == types().end()) throw DeckError(node["Type"].place() + ": unknown type of condition \"" + typeName + "\"");
  Condition condition;
  condition.name = name;
  condition.node = node;
  condition.kind = type->second.kind;
  condition.field = type->second.field.empty() ? needed(node, "Field").text() : type->second.field;
  const ConditionKind kind = condition.kind;
  if (kind != ConditionKind::SaturatedCrackFaces) needed(node, "Node Set");
  condition.points = pointsOf(node, discretization);
  if (kind == ConditionKind::InitialDisplacement || kind == ConditionKind::InitialVelocity ||
      kind == ConditionKind::PrescribedDisplacement || condition.isForce())
    condition.component = componentOf(node);
  if (kind != ConditionKind::NoFailure) condition.value = Function::fromDeck(needed(node, "Value"));
  if (kind == ConditionKind::SaturatedCrackFaces) condition.threshold = needed(node, "Threshold").real();
  if (kind == ConditionKind::Traction || kind == ConditionKind::FarField) condition.area = needed(node, "Area").real();
  if (kind == ConditionKind::FarField) {
    condition.diffusivity = needed(node, "Diffusivity").real();
    condition.distance = needed(node, "Distance").real();
  }
  return condition;
}

}  // namespace

const std::vector<double>& Condition::evaluate(const std::vector<double>& x, double t) const {
  if (!values_.empty() && (!value.dependsOnTime() || t == evaluatedAt_)) return values_;
  values_.resize(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double* place = x.data() + 3 * static_cast<std::size_t>(points[k]);
    values_[k] = value(place[0], place[1], place[2], t);
  }
  evaluatedAt_ = t;
  return values_;
}

std::vector<Condition> readConditions(const Deck& deck, const Discretization& discretization, Mistakes& mistakes) {
  std::vector<Condition> conditions;
  if (!deck["Boundary Conditions"]) return conditions;
  for (const auto& [name, node] : deck["Boundary Conditions"].entries()) {
    if (plainName(name).find("NODE_SET") != std::string::npos || !node.isMap()) continue;
    try {
      conditions.push_back(readCondition(name, node, discretization));
    } catch (const DeckError& error) {
      mistakes.add("", error.what());
    }
  }
  return conditions;
}

bool haveSameValue(const Condition& a, const Condition& b) {
  if (a.value.isConstant() && b.value.isConstant()) return a.value(0, 0, 0, 0) == b.value(0, 0, 0, 0);
  const DeckNode first = a.node["Value"], second = b.node["Value"];
  return first.isScalar() && second.isScalar() && first.text() == second.text();
}

}  // namespace pd
