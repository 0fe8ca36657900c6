// The evaluations of a Model: what solvers ask of all blocks' plug-ins, and the exchange around them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "Peridigm_Field.hpp"
#include "collective.hpp"
#include "fields.hpp"
#include "model.hpp"
#include "separate_rates.hpp"
#include "unknowns.hpp"

namespace pd {

using namespace PeridigmNS;

namespace {

bool declares(const Block& block, const std::string& label) {
  auto& fields = FieldManager::self();
  if (!fields.hasField(label)) return false;
  const auto ids = const_cast<Block&>(block).getMaterialModel()->FieldIds();
  return std::find(ids.begin(), ids.end(), fields.getFieldId(label)) != ids.end();
}

/// plugin(dt, nOwned, ownedIDs, neighborhoodList, data) for a block that has points on this rank.
template <class Call>
void callBlock(Block& block, const Communicator& comm, const Call& call) {
  const auto points = block.getNeighborhoodData();
  if (points->NumOwnedPoints() == 0) return;
  orAbort(comm, [&] {
    call(points->NumOwnedPoints(), points->OwnedIDs(), points->NeighborhoodList(), *block.getDataManager());
  });
}

long long bondsOf(Block& block) { return block.getNeighborhoodData()->NumBonds(); }

}  // namespace

void Model::importGhosts(const std::string& label) {
  const Timers::Scope timer(timers_, "ghost exchange");
  exchange_.import(field(label), fieldWidth(label), reflectionOf(label));
}

void Model::fillImages(const std::string& label) {
  if (discretization_.symmetry.empty()) return;
  exchange_.fillImages(field(label), fieldWidth(label), reflectionOf(label));
}

std::optional<Reflection> Model::reflectionOf(const std::string& label) const {
  if (discretization_.symmetry.empty()) return std::nullopt;
  return reflections_.of(FieldManager::self().getFieldSpec(label));
}

void Model::synchronise(const std::vector<int>& fieldIds) {
  for (const int id : fieldIds) {
    const std::string label = FieldManager::self().getFieldSpec(id).label;
    if (!discretization_.symmetry.empty() && !reflectionOf(label))
      throw RunError(
          fmt::format("neighbours' values of the field \"{}\" are asked for, but nothing says what a plane of "
                      "symmetry makes of {} values a point; model the whole body",
                      label, fieldWidth(label)));
    importGhosts(label);
  }
}

void Model::evaluateDamage(double dt) {
  if (!hasDamage()) return;
  hasCalledDamage_ = true;
  std::set<int> declared;
  for (Block& block : *blocks_) {
    const auto damage = block.getDamageModel();
    if (damage.is_null()) continue;
    callBlock(block, comm_, [&](int n, const int* owned, const int* list, DataManager& data) {
      damage->precompute(dt, n, owned, list, data);
    });
    for (const int id : damage->FieldIdsForSynchronizationAfterPrecompute()) declared.insert(id);
  }
  std::vector<int> exchanged(declared.begin(), declared.end());
  synchronise(exchanged);
  for (Block& block : *blocks_) {
    const auto damage = block.getDamageModel();
    if (damage.is_null()) continue;
    const Timers::Scope timer(timers_, "damage", bondsOf(block));
    callBlock(block, comm_, [&](int n, const int* owned, const int* list, DataManager& data) {
      damage->computeDamage(dt, n, owned, list, data);
    });
  }
  // Peridigm exchanges after computeDamage().
  synchronise(exchanged);
  if (hasField("Damage")) importGhosts("Damage");
}

void Model::callPrecompute(double dt, int rateField) {
  hasCalledMaterials_ = true;
  std::set<int> ids;
  for (Block& block : *blocks_) {
    const auto material = block.getMaterialModel();
    const auto* separate = rateField < 0 ? nullptr : dynamic_cast<const SeparateRates*>(material.get());
    if (rateField >= 0 && separate == nullptr && declares(block, "Force_Density")) continue;
    {
      const Timers::Scope timer(timers_, "precompute");
      callBlock(block, comm_, [&](int n, const int* owned, const int* list, DataManager& data) {
        if (separate != nullptr)
          separate->prepareRate(rateField, dt, {n, owned, list}, data);
        else
          material->precompute(dt, n, owned, list, data);
      });
    }
    for (const int id : material->FieldIdsForSynchronizationAfterPrecompute()) ids.insert(id);
  }
  synchronise({ids.begin(), ids.end()});
}

void Model::sumBlocks(const std::string& label) {
  const int id = FieldManager::self().getFieldId(label);
  const std::size_t n = static_cast<std::size_t>(nPoints()) * static_cast<std::size_t>(fieldWidth(label));
  double* total = field(label);
  const auto own = [&](Block& block) {
    double* values = nullptr;
    block.getData(id, PeridigmField::STEP_NP1)->ExtractView(&values);
    return values;
  };
  const bool isPrivate = blocks_->size() > 1;
  if (isPrivate) {
    std::fill(total, total + n, 0.0);
    for (Block& block : *blocks_) {
      const double* part = own(block);
      if (part == total) continue;
      for (std::size_t i = 0; i < n; ++i) total[i] += part[i];
    }
  }
  {
    const Timers::Scope timer(timers_, "ghost exchange");
    exchange_.exportAdd(total, fieldWidth(label), reflectionOf(label));
  }
  // Computes read the field through a block: they see the sum of all blocks.
  if (isPrivate)
    for (Block& block : *blocks_) {
      double* part = own(block);
      if (part != total) std::copy(total, total + n, part);
    }
}

void Model::evaluateForce(double dt) {
  callPrecompute(dt, -1);
  for (Block& block : *blocks_) {
    if (!declares(block, "Force_Density")) continue;
    const Timers::Scope timer(timers_, "force", bondsOf(block));
    const auto material = block.getMaterialModel();
    const int id = FieldManager::self().getFieldId("Force_Density");
    if (block.numPoints() == 0) block.getData(id, PeridigmField::STEP_NP1)->PutScalar(0.0);
    callBlock(block, comm_, [&](int n, const int* owned, const int* list, DataManager& data) {
      material->computeForce(dt, n, owned, list, data);
    });
  }
  sumBlocks("Force_Density");
}

void Model::evaluateFluxDivergence(double dt, const std::string& fluxField, bool isPrepared) {
  hasCalledMaterials_ = true;
  const int id = FieldManager::self().getFieldId(fluxField);
  if (!isPrepared) callPrecompute(dt, id);
  for (Block& block : *blocks_) {
    if (!declares(block, fluxField)) continue;
    const Timers::Scope timer(timers_, "flux divergence", bondsOf(block));
    const auto material = block.getMaterialModel();
    const auto* separate = dynamic_cast<const SeparateRates*>(material.get());
    if (block.numPoints() == 0) block.getData(id, PeridigmField::STEP_NP1)->PutScalar(0.0);
    callBlock(block, comm_, [&](int n, const int* owned, const int* list, DataManager& data) {
      if (separate != nullptr)
        separate->computeRate(id, dt, {n, owned, list}, data);
      else
        material->computeFluxDivergence(dt, n, owned, list, data);
    });
  }
  sumBlocks(fluxField);
}

void Model::evaluateStoredEnergy(double dt) {
  for (Block& block : *blocks_) {
    const Timers::Scope timer(timers_, "stored energy", bondsOf(block));
    const auto material = block.getMaterialModel();
    callBlock(block, comm_, [&](int n, const int* owned, const int* list, DataManager& data) {
      material->computeStoredElasticEnergyDensity(dt, n, owned, list, data);
    });
  }
}

void Model::assembleJacobian(double dt, SerialMatrix& matrix) {
  for (Block& block : *blocks_) {
    const auto material = block.getMaterialModel();
    // A material that computes none of the unknowns' rates has no tangent of them, nor the means to probe for one.
    if (!givesUnknownRate(fieldsIn(*material))) continue;
    const Timers::Scope timer(timers_, "tangent", bondsOf(block));
    callBlock(block, comm_, [&](int n, const int* owned, const int* list, DataManager& data) {
      material->computeJacobian(dt, n, owned, list, data, matrix);
    });
  }
}

void Model::updateCoordinates() {
  importGhosts("Displacement");
  const double* displacement = field("Displacement");
  const double* reference = field("Model_Coordinates");
  double* current = field("Coordinates");
  const long long n = 3LL * nPoints();
  for (long long i = 0; i < n; ++i) current[i] = reference[i] + displacement[i];
}

void Model::requireFinite(const std::string& label, int step) const {
  const auto values = vector(label, false);
  const int width = fieldWidth(label);
  const int n = width * nOwned();
  int nBad = 0;
  for (int i = 0; i < n; ++i) nBad += std::isfinite((*values)[i]) ? 0 : 1;
  if (!comm_.any(nBad > 0)) return;
  std::string message;
  if (nBad > 0) {
    int entry = 0;
    while (std::isfinite((*values)[entry])) ++entry;
    const auto point = static_cast<std::size_t>(entry / width);
    const double* place = discretization_.x.data() + 3 * point;
    message = fmt::format(
        "step {}: field \"{}\" is not finite at point {} (x = {:g}, y = {:g}, z = {:g} m); {} such value(s) on rank "
        "{}; look at the time step and at the values of the conditions\n",
        step, label, discretization_.globalIds[point] + 1, place[0], place[1], place[2], nBad, comm_.rank());
  }
  throw RunError(comm_.gather(message));
}

}  // namespace pd
