#include "boundary_conditions.hpp"

#include <algorithm>

#include "../model/collective.hpp"
#include "../model/solver_sections.hpp"
#include "Peridigm_Field.hpp"
#include "condition_set.hpp"

namespace pd {

using PeridigmNS::FieldManager;

namespace {

void allocate(const Condition& condition, Model& model) {
  auto& fields = FieldManager::self();
  const std::string& field = condition.field();
  model.allocateFields(condition.fieldIds());
  // A plug-in may leave it to the host to allocate a field that it can do without.
  if (!model.hasField(field) && fields.hasField(field) &&
      fields.getFieldSpec(field).relation != PeridigmNS::PeridigmField::BOND)
    model.allocateFields({fields.getFieldId(field)});
  const std::string place = condition.node().keyPlace() + ": ";
  if (!model.hasField(field))
    throw DeckError(place + condition.title() + " acts on the field \"" + field +
                    "\", which no material, damage model or solver of this deck uses");
  if (model.fieldWidth(field) != condition.width())
    throw DeckError(place + "field \"" + field + "\" has " + std::to_string(model.fieldWidth(field)) +
                    " values a point; " + condition.title() + " sets fields of " + std::to_string(condition.width()));
  if (condition.followsDamage() && !model.hasField("Damage"))
    throw DeckError(place + condition.title() + " needs the field Damage; give a block a damage model");
}

}  // namespace

BoundaryConditions::BoundaryConditions(const Deck& deck, Model& model)
    : model_(model), initialTime_(pd::initialTime(deck)) {
  conditions_ = readConditions(deck, model.discretization(), model.comm(),
                               [&](const Condition& condition) { allocate(condition, model); });
  nowhere_.assign(static_cast<std::size_t>(model.nPoints()), 0);
  isPrescribed_["Displacement"].assign(3 * nowhere_.size(), 0);
  for (const auto& condition : conditions_) {
    std::vector<char>& isPrescribed = isPrescribed_[condition->field()];
    isPrescribed.resize(static_cast<std::size_t>(condition->width()) * nowhere_.size(), 0);
    condition->markPrescribed(isPrescribed);
  }
}

BoundaryConditions::~BoundaryConditions() = default;

std::vector<std::string> BoundaryConditions::notes() const {
  std::vector<std::string> lines;
  for (const auto& condition : conditions_)
    if (std::string note = condition->note(); !note.empty()) lines.push_back(std::move(note));
  return lines;
}

void BoundaryConditions::setTimeScale(double scale) {
  timeScale_ = scale;
  for (const auto& condition : conditions_) condition->setTimeScale(scale);
}

/// A value that is not finite may be met on one rank alone.
template <class Hook>
void BoundaryConditions::callEach(const Hook& hook) const {
  orAbort(model_.comm(), [&] {
    for (const auto& condition : conditions_) hook(*condition);
  });
}

void BoundaryConditions::applyInitial() {
  callEach([&](Condition& condition) { condition.applyInitial(model_, initialTime_); });
}

void BoundaryConditions::applyPrescribed(double ownTime) {
  const double t = runTime(ownTime);
  callEach([&](Condition& condition) { condition.applyPrescribed(model_, t); });
  appliedAt_ = t;
}

void BoundaryConditions::applyPrescribedValue(const std::string& field, double t) {
  callEach([&](Condition& condition) {
    if (condition.field() == field) condition.applyPrescribed(model_, runTime(t));
  });
}

const FarField& BoundaryConditions::farField(const std::string& field, double t) {
  farField_.coefficient.clear();
  farField_.value.clear();
  callEach([&](const Condition& condition) {
    if (!condition.reachesBeyond() || condition.field() != field) return;
    farField_.coefficient.resize(static_cast<std::size_t>(model_.nOwned()), 0.0);
    farField_.value.resize(farField_.coefficient.size(), 0.0);
    condition.addFarField(model_.discretization(), runTime(t), farField_);
  });
  return farField_;
}

bool BoundaryConditions::prescribedValueDependsOnTime(const std::string& field) const {
  return std::any_of(conditions_.begin(), conditions_.end(), [&](const auto& condition) {
    return condition->field() == field && condition->isPrescription() && condition->dependsOnTime();
  });
}

void BoundaryConditions::addExternalForce(double t, double* forceDensity) const {
  callEach([&](const Condition& condition) {
    condition.addForceDensity(model_.discretization(), runTime(t), forceDensity);
  });
}

bool BoundaryConditions::hasExternalForce() const {
  return std::any_of(conditions_.begin(), conditions_.end(), [](const auto& condition) { return condition->isLoad(); });
}

long long BoundaryConditions::updateDamageSources() {
  long long nNew = 0;
  bool hasAny = false;
  callEach([&](Condition& condition) {
    if (!condition.followsDamage()) return;
    hasAny = true;
    nNew += condition.damageHasChanged(model_, appliedAt_, isPrescribed_[condition.field()]);
  });
  return hasAny ? model_.comm().sum(nNew) : 0;
}

void BoundaryConditions::beginStep() {
  for (const auto& condition : conditions_) condition->beginStep();
  appliedBeforeStep_ = appliedAt_;
}

void BoundaryConditions::takeBackStep() {
  for (const auto& condition : conditions_) condition->takeBackStep(model_, isPrescribed_[condition->field()]);
  appliedAt_ = appliedBeforeStep_;
}

/// Bonds that never break are those that the deck names now, not those of the checkpoint.
void BoundaryConditions::markNoFailure() {
  const char* const label = "No_Failure";
  if (!model_.hasField(label)) return;
  std::fill_n(model_.field(label), model_.nPoints(), 0.0);
  callEach([&](Condition& condition) {
    if (condition.field() == label) condition.applyInitial(model_, initialTime_);
  });
}

void BoundaryConditions::resume(double t) {
  markNoFailure();
  callEach([&](Condition& condition) { condition.resume(model_, t, isPrescribed_[condition.field()]); });
  appliedAt_ = t;
}

const std::vector<char>& BoundaryConditions::displacementIsPrescribed() const {
  return valueIsPrescribed("Displacement");
}

const std::vector<char>& BoundaryConditions::valueIsPrescribed(const std::string& field) const {
  const auto found = isPrescribed_.find(field);
  return found == isPrescribed_.end() ? nowhere_ : found->second;
}

}  // namespace pd
