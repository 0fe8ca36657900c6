#include "boundary_conditions.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "../model/collective.hpp"
#include "../model/solver_sections.hpp"
#include "Peridigm_Field.hpp"
#include "condition.hpp"
#include "far_field.hpp"

namespace pd {

using PeridigmNS::FieldManager;
using namespace PeridigmNS::PeridigmField;

namespace {

std::string sourceField(const std::string& field) { return field + "_Source"; }

}  // namespace

struct BoundaryConditions::Implementation {
  Model& model;
  double initialTime = 0.0;
  double appliedAt = 0.0;
  bool wasApplied = false;
  std::vector<Condition> conditions;
  bool addsIncrements = false;                ///< of prescribed displacements, as Peridigm
  std::vector<std::vector<double>> previous;  ///< prescribed displacements of the last call, by condition
  std::vector<std::vector<double>> offsets;   ///< of these over the values of the condition
  std::vector<char> displacementMask;
  std::map<std::string, std::vector<char>> valueMasks;
  std::vector<char> emptyMask;
  FarField farField;

  explicit Implementation(Model& theModel) : model(theModel) {}
  std::size_t nPoints() const { return static_cast<std::size_t>(model.nPoints()); }
  const std::vector<double>& x() const { return model.discretization().x; }

  void allocate(const Condition& condition);
  void findConflicts(bool laterOneHolds);
  void scaleByVolume();
  void write(const Condition& condition, double t);
  void setDisplacement(std::size_t which, double t);
  void updateOffsets(std::size_t which, double t);
  void setSources(const Condition& condition, double t);
};

void BoundaryConditions::Implementation::allocate(const Condition& condition) {
  auto& fields = FieldManager::self();
  if (condition.kind == ConditionKind::InitialVelocity)
    model.allocateFields({fields.getFieldId(NODE, VECTOR, TWO_STEP, "Velocity")});
  // A plug-in may leave it to the host to allocate a field that it can do without.
  if (!model.hasField(condition.field) && fields.hasField(condition.field) &&
      fields.getFieldSpec(condition.field).relation != BOND)
    model.allocateFields({fields.getFieldId(condition.field)});
  if (!model.hasField(condition.field))
    throw DeckError(condition.node.keyPlace() + ": condition \"" + condition.name + "\" acts on the field \"" +
                    condition.field + "\", which no material, damage model or solver of this deck uses");
  const int width = model.fieldWidth(condition.field);
  if (width != 1 && condition.field != "Displacement" && condition.field != "Velocity" && !condition.isForce())
    throw DeckError(condition.node.keyPlace() + ": field \"" + condition.field + "\" has " + std::to_string(width) +
                    " values a point; conditions set fields of one value");
  if (condition.kind != ConditionKind::SaturatedCrackFaces) return;
  if (!model.hasField("Damage"))
    throw DeckError(condition.node.keyPlace() + ": condition \"" + condition.name +
                    "\" needs the field Damage; give a block a damage model");
  model.allocateFields({fields.getFieldId(NODE, SCALAR, CONSTANT, sourceField(condition.field))});
}

void BoundaryConditions::Implementation::findConflicts(bool laterOneHolds) {
  Mistakes mistakes;
  std::map<std::string, std::vector<int>> setBy;  // index of the condition for each degree of freedom
  std::set<std::pair<int, int>> reported;
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    const Condition& condition = conditions[c];
    const bool isDisplacement = condition.kind == ConditionKind::PrescribedDisplacement;
    if (!isDisplacement && condition.kind != ConditionKind::PrescribedValue) continue;
    const std::size_t width = isDisplacement ? 3 : 1;
    std::vector<int>& owners = setBy[condition.field];
    owners.resize(width * nPoints(), -1);
    for (const int point : condition.points) {
      int& owner = owners[width * static_cast<std::size_t>(point) + static_cast<std::size_t>(condition.component)];
      const int self = static_cast<int>(c);
      if (owner >= 0 && owner != self && !laterOneHolds && point < model.nOwned() &&
          !haveSameValue(condition, conditions[static_cast<std::size_t>(owner)]) &&
          reported.insert({owner, self}).second)
        mistakes.add(condition.node.keyPlace(),
                     "conditions \"" + conditions[static_cast<std::size_t>(owner)].name + "\" and \"" + condition.name +
                         "\" prescribe different values of the same " + condition.field +
                         (isDisplacement ? std::string(" component ") + "xyz"[condition.component] : std::string()) +
                         " where their node sets overlap; take those points out of one of the node sets");
      owner = self;
    }
  }
  mistakes.report();
}

void BoundaryConditions::Implementation::scaleByVolume() {
  for (Condition& condition : conditions) {
    if (condition.kind != ConditionKind::Traction && condition.kind != ConditionKind::FarField) continue;
    double volume = 0.0;
    for (const int point : condition.points)
      if (point < model.nOwned()) volume += model.discretization().volume[static_cast<std::size_t>(point)];
    volume = model.comm().sum(volume);
    if (condition.kind == ConditionKind::FarField)
      condition.exchangeRate = exchangeRate(condition.diffusivity, condition.distance, volume / condition.area);
    else
      condition.scale = condition.area / volume;
  }
}

void BoundaryConditions::Implementation::write(const Condition& condition, double t) {
  double* values = model.field(condition.field);
  const int width = model.fieldWidth(condition.field);
  const std::vector<double>& given = condition.evaluate(x(), t);
  for (std::size_t k = 0; k < given.size(); ++k) values[width * condition.points[k] + condition.component] = given[k];
}

void BoundaryConditions::Implementation::setDisplacement(std::size_t which, double t) {
  const Condition& condition = conditions[which];
  if (addsIncrements && t != appliedAt && wasApplied) updateOffsets(which, t);
  std::vector<double> now = condition.evaluate(x(), t);
  double* displacement = model.field("Displacement");
  for (std::size_t k = 0; k < now.size(); ++k) {
    double& value = displacement[3 * condition.points[k] + condition.component];
    if (addsIncrements && !wasApplied) {
      offsets[which].push_back(value - now[k]);
      now[k] = value;
    } else if (addsIncrements) {
      now[k] += offsets[which][k];
    }
    value = now[k];
  }
  if (t == appliedAt && wasApplied) return;
  if (wasApplied && model.hasField("Velocity")) {
    double* velocity = model.field("Velocity");
    for (std::size_t k = 0; k < now.size(); ++k)
      velocity[3 * condition.points[k] + condition.component] = (now[k] - previous[which][k]) / (t - appliedAt);
  }
  previous[which] = std::move(now);
}

/// In Peridigm a displacement changes by what the value changes in a step; where that is nothing, it becomes the value.
void BoundaryConditions::Implementation::updateOffsets(std::size_t which, double t) {
  const Condition& condition = conditions[which];
  const std::vector<double> before = condition.evaluate(x(), appliedAt), now = condition.evaluate(x(), t);
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k] == before[k]) offsets[which][k] = 0.0;
}

void BoundaryConditions::Implementation::setSources(const Condition& condition, double t) {
  const double* isSource = model.field(sourceField(condition.field));
  double* values = model.field(condition.field);
  const std::vector<double>& given = condition.evaluate(x(), t);
  for (std::size_t k = 0; k < given.size(); ++k)
    if (isSource[condition.points[k]] != 0.0) values[condition.points[k]] = given[k];
}

BoundaryConditions::BoundaryConditions(const Deck& deck, Model& model)
    : implementation_(std::make_unique<Implementation>(model)) {
  auto& self = *implementation_;
  self.initialTime = pd::initialTime(deck);
  collectively(model.comm(), [&] {
    Mistakes mistakes;
    self.conditions = readConditions(deck, model.discretization(), mistakes);
    for (const Condition& condition : self.conditions) {
      try {
        self.allocate(condition);
      } catch (const DeckError& error) {
        mistakes.add("", error.what());
      }
    }
    mistakes.report();
    self.findConflicts(deck.isPeridigmDeck());
  });
  self.scaleByVolume();
  self.addsIncrements = deck.isPeridigmDeck();
  self.previous.resize(self.conditions.size());
  self.offsets.resize(self.conditions.size());
  self.displacementMask.assign(3 * self.nPoints(), 0);
  self.emptyMask.assign(self.nPoints(), 0);
  for (const Condition& condition : self.conditions) {
    if (condition.kind == ConditionKind::PrescribedDisplacement)
      for (const int point : condition.points) self.displacementMask[3 * point + condition.component] = 1;
    if (condition.kind != ConditionKind::PrescribedValue && condition.kind != ConditionKind::SaturatedCrackFaces)
      continue;
    std::vector<char>& mask = self.valueMasks[condition.field];
    mask.resize(self.nPoints(), 0);
    if (condition.kind == ConditionKind::PrescribedValue)
      for (const int point : condition.points) mask[static_cast<std::size_t>(point)] = 1;
  }
}

BoundaryConditions::~BoundaryConditions() = default;

void BoundaryConditions::applyInitial() {
  auto& self = *implementation_;
  for (const Condition& condition : self.conditions) {
    if (condition.isInitial()) self.write(condition, self.initialTime);
    if (condition.kind != ConditionKind::NoFailure) continue;
    double* noFailure = self.model.field(condition.field);
    for (const int point : condition.points) noFailure[point] = 1.0;
  }
}

void BoundaryConditions::applyPrescribed(double t) {
  auto& self = *implementation_;
  for (std::size_t c = 0; c < self.conditions.size(); ++c)
    if (self.conditions[c].kind == ConditionKind::PrescribedDisplacement) self.setDisplacement(c, t);
  for (const auto& entry : self.valueMasks) applyPrescribedValue(entry.first, t);
  self.appliedAt = t;
  self.wasApplied = true;
}

void BoundaryConditions::applyPrescribedValue(const std::string& field, double t) {
  auto& self = *implementation_;
  // Sources first: a prescribed value holds where both claim a point.
  for (const Condition& condition : self.conditions)
    if (condition.kind == ConditionKind::SaturatedCrackFaces && condition.field == field) self.setSources(condition, t);
  for (const Condition& condition : self.conditions)
    if (condition.kind == ConditionKind::PrescribedValue && condition.field == field) self.write(condition, t);
}

const BoundaryConditions::FarField& BoundaryConditions::farField(const std::string& field, double t) {
  auto& self = *implementation_;
  FarField& result = self.farField;
  result = FarField{};
  for (const Condition& condition : self.conditions) {
    if (condition.kind != ConditionKind::FarField || condition.field != field) continue;
    result.coefficient.resize(static_cast<std::size_t>(self.model.nOwned()), 0.0);
    result.value.resize(result.coefficient.size(), 0.0);
    const std::vector<double>& given = condition.evaluate(self.x(), t);
    for (std::size_t k = 0; k < given.size(); ++k) {
      if (condition.points[k] >= self.model.nOwned()) continue;
      // Where two act, to both.
      const auto i = static_cast<std::size_t>(condition.points[k]);
      const double sum = result.coefficient[i] + condition.exchangeRate;
      result.value[i] += (given[k] - result.value[i]) * condition.exchangeRate / sum;
      result.coefficient[i] = sum;
    }
  }
  return result;
}

bool BoundaryConditions::prescribedValueDependsOnTime(const std::string& field) const {
  const auto& conditions = implementation_->conditions;
  return std::any_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
    return condition.field == field && !condition.isInitial() && condition.kind != ConditionKind::FarField &&
           condition.value.dependsOnTime();
  });
}

void BoundaryConditions::addExternalForce(double t, double* forceDensity) const {
  const auto& self = *implementation_;
  for (const Condition& condition : self.conditions) {
    if (!condition.isForce()) continue;
    const std::vector<double>& given = condition.evaluate(self.x(), t);
    for (std::size_t k = 0; k < given.size(); ++k)
      if (condition.points[k] < self.model.nOwned())
        forceDensity[3 * condition.points[k] + condition.component] += condition.scale * given[k];
  }
}

bool BoundaryConditions::hasExternalForce() const {
  const auto& conditions = implementation_->conditions;
  return std::any_of(conditions.begin(), conditions.end(), [](const Condition& c) { return c.isForce(); });
}

long long BoundaryConditions::updateDamageSources() {
  auto& self = *implementation_;
  long long nNew = 0;
  bool hasAny = false;
  for (const Condition& condition : self.conditions) {
    if (condition.kind != ConditionKind::SaturatedCrackFaces) continue;
    hasAny = true;
    const double* damage = self.model.field("Damage");
    double* isSource = self.model.field(sourceField(condition.field));
    std::vector<char>& mask = self.valueMasks[condition.field];
    for (const int point : condition.points) {
      if (damage[point] <= condition.threshold || isSource[point] != 0.0 || mask[static_cast<std::size_t>(point)])
        continue;
      isSource[point] = 1.0;
      mask[static_cast<std::size_t>(point)] = 1;
      if (point < self.model.nOwned()) ++nNew;
    }
    self.setSources(condition, self.appliedAt);
  }
  return hasAny ? self.model.comm().sum(nNew) : 0;
}

void BoundaryConditions::resume(double t) {
  auto& self = *implementation_;
  for (std::size_t c = 0; c < self.conditions.size(); ++c) {
    const Condition& condition = self.conditions[c];
    if (condition.kind == ConditionKind::PrescribedDisplacement) {
      const double* displacement = self.model.field("Displacement");
      self.previous[c].resize(condition.points.size());
      self.offsets[c] = condition.evaluate(self.x(), t);
      for (std::size_t k = 0; k < condition.points.size(); ++k) {
        self.previous[c][k] = displacement[3 * condition.points[k] + condition.component];
        self.offsets[c][k] = self.previous[c][k] - self.offsets[c][k];
      }
    }
    if (condition.kind != ConditionKind::SaturatedCrackFaces) continue;
    const double* isSource = self.model.field(sourceField(condition.field));
    for (const int point : condition.points)
      if (isSource[point] != 0.0) self.valueMasks[condition.field][static_cast<std::size_t>(point)] = 1;
  }
  self.appliedAt = t;
  self.wasApplied = true;
}

const std::vector<char>& BoundaryConditions::displacementIsPrescribed() const {
  return implementation_->displacementMask;
}

const std::vector<char>& BoundaryConditions::valueIsPrescribed(const std::string& field) const {
  const auto found = implementation_->valueMasks.find(field);
  return found == implementation_->valueMasks.end() ? implementation_->emptyMask : found->second;
}

}  // namespace pd
