#include "condition_set.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "../discretization/node_sets.hpp"
#include "../model/collective.hpp"
#include "../model/solver_sections.hpp"
#include "boundary_conditions.hpp"
#include "flow_boundary.hpp"

namespace pd {

namespace {

Teuchos::RCP<Condition> createCondition(const std::string& name, const DeckNode& node) {
  const DeckNode type = node["Type"];
  if (!type) throw DeckError(node.keyPlace() + ": this condition needs the key \"Type\"");
  const auto* plugin = ConditionRegistry::self().find(type.text());
  if (plugin == nullptr) throw DeckError(type.place() + ": unknown type of condition \"" + type.text() + "\"");
  try {
    return plugin->create({name, node, node.parameters(plugin->declare())});
  } catch (const std::invalid_argument& error) {
    throw DeckError(node.keyPlace() + ": " + node.path() + ": " + error.what());
  }
}

bool haveSameValue(const Condition& a, const Condition& b) {
  const DeckNode first = a.node()["Value"], second = b.node()["Value"];
  return first.isScalar() && second.isScalar() && first.text() == second.text();
}

/// Times at which a condition is tried before the run.
std::vector<double> trialTimes(const Condition& condition, const Deck& deck) {
  const double start = initialTime(deck), length = finalTime(deck) - start;
  if (!condition.dependsOnTime()) return {start};
  constexpr int nParts = 8;
  std::vector<double> times;
  // What acts by its rate, or as a load, is not asked for at the start.
  for (int k = condition.isPrescription() ? 0 : 1; k <= nParts; ++k) times.push_back(start + length * k / nParts);
  return times;
}

/// Those of the conditions whose values are finite, and that set nothing out of a plane; mistakes of the others are
/// added.
ConditionSet withFiniteValues(const ConditionSet& conditions, const Deck& deck, const Discretization& mesh,
                              Mistakes& mistakes) {
  ConditionSet good;
  for (const auto& condition : conditions) try {
      for (const double t : trialTimes(*condition, deck)) {
        const std::vector<double>& values = condition->evaluate(mesh, t);
        const bool setsVectors = condition->width() == 3 && !condition->claim().empty();
        if (setsVectors && std::any_of(values.begin(), values.end(), [](double value) { return value != 0.0; }))
          condition->requireMotionAlong(condition->component(), mesh);
      }
      good.push_back(condition);
    } catch (const DeckError& error) {
      mistakes.add("", error.what());
    }
  return good;
}

/// Two conditions that want different things of one point.
class ConflictFinder {
 public:
  ConflictFinder(const ConditionSet& conditions, const Discretization& mesh, double initialTime)
      : conditions_(conditions), mesh_(mesh), initialTime_(initialTime) {}

  void find(Mistakes& mistakes) {
    for (std::size_t c = 0; c < conditions_.size(); ++c)
      if (!conditions_[c]->claim().empty()) claim(c, mistakes);
    for (std::size_t c = 0; c < conditions_.size(); ++c)
      for (std::size_t other = 0; other < c; ++other) flowBoundaries(*conditions_[other], *conditions_[c], mistakes);
  }

 private:
  struct Owner {
    int condition = -1;
    std::size_t k = 0;  ///< of the condition's points
  };

  void claim(std::size_t c, Mistakes& mistakes) {
    const Condition& condition = *conditions_[c];
    const std::string component =
        condition.width() == 3 ? std::string(" component ") + "xyz"[condition.component()] : std::string();
    std::vector<Owner>& owners = owners_[condition.claim() + "/" + condition.field() + component];
    owners.resize(static_cast<std::size_t>(mesh_.nOwned));
    std::set<int> reported;
    for (std::size_t k = 0; k < condition.points().size(); ++k) {
      const int point = condition.points()[k];
      if (point >= mesh_.nOwned) continue;
      Owner& owner = owners[static_cast<std::size_t>(point)];
      if (owner.condition >= 0 && !agree(condition, k, owner) && reported.insert(owner.condition).second)
        mistakes.add(condition.node().keyPlace(),
                     "conditions \"" + conditions_[static_cast<std::size_t>(owner.condition)]->name() + "\" and \"" +
                         condition.name() + "\" " + condition.claim() + " different values of the same " +
                         condition.field() + component +
                         " where their node sets overlap; take those points out of one of the node sets");
      owner = {static_cast<int>(c), k};
    }
  }

  bool agree(const Condition& condition, std::size_t k, const Owner& owner) const {
    const Condition& other = *conditions_[static_cast<std::size_t>(owner.condition)];
    if (haveSameValue(condition, other)) return true;
    return !condition.dependsOnTime() && !other.dependsOnTime() &&
           condition.evaluate(mesh_, initialTime_)[k] == other.evaluate(mesh_, initialTime_)[owner.k];
  }

  std::vector<int> sharedPoints(const Condition& a, const Condition& b) const {
    const std::set<int> ofA(a.points().begin(), a.points().end());
    std::vector<int> shared;
    for (const int point : b.points())
      if (point < mesh_.nOwned && ofA.count(point) != 0) shared.push_back(point);
    return shared;
  }

  /// Bonds into points of two boundaries end at the nearer one; where both are at one place that is nobody's.
  void flowBoundaries(const Condition& a, const Condition& b, Mistakes& mistakes) const {
    const auto *first = dynamic_cast<const FlowBoundary*>(&a), *second = dynamic_cast<const FlowBoundary*>(&b);
    if (first == nullptr || second == nullptr) return;
    const std::vector<int> shared = sharedPoints(a, b);
    if (shared.empty() || first->hasSurface() != second->hasSurface()) return;
    bool isOnePlace = true, isSame = first->isOutflow() == second->isOutflow();
    for (const int point : shared) {
      const double* x = mesh_.x.data() + 3 * static_cast<std::size_t>(point);
      isOnePlace = isOnePlace && (!first->hasSurface() || first->surfaceAt(x) == second->surfaceAt(x));
      isSame = isSame && first->velocityAt(x, initialTime_) == second->velocityAt(x, initialTime_) &&
               first->pressureAt(x, initialTime_) == second->pressureAt(x, initialTime_);
    }
    if (!isOnePlace || first->isGivenAs(*second) || (isSame && !a.dependsOnTime() && !b.dependsOnTime())) return;
    mistakes.add(b.node().keyPlace(),
                 "conditions \"" + a.name() + "\" and \"" + b.name() + "\" give the flow different values at one " +
                     (first->hasSurface() ? "Surface" : "boundary") +
                     " where their node sets overlap; take those points out of one of the node sets");
  }

  const ConditionSet& conditions_;
  const Discretization& mesh_;
  double initialTime_;
  std::map<std::string, std::vector<Owner>> owners_;  ///< of owned points, by what is claimed
};

/// Loads of whose force all is on components that are prescribed. Collective.
void findIdleLoads(const ConditionSet& conditions, const Deck& deck, const Discretization& mesh,
                   const Communicator& comm, Mistakes& mistakes) {
  std::vector<char> isPrescribed(3 * static_cast<std::size_t>(mesh.nPoints), 0);
  for (const auto& condition : conditions)
    if (condition->field() == "Displacement") condition->markPrescribed(isPrescribed);
  for (const auto& condition : conditions) {
    if (!condition->isLoad()) continue;
    double onFree = 0.0, onHeld = 0.0;
    for (const double t : trialTimes(*condition, deck)) {
      std::vector<double> force(3 * static_cast<std::size_t>(mesh.nOwned), 0.0);
      condition->addForceDensity(mesh, t, force.data());
      for (std::size_t k = 0; k < force.size(); ++k) (isPrescribed[k] != 0 ? onHeld : onFree) += std::abs(force[k]);
    }
    onFree = comm.sum(onFree);
    if (comm.sum(onHeld) > 0.0 && onFree == 0.0)
      mistakes.add(condition->node().keyPlace(),
                   condition->title() +
                       " moves nothing: the displacement of all of its points is prescribed along it. "
                       "Give its points to one of the two conditions alone");
  }
}

}  // namespace

ConditionSet readConditions(const Deck& deck, const Discretization& mesh, const Communicator& comm,
                            const std::function<void(const Condition&)>& use) {
  ConditionSet conditions;
  collectively(comm, [&] {
    Mistakes mistakes;
    for (const auto& [name, node] : deck["Boundary Conditions"].entries()) {
      if (nodeSetKey(name).find("NODE_SET") != std::string::npos || !node.isMap()) continue;
      try {
        conditions.push_back(createCondition(name, node));
        conditions.back()->findPoints(mesh);
        use(*conditions.back());
      } catch (const DeckError& error) {
        mistakes.add("", error.what());
      }
    }
    mistakes.report();
  });
  Mistakes mistakes;
  for (const auto& condition : conditions) {
    try {
      condition->measure(mesh, comm);
    } catch (const DeckError& error) {
      mistakes.add("", error.what());
    }
  }
  collectively(comm, [&] {
    const ConditionSet good = withFiniteValues(conditions, deck, mesh, mistakes);
    if (!deck.isPeridigmDeck()) ConflictFinder(good, mesh, initialTime(deck)).find(mistakes);
    mistakes.report();
  });
  if (!deck.isPeridigmDeck()) findIdleLoads(conditions, deck, mesh, comm, mistakes);
  mistakes.report();
  return conditions;
}

}  // namespace pd
