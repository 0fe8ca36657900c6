#include "step_run.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "damage_run.hpp"
#include "fields.hpp"
#include "plugins.hpp"
#include "step_listener.hpp"

namespace pdtest {

using namespace PeridigmNS;

namespace {

constexpr double dt = 0.1;

std::string differenceOf(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  double largest = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) && std::isnan(b[i])) continue;
    largest = std::max({largest, std::abs(a[i]), std::abs(b[i])});
    difference = std::max(difference, std::isnan(a[i] - b[i]) ? HUGE_VAL : std::abs(a[i] - b[i]));
  }
  return difference <= tolerance * largest ? "" : std::to_string(difference) + " of " + std::to_string(largest);
}

bool isPointField(const FieldSpec& spec) {
  return spec.relation == PeridigmField::NODE || spec.relation == PeridigmField::ELEMENT;
}

std::size_t widthOf(const FieldSpec& spec) {
  return static_cast<std::size_t>(PeridigmField::variableDimension(spec.length));
}

PeridigmField::Step latest(const FieldSpec& spec) {
  return spec.temporal == PeridigmField::CONSTANT ? PeridigmField::STEP_NONE : PeridigmField::STEP_NP1;
}

double* valuesOf(Block& block, const FieldSpec& spec, PeridigmField::Step step) {
  double* values = nullptr;
  block.getData(spec.id, step)->ExtractView(&values);
  return values;
}

}  // namespace

std::string differenceOf(const FieldState& a, const FieldState& b, double tolerance) {
  std::string lines;
  for (const auto& [label, values] : a.points) {
    const std::string difference = differenceOf(values, b.points.at(label), tolerance);
    if (!difference.empty()) lines += " " + label + " by " + difference + ";";
  }
  for (const auto& [label, values] : a.bonds) {
    std::vector<double> first, second;
    for (const auto& [ends, value] : values) {
      first.push_back(value);
      second.push_back(b.bonds.at(label).at(ends));
    }
    const std::string difference = differenceOf(first, second, tolerance);
    if (!difference.empty()) lines += " " + label + " by " + difference + ";";
  }
  return lines;
}

StepRun::StepRun(const Sample& sample, PluginKind kind, Layout layout)
    : sample_(sample), kind_(kind), scene_(sceneOf(sample)), layout_(layout) {
  for (int rank = 0; rank < layout.nRanks; ++rank) {
    bodies_.push_back(bareBody(scene_, layout, rank));
    materials_.emplace_back(bodies_.back()->blocks()->size());
    damageModels_.emplace_back(bodies_.back()->blocks()->size());
  }
  recreate();
  for (const auto& body : bodies_) {
    body->allocate(fieldIds());
    for (const int id : fieldIds()) {
      if (body->blocks()->size() > 1 && isSummed(id))
        for (Block& block : *body->blocks()) block.getDataManager()->allocatePrivateData(id);
    }
    if (body->hasField("Block_Id"))
      for (int i = 0; i < body->nPoints(); ++i) body->field("Block_Id")[i] = 1.0;
  }
  load(0.0);
  initialize();
  for (const auto& body : bodies_) {
    if (!body->hasField("Solid_Concentration") || kind == PluginKind::Material) continue;
    for (int i = 0; i < body->nPoints(); ++i) {
      body->field("Solid_Concentration")[i] = body->globalId(i) % 11 == 0 ? 0.0 : 1.0;
      body->field("Saturation_Concentration")[i] = 0.2;
    }
  }
  accept();
}

void StepRun::recreate() {
  for (std::size_t r = 0; r < bodies_.size(); ++r)
    for (std::size_t b = 0; b < materials_[r].size(); ++b) {
      if (kind_ == PluginKind::Material)
        materials_[r][b] = pd::MaterialRegistry::self().create(sample_.plugin, parametersOf(sample_));
      else
        damageModels_[r][b] = pd::DamageModelRegistry::self().create(sample_.plugin, sample_.parameters);
    }
}

std::vector<int> StepRun::fieldIds() {
  return kind_ == PluginKind::Material ? materials_.front().front()->FieldIds()
                                       : damageModels_.front().front()->FieldIds();
}

std::vector<int> StepRun::synchronised(pd::Ghosts when) {
  const auto of = [&](const auto& plugin) {
    return when == pd::Ghosts::AfterInitialize ? plugin.FieldIdsForSynchronizationAfterInitialize()
                                               : plugin.FieldIdsForSynchronizationAfterPrecompute();
  };
  return kind_ == PluginKind::Material ? of(*materials_.front().front()) : of(*damageModels_.front().front());
}

const pd::FieldTable& StepRun::table() {
  const pd::FieldTable* table = kind_ == PluginKind::Material ? pd::fieldTableOf(*materials_.front().front())
                                                              : pd::fieldTableOf(*damageModels_.front().front());
  if (table == nullptr) throw std::invalid_argument(sample_.plugin + " has no table of fields");
  return *table;
}

bool StepRun::isSummed(int fieldId) {
  if (kind_ == PluginKind::DamageModel) return false;
  const std::vector<int> sums = pd::fieldsIn(*materials_.front().front()).sums();
  return std::find(sums.begin(), sums.end(), fieldId) != sums.end();
}

template <class Work>
void StepRun::forEachBlock(const Work& work) {
  for (std::size_t r = 0; r < bodies_.size(); ++r)
    for (std::size_t b = 0; b < materials_[r].size(); ++b) {
      Block& block = bodies_[r]->block(b);
      const auto list = block.getNeighborhoodData();
      const pd::Call call{list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList()};
      if (call.nOwned == 0) continue;
      if (kind_ == PluginKind::Material)
        work(*materials_[r][b], call, *block.getDataManager());
      else
        work(*damageModels_[r][b], call, *block.getDataManager());
    }
}

void StepRun::copyDeclared(const std::vector<int>& fieldIds) {
  for (const int id : fieldIds) copyToGhosts(bodies_, FieldManager::self().getFieldSpec(id).label);
}

void StepRun::initialize() {
  forEachBlock([](auto& plugin, const pd::Call& call, DataManager& data) {
    plugin.initialize(dt, call.nOwned, call.ownedIds, call.neighborhoodList, data);
  });
  copyDeclared(kind_ == PluginKind::Material
                   ? materials_.front().front()->FieldIdsForSynchronizationAfterInitialize()
                   : damageModels_.front().front()->FieldIdsForSynchronizationAfterInitialize());
}

void StepRun::load(double load) {
  const Motion motion = pull(sample_.dimension, load);
  for (const auto& body : bodies_)
    for (int i = 0; i < body->nPoints(); ++i) {
      const int id = body->globalId(i);
      const Point y = motion(id, body->point(i));
      if (body->hasField("Coordinates")) std::copy(y.begin(), y.end(), body->field("Coordinates") + 3 * i);
      // Metal around drops of electrolyte, that dissolves unevenly; hydrogen that arrives.
      const bool isDrop = id % 11 == 0;
      const double lost = std::clamp(0.3 * load * (1.1 + 0.6 * noise(id, 3)), 0.0, 1.0);
      if (body->hasField("Concentration"))
        body->field("Concentration")[i] = sample_.plugin.find("Hydrogen") == 0 ? 0.5 * load * (1.0 + noise(id, 4))
                                          : isDrop                             ? 0.0
                                                                               : 1.0 - 0.8 * lost;
      if (body->hasField("Temperature")) body->field("Temperature")[i] = load + noise(id, 5);
      if (body->hasField("Damage") && kind_ == PluginKind::Material)
        body->field("Damage")[i] = isDrop || lost == 1.0 ? 1.0 : 0.0;
    }
}

void StepRun::evaluate() {
  hasEvaluated_ = true;
  if (kind_ == PluginKind::DamageModel) {
    const auto exchanged = damageModels_.front().front()->FieldIdsForSynchronizationAfterPrecompute();
    forEachBlock([](auto& plugin, const pd::Call& call, DataManager& data) {
      plugin.precompute(dt, call.nOwned, call.ownedIds, call.neighborhoodList, data);
    });
    copyDeclared(exchanged);
    for (std::size_t r = 0; r < bodies_.size(); ++r)
      for (std::size_t b = 0; b < damageModels_[r].size(); ++b) {
        const auto list = bodies_[r]->block(b).getNeighborhoodData();
        if (list->NumOwnedPoints() > 0)
          damageModels_[r][b]->computeDamage(dt, list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList(),
                                             *bodies_[r]->block(b).getDataManager());
      }
    copyDeclared(exchanged);
    if (bodies_.front()->hasField("Damage")) copyToGhosts(bodies_, "Damage");
    return;
  }
  forEachBlock([](auto& plugin, const pd::Call& call, DataManager& data) {
    plugin.precompute(dt, call.nOwned, call.ownedIds, call.neighborhoodList, data);
  });
  copyDeclared(materials_.front().front()->FieldIdsForSynchronizationAfterPrecompute());
  for (std::size_t r = 0; r < bodies_.size(); ++r)
    for (std::size_t b = 0; b < materials_[r].size(); ++b) {
      const auto list = bodies_[r]->block(b).getNeighborhoodData();
      if (list->NumOwnedPoints() == 0) continue;
      DataManager& data = *bodies_[r]->block(b).getDataManager();
      materials_[r][b]->computeForce(dt, list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList(), data);
      materials_[r][b]->computeFluxDivergence(dt, list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList(),
                                              data);
      if (bodies_[r]->hasField("Stored_Elastic_Energy_Density"))
        materials_[r][b]->computeStoredElasticEnergyDensity(dt, list->NumOwnedPoints(), list->OwnedIDs(),
                                                            list->NeighborhoodList(), data);
    }
}

void StepRun::accept() {
  time_ += dt;
  for (const auto& body : bodies_) {
    body->block().getDataManager()->updatePointState();
    for (Block& block : *body->blocks()) block.getDataManager()->updateBondState();
  }
  const bool isTold = hasEvaluated_ && layout_.bondSteps != BondSteps::Swapped;  // in Peridigm nobody tells
  hasEvaluated_ = false;
  if (!isTold) return;
  forEachBlock([&](auto& plugin, const pd::Call& call, DataManager& data) {
    if (const auto* listener = dynamic_cast<const pd::StepListener*>(&plugin))
      listener->stepAccepted(call, data, time_, dt);
  });
}

void StepRun::step(double toLoad) {
  load(toLoad);
  evaluate();
  accept();
}

std::vector<int> StepRun::keptFieldIds() {
  std::vector<int> kept;
  for (const int id : fieldIds()) {
    const FieldSpec spec = FieldManager::self().getFieldSpec(id);
    const pd::FieldUse* use = table().find(id);
    const bool isState = use != nullptr && use->field.isState;
    if (isState || (spec.temporal == PeridigmField::TWO_STEP && !isSummed(id))) kept.push_back(id);
  }
  return kept;
}

void StepRun::begin() {
  saved_.clear();
  for (const auto& body : bodies_)
    for (Block& block : *body->blocks())
      for (const int id : keptFieldIds()) {
        const FieldSpec spec = FieldManager::self().getFieldSpec(id);
        const FieldVector& values = *block.getData(id, latest(spec));
        std::vector<double>& copy = saved_.emplace_back();
        for (int i = 0; i < values.MyLength(); ++i) copy.push_back(values[i]);
      }
}

void StepRun::takeBack() {
  auto copy = saved_.begin();
  for (const auto& body : bodies_)
    for (Block& block : *body->blocks())
      for (const int id : keptFieldIds()) {
        const FieldSpec spec = FieldManager::self().getFieldSpec(id);
        std::copy(copy->begin(), copy->end(), valuesOf(block, spec, latest(spec)));
        ++copy;
      }
  forEachBlock([](auto& plugin, const pd::Call&, DataManager&) {
    if (const auto* listener = dynamic_cast<const pd::StepListener*>(&plugin)) listener->stepTakenBack();
  });
}

void StepRun::goOnFrom(const FieldState& state) {
  for (const auto& body : bodies_)
    for (std::size_t b = 0; b < body->blocks()->size(); ++b)
      for (const int id : fieldIds()) {
        const FieldSpec spec = FieldManager::self().getFieldSpec(id);
        double* values = valuesOf(body->block(b), spec, latest(spec));
        if (isPointField(spec)) {
          const std::vector<double>& from = state.points.at(spec.label);
          const std::size_t width = widthOf(spec);
          for (int i = 0; i < body->nPoints(); ++i)
            std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(width) * body->globalId(i), width,
                        values + width * static_cast<std::size_t>(i));
          continue;
        }
        const auto list = body->block(b).getNeighborhoodData();
        const int* entry = list->NeighborhoodList();
        for (int i = 0; i < list->NumOwnedPoints(); ++i) {
          const int from = body->globalId(list->OwnedIDs()[i]);
          for (int n = *entry++; n > 0; --n)
            *values++ = state.bonds.at(spec.label).at({from, body->globalId(*entry++)});
        }
      }
  for (const auto& body : bodies_) {
    body->block().getDataManager()->updatePointState();
    for (Block& block : *body->blocks()) block.getDataManager()->updateBondState();
  }
}

FieldState StepRun::state() {
  FieldState state;
  for (const auto& body : bodies_)
    for (std::size_t b = 0; b < body->blocks()->size(); ++b)
      for (const int id : fieldIds()) {
        const FieldSpec spec = FieldManager::self().getFieldSpec(id);
        const double* values = valuesOf(body->block(b), spec, latest(spec));
        if (isPointField(spec)) {
          const std::size_t width = widthOf(spec);
          std::vector<double>& all = state.points[spec.label];
          all.resize(width * scene_.points.size());
          const bool adds = isSummed(id);
          if (!adds && b > 0) continue;
          const int n = adds ? body->nPoints() : body->nOwned();
          for (int i = 0; i < n; ++i)
            for (std::size_t k = 0; k < width; ++k) {
              double& value = all[width * static_cast<std::size_t>(body->globalId(i)) + k];
              const double own = values[width * static_cast<std::size_t>(i) + k];
              value = adds ? value + own : own;
            }
          continue;
        }
        const auto list = body->block(b).getNeighborhoodData();
        const int* entry = list->NeighborhoodList();
        auto& bonds = state.bonds[spec.label];
        for (int i = 0; i < list->NumOwnedPoints(); ++i) {
          const int from = body->globalId(list->OwnedIDs()[i]);
          for (int n = *entry++; n > 0; --n) bonds[{from, body->globalId(*entry++)}] = *values++;
        }
      }
  return state;
}

namespace {

constexpr int nSteps = 5;
double loadOf(double step) { return 0.35 * step; }

/// Sums in another order differ by round-off.
constexpr double roundOff = 1e-12;

class StepContract {
 public:
  StepContract(const Sample& sample, PluginKind kind) : sample_(sample), kind_(kind) { expected_ = history({}); }

  std::string broken() {
    evaluateOften();
    splitPoints();
    storeOtherwise();
    takeBack();
    restart();
    renew();
    return lines_;
  }

 private:
  std::vector<FieldState> history(Layout layout) {
    StepRun run(sample_, kind_, layout);
    std::vector<FieldState> states;
    for (int k = 1; k <= nSteps; ++k) {
      run.load(loadOf(k));
      run.evaluate();
      states.push_back(run.state());
      run.accept();
    }
    return states;
  }
  void compare(const FieldState& state, int step, const std::string& what, double tolerance = 0.0) {
    const std::string difference = differenceOf(expected_[static_cast<std::size_t>(step - 1)], state, tolerance);
    if (!difference.empty()) lines_ += what + ", step " + std::to_string(step) + ":" + difference + "\n";
  }

  void evaluateOften() {
    for (const BondSteps steps : {BondSteps::Shared, BondSteps::Copied, BondSteps::Swapped}) {
      if (steps == BondSteps::Shared && sample_.seesItsStep) continue;
      Layout layout;
      layout.bondSteps = steps;
      StepRun run(sample_, kind_, layout);
      for (int k = 1; k <= nSteps; ++k) {
        for (const double part : {0.5, 1.0, 1.0, 1.0}) {  // on the way, and again
          run.load(loadOf(k - 1 + part));
          run.evaluate();
        }
        compare(run.state(), k, "evaluated often");
        run.accept();
      }
    }
  }
  void splitPoints() {
    for (const int nRanks : {1, 3})
      for (const int nBlocks : {1, 2})
        for (const int salt : {0, 7}) {
          Layout layout;
          layout.nRanks = nRanks;
          layout.nBlocks = nBlocks;
          layout.salt = salt;
          const std::vector<FieldState> split = history(layout);
          for (int k = 1; k <= nSteps; ++k)
            compare(split[static_cast<std::size_t>(k - 1)], k, "split over ranks and blocks", roundOff);
        }
  }
  void storeOtherwise() {
    for (const BondSteps steps : {BondSteps::Copied, BondSteps::Swapped}) {
      Layout layout;
      layout.bondSteps = steps;
      const std::vector<FieldState> other = history(layout);
      for (int k = 1; k <= nSteps; ++k) compare(other[static_cast<std::size_t>(k - 1)], k, "stored otherwise");
    }
  }
  void takeBack() {
    for (const BondSteps steps : {BondSteps::Shared, BondSteps::Copied}) {
      Layout layout;
      layout.bondSteps = steps;
      StepRun run(sample_, kind_, layout);
      for (int k = 1; k <= nSteps; ++k) {
        run.begin();
        for (const double further : {2.0, 0.5}) {
          run.load(loadOf(k) + loadOf(further));
          run.evaluate();
          run.takeBack();
        }
        run.load(loadOf(k));
        run.evaluate();
        compare(run.state(), k, "taken back");
        run.accept();
      }
    }
  }
  void restart() {
    constexpr int at = 2;
    StepRun first(sample_, kind_, {}), second(sample_, kind_, {});
    for (int k = 1; k <= at; ++k) first.step(loadOf(k));
    second.goOnFrom(first.state());
    for (int k = at + 1; k <= nSteps; ++k) {
      second.load(loadOf(k));
      second.evaluate();
      compare(second.state(), k, "restarted");
      second.accept();
    }
  }
  void renew() {
    if (kind_ == PluginKind::Material) return;  // no host does it
    StepRun run(sample_, kind_, {});
    for (int k = 1; k <= nSteps; ++k) {
      run.recreate();
      run.load(loadOf(k));
      run.evaluate();
      compare(run.state(), k, "made anew");
      run.accept();
    }
  }

  Sample sample_;
  PluginKind kind_;
  std::vector<FieldState> expected_;
  std::string lines_;
};

}  // namespace

std::string brokenStepContract(const Sample& sample, PluginKind kind) { return StepContract(sample, kind).broken(); }

}  // namespace pdtest
