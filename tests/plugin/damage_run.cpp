#include "damage_run.hpp"

#include <algorithm>

#include "plugins.hpp"

namespace pdtest {

using namespace PeridigmNS;

int DamageState::nBroken() const {
  return static_cast<int>(std::count_if(bonds.begin(), bonds.end(), [](const auto& bond) { return bond.second > 0; }));
}

Motion pull(int dimension, double load) {
  return [=](int id, const Point& x) {
    Point y = x;
    y[0] += load * (0.05 * x[0] + 0.01 * noise(id, 40));
    for (std::size_t k = 1; k < static_cast<std::size_t>(dimension); ++k)
      y[k] += load * (0.01 * noise(id, 40 + static_cast<int>(k)) - 0.03 * x[k]);
    return y;
  };
}

DamageRun::DamageRun(const Sample& sample, Layout layout) : sample_(sample), scene_(sceneOf(sample)) {
  for (int rank = 0; rank < layout.nRanks; ++rank) {
    bodies_.push_back(bareBody(scene_, layout, rank));
    models_.emplace_back(bodies_.back()->blocks()->size());
  }
  recreate();
  for (const auto& body : bodies_) {
    body->allocate(model().FieldIds());
    // Bonds that are cut before the run starts.
    body->breakBonds(
        [](const Point& a, const Point& b) { return (a[0] - 0.8) * (b[0] - 0.8) < 0.0 && a[1] < 1.1 && b[1] < 1.1; });
  }
  fillScalars(50, 1.0);
  initialize();
}

void DamageRun::fillScalars(int salt, double largest) {
  for (const int id : model().FieldIds()) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    if (spec.relation != PeridigmField::NODE || spec.length != PeridigmField::SCALAR ||
        spec.temporal != PeridigmField::TWO_STEP)
      continue;
    for (const auto& body : bodies_)
      for (int i = 0; i < body->nPoints(); ++i)
        body->field(spec.label)[i] = largest * (0.5 + 0.5 * noise(body->globalId(i), salt));
  }
}

void DamageRun::setState(const DamageState& state) {
  for (const auto& body : bodies_)
    for (std::size_t b = 0; b < body->blocks()->size(); ++b) {
      const auto list = body->block(b).getNeighborhoodData();
      const int id = FieldManager::self().getFieldId("Bond_Damage");
      FieldVector& now = *body->block(b).getData(id, PeridigmField::STEP_NP1);
      FieldVector& before = *body->block(b).getData(id, PeridigmField::STEP_N);
      const int* entry = list->NeighborhoodList();
      int bond = 0;
      for (int i = 0; i < list->NumOwnedPoints(); ++i) {
        const int from = body->globalId(list->OwnedIDs()[i]);
        body->field("Damage")[list->OwnedIDs()[i]] = state.damage[static_cast<std::size_t>(from)];
        for (int n = *entry++; n > 0; --n, ++bond)
          now[bond] = before[bond] = state.bonds.at({from, body->globalId(*entry++)});
      }
    }
  initialize();
}

void DamageRun::recreate() {
  for (std::size_t r = 0; r < bodies_.size(); ++r)
    for (auto& model : models_[r]) model = pd::DamageModelRegistry::self().create(sample_.plugin, sample_.parameters);
}

void DamageRun::initialize() {
  for (std::size_t r = 0; r < bodies_.size(); ++r)
    for (std::size_t b = 0; b < models_[r].size(); ++b) {
      const auto list = bodies_[r]->block(b).getNeighborhoodData();
      models_[r][b]->initialize(0.1, list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList(),
                                *bodies_[r]->block(b).getDataManager());
    }
  exchange(model().FieldIdsForSynchronizationAfterInitialize());
  copyToGhosts(bodies_, "Damage");
}

void DamageRun::exchange(const std::vector<int>& fieldIds) {
  for (const int id : fieldIds) copyToGhosts(bodies_, FieldManager::self().getFieldSpec(id).label);
}

void DamageRun::evaluate(const Motion& motion, int nEvaluations) {
  for (const auto& body : bodies_)
    for (int i = 0; body->hasField("Coordinates") && i < body->nPoints(); ++i) {
      const Point y = motion(body->globalId(i), body->point(i));
      std::copy(y.begin(), y.end(), body->field("Coordinates") + 3 * i);
    }
  const auto call = [&](auto member) {
    for (std::size_t r = 0; r < bodies_.size(); ++r)
      for (std::size_t b = 0; b < models_[r].size(); ++b) {
        const auto list = bodies_[r]->block(b).getNeighborhoodData();
        ((*models_[r][b]).*member)(0.1, list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList(),
                                   *bodies_[r]->block(b).getDataManager());
      }
  };
  for (int evaluation = 0; evaluation < nEvaluations; ++evaluation) {
    if (callsPrecompute) {
      call(&DamageModel::precompute);
      exchange(model().FieldIdsForSynchronizationAfterPrecompute());
    }
    call(&DamageModel::computeDamage);
  }
  copyToGhosts(bodies_, "Damage");
}

void DamageRun::updateState() {
  for (const auto& body : bodies_)
    for (Block& block : *body->blocks()) block.getDataManager()->updateState();
}

DamageState DamageRun::state() {
  DamageState state;
  state.damage.resize(scene_.points.size());
  for (const auto& body : bodies_)
    for (std::size_t b = 0; b < body->blocks()->size(); ++b) {
      const auto list = body->block(b).getNeighborhoodData();
      const int* entry = list->NeighborhoodList();
      const double* bondDamage = body->field("Bond_Damage", b);
      for (int i = 0; i < list->NumOwnedPoints(); ++i) {
        const int from = body->globalId(list->OwnedIDs()[i]);
        state.damage[static_cast<std::size_t>(from)] = body->field("Damage")[list->OwnedIDs()[i]];
        for (int n = *entry++; n > 0; --n) state.bonds[{from, body->globalId(*entry++)}] = *bondDamage++;
      }
    }
  return state;
}

}  // namespace pdtest
