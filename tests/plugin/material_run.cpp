#include "material_run.hpp"

#include <algorithm>
#include <cmath>

#include "plugins.hpp"

namespace pdtest {

using namespace PeridigmNS;
using PeridigmField::STEP_NP1;

double relativeDifference(const Results& a, const Results& b) {
  if (a.size() != b.size()) return INFINITY;
  double worst = 0.0;
  for (const auto& [label, values] : a) {
    const auto other = b.find(label);
    if (other == b.end() || other->second.size() != values.size()) return INFINITY;
    double largest = 0.0, difference = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      largest = std::max(largest, std::abs(values[i]));
      difference = std::max(difference, std::abs(values[i] - other->second[i]));
      if (std::isnan(values[i]) || std::isnan(other->second[i])) return INFINITY;
    }
    if (difference > 0.0) worst = std::max(worst, difference / largest);
  }
  return worst;
}

Motion someMotion(int dimension) {
  return [dimension](int id, const Point& x) {
    Point y = x;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension); ++k)
      y[k] += 0.02 * x[k] - 0.01 * (dimension > 1 ? x[(k + 1) % static_cast<std::size_t>(dimension)] : 0.0) +
              0.01 * noise(id, 20 + static_cast<int>(k));
    return y;
  };
}

std::unique_ptr<SmallBody> bareBody(const Scene& scene, const Layout& layout, int rank) {
  BodyOptions options;
  options.horizon = scene.reach;
  options.volumes = scene.volumes;
  options.isBare = true;
  options.bondSteps = layout.bondSteps;
  const auto dealt = [salt = layout.salt](int id, int n, int which) {
    return salt == 0 ? (which == 0 ? id : id / 3) % n
                     : std::min(n - 1, static_cast<int>(n * 0.5 * (1.0 + noise(id, salt + which))));
  };
  options.blockOf = [dealt, n = layout.nBlocks](int id) { return 1 + dealt(id, n, 0); };
  options.isOwned = [dealt, rank, n = layout.nRanks](int id) { return dealt(id, n, 1) == rank; };
  return std::make_unique<SmallBody>(scene.points, options);
}

void copyToGhosts(const std::vector<std::unique_ptr<SmallBody>>& bodies, const std::string& label) {
  const auto width =
      static_cast<std::size_t>(PeridigmField::variableDimension(FieldManager::self().getFieldSpec(label).getLength()));
  std::map<int, const double*> owners;
  for (const auto& body : bodies)
    for (int i = 0; i < body->nOwned(); ++i)
      owners[body->globalId(i)] = body->field(label) + width * static_cast<std::size_t>(i);
  for (const auto& body : bodies)
    for (int i = body->nOwned(); i < body->nPoints(); ++i)
      std::copy_n(owners.at(body->globalId(i)), width, body->field(label) + width * static_cast<std::size_t>(i));
}

MaterialRun::MaterialRun(const Sample& sample, Layout layout)
    : sample_(sample), scene_(sceneOf(sample)), layout_(layout) {
  for (int rank = 0; rank < layout.nRanks; ++rank) {
    bodies_.push_back(bareBody(scene_, layout, rank));
    SmallBody& body = *bodies_.back();
    materials_.emplace_back();
    for (std::size_t b = 0; b < body.blocks()->size(); ++b) {
      materials_.back().push_back(pd::MaterialRegistry::self().create(sample.plugin, parametersOf(sample)));
      body.block(b).setMaterialModel(materials_.back().back());
    }
    fieldIds_ = materials_.back().front()->FieldIds();
    // The host's own: what Peridigm's computes of energy ask for.
    fieldIds_.push_back(FieldManager::self().getFieldId(PeridigmField::ELEMENT, PeridigmField::SCALAR,
                                                        PeridigmField::CONSTANT, "Stored_Elastic_Energy_Density"));
    body.allocate(fieldIds_);
    if (body.blocks()->size() > 1)
      for (const std::string& label : summedFields())
        for (Block& block : *body.blocks())
          block.getDataManager()->allocatePrivateData(FieldManager::self().getFieldId(label));
    fillInputs(body);
  }
  if (layout.isDamaged) damage();
  move(someMotion(sample.dimension));
  initialize();
}

std::vector<std::string> MaterialRun::summedFields() {
  std::vector<std::string> labels;
  for (const int id : pd::fieldsIn(*materials_.front().front()).sums())
    labels.push_back(FieldManager::self().getFieldSpec(id).getLabel());
  return labels;
}

/// Stepped scalars that are no results take values between 0 and 1, velocities between -1 and 1. Of a material that
/// declares Damage, half of the points are damaged wholly.
void MaterialRun::fillInputs(SmallBody& body) {
  const std::vector<std::string> results = summedFields();
  if (body.hasField("Velocity"))
    for (int i = 0; i < body.nPoints(); ++i)
      for (int k = 0; k < sample_.dimension; ++k) body.field("Velocity")[3 * i + k] = noise(body.globalId(i), 40 + k);
  fillFlow(body);
  for (const int id : fieldIds_) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    const bool isPointScalar = (spec.relation == PeridigmField::NODE || spec.relation == PeridigmField::ELEMENT) &&
                               spec.length == PeridigmField::SCALAR && spec.temporal == PeridigmField::TWO_STEP;
    if (!isPointScalar || std::count(results.begin(), results.end(), spec.label) > 0) continue;
    const double factor = spec.label == "Damage" ? 1.0 : 0.5;
    for (int i = 0; i < body.nPoints(); ++i)
      body.field(spec.label)[i] = std::min(1.0, factor * (1.0 + noise(body.globalId(i), spec.id)));
  }
}

/// Of a material that a flow carries something for: all is fluid, bonds move volume, as much to one end as from the
/// other.
void MaterialRun::fillFlow(SmallBody& body) {
  FieldManager& fields = FieldManager::self();
  if (!fields.hasField("Bond_Flow") ||
      std::count(fieldIds_.begin(), fieldIds_.end(), fields.getFieldId("Bond_Flow")) == 0)
    return;
  std::fill_n(body.field("Fluid"), body.nPoints(), 1.0);
  for (std::size_t b = 0; b < body.blocks()->size(); ++b) {
    const auto neighborhood = body.block(b).getNeighborhoodData();
    const int* list = neighborhood->NeighborhoodList();
    double *flow = body.field("Bond_Flow", b), *opening = body.field("Bond_Opening", b);
    for (int p = 0; p < neighborhood->NumOwnedPoints(); ++p) {
      const int i = neighborhood->OwnedIDs()[p];
      for (int n = *list++; n > 0; --n) {
        const int j = *list++;
        const int low = std::min(body.globalId(i), body.globalId(j)),
                  high = std::max(body.globalId(i), body.globalId(j));
        const double moved = noise(1000 * low + high, 60) * (body.globalId(i) == low ? 1.0 : -1.0);
        *flow++ = moved / body.field("Volume")[i];
        *opening++ = 1.0;
      }
    }
  }
}

/// Breaks the bonds that cross part of a plane, and counts them in Damage, as a damage model of the block would.
void MaterialRun::damage() {
  const int id =
      FieldManager::self().getFieldId(PeridigmField::ELEMENT, PeridigmField::SCALAR, PeridigmField::TWO_STEP, "Damage");
  fieldIds_.push_back(id);
  for (const auto& body : bodies_) {
    body->allocate({id});
    body->breakBonds(
        [](const Point& a, const Point& b) { return (a[0] - 1.8) * (b[0] - 1.8) < 0.0 && a[1] + b[1] < 3.1; });
    for (std::size_t b = 0; b < body->blocks()->size(); ++b) {
      const auto neighborhood = body->block(b).getNeighborhoodData();
      const int* list = neighborhood->NeighborhoodList();
      const double* bondDamage = body->field("Bond_Damage", b);
      for (int i = 0; i < neighborhood->NumOwnedPoints(); ++i) {
        const int n = *list;
        double broken = 0.0;
        for (int k = 0; k < n; ++k) broken += *bondDamage++;
        double& damage = body->field("Damage")[neighborhood->OwnedIDs()[i]];
        if (damage < 1.0) damage = broken / n;
        list += 1 + n;
      }
    }
  }
  copyToGhosts(bodies_, "Damage");
}

void MaterialRun::move(const Motion& motion) {
  for (const auto& body : bodies_) {
    if (!body->hasField("Coordinates")) continue;
    for (int i = 0; i < body->nPoints(); ++i) {
      const Point y = motion(body->globalId(i), body->point(i));
      std::copy(y.begin(), y.end(), body->field("Coordinates") + 3 * i);
    }
  }
}

void MaterialRun::synchronize(const std::vector<int>& fieldIds) {
  for (const int id : fieldIds) copyToGhosts(bodies_, FieldManager::self().getFieldSpec(id).getLabel());
}

namespace {

/// Calls work(block, material, owned points, ids, list, data) for every block of every rank.
template <class Bodies, class Materials, class Work>
void forEachBlock(const Bodies& bodies, const Materials& materials, Work&& work) {
  for (std::size_t r = 0; r < bodies.size(); ++r)
    for (std::size_t b = 0; b < materials[r].size(); ++b) {
      Block& block = bodies[r]->block(b);
      const auto list = block.getNeighborhoodData();
      work(*materials[r][b], list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList(),
           *block.getDataManager());
    }
}

}  // namespace

void MaterialRun::initialize() {
  forEachBlock(bodies_, materials_,
               [](Material& material, int n, const int* owned, const int* list, DataManager& data) {
                 material.initialize(0.1, n, owned, list, data);
               });
  synchronize(material().FieldIdsForSynchronizationAfterInitialize());
}

Results MaterialRun::evaluate() {
  forEachBlock(bodies_, materials_,
               [](Material& material, int n, const int* owned, const int* list, DataManager& data) {
                 material.precompute(0.1, n, owned, list, data);
               });
  synchronize(material().FieldIdsForSynchronizationAfterPrecompute());
  forEachBlock(bodies_, materials_,
               [](Material& material, int n, const int* owned, const int* list, DataManager& data) {
                 material.computeForce(0.1, n, owned, list, data);
                 material.computeFluxDivergence(0.1, n, owned, list, data);
                 material.computeStoredElasticEnergyDensity(0.1, n, owned, list, data);
               });
  Results results;
  for (std::size_t rank = 0; rank < bodies_.size(); ++rank) {
    for (const std::string& label : summedFields()) addSummed(results, rank, label);
    std::vector<double>& energy = results["Stored_Elastic_Energy_Density"];
    energy.resize(scene_.points.size());
    for (int i = 0; i < bodies_[rank]->nOwned(); ++i)
      energy[static_cast<std::size_t>(bodies_[rank]->globalId(i))] =
          bodies_[rank]->field("Stored_Elastic_Energy_Density")[i];
  }
  return results;
}

void MaterialRun::addSummed(Results& results, std::size_t rank, const std::string& label) {
  SmallBody& body = *bodies_[rank];
  const auto width =
      static_cast<std::size_t>(PeridigmField::variableDimension(FieldManager::self().getFieldSpec(label).getLength()));
  std::vector<double>& sum = results[label];
  sum.resize(width * scene_.points.size());
  for (std::size_t b = 0; b < body.blocks()->size(); ++b)
    for (int i = 0; i < body.nPoints(); ++i)
      for (std::size_t k = 0; k < width; ++k)
        sum[width * static_cast<std::size_t>(body.globalId(i)) + k] +=
            body.field(label, b)[width * static_cast<std::size_t>(i) + k];
}

}  // namespace pdtest
