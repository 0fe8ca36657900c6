#include "spring_tangent.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "../../materials/registry/linear_bonds.hpp"
#include "../linear/springs/border_bonds.hpp"
#include "../model/collective.hpp"
#include "../model/rates.hpp"
#include "Peridigm_Field.hpp"

namespace pd {

namespace {

using namespace PeridigmNS;

// A coarse level is made anew after so many changes of bonds, or where conjugate gradients have become so much slower.
constexpr int mostChanges = 80;
constexpr double slowest = 0.65;
// Down to this residual of a linear solve its products are made in single precision. Who asked for it has residuals of
// its own in double precision, and solves again for what is left.
constexpr double singlePrecision = 1e-6;
constexpr double mostMissed = 10.0;
// Forces are found again around changed bonds alone where these are at no more than one in so many points.
constexpr std::size_t mostOfChanged = 50;

const LinearBonds* linearBondsOf(Block& block) {
  return dynamic_cast<const LinearBonds*>(block.getMaterialModel().get());
}

/// Writes the springs of a block where those of its points belong among all.
void putInOrder(const Discretization& points, const NeighborhoodData& list, const LinearSprings& own,
                LinearSprings& all) {
  if (!own.across.empty()) all.across.resize(all.along.size(), 0.0);
  if (!own.dilatational.empty()) all.dilatational.resize(static_cast<std::size_t>(points.nOwned), 0.0);
  std::ptrdiff_t from = 0;
  const int* at = list.NeighborhoodList();
  for (int p = 0; p < list.NumOwnedPoints(); ++p) {
    const auto point = static_cast<std::size_t>(list.OwnedIDs()[p]);
    const int count = *at;
    at += count + 1;
    const auto to = static_cast<std::ptrdiff_t>(points.neighborhoodStart[point]) - list.OwnedIDs()[p];
    std::copy_n(own.along.begin() + from, count, all.along.begin() + to);
    if (!own.across.empty()) std::copy_n(own.across.begin() + from, count, all.across.begin() + to);
    if (!own.dilatational.empty()) all.dilatational[point] = own.dilatational[static_cast<std::size_t>(p)];
    from += count;
  }
}

/// With other ranks, or with copies of the body beyond planes of symmetry.
bool hasBorders(const Model& model) { return model.comm().size() > 1 || !model.discretization().symmetry.empty(); }

}  // namespace

std::string SpringTangent::obstacle(Model& model) {
  bool isKnown = false;
  LinearSprings::Family family{};
  for (Block& block : *model.blocks()) {
    if (!computesForces(block)) continue;
    const LinearBonds* bonds = linearBondsOf(block);
    const std::string obstacle = bonds == nullptr ? "its material has none" : bonds->springsObstacle();
    if (!obstacle.empty()) return "block \"" + block.getName() + "\": " + obstacle;
    const LinearSprings::Family own = bonds->springFamily();
    if (isKnown && own != family && own != LinearSprings::Family::None && family != LinearSprings::Family::None)
      return "block \"" + block.getName() + "\": its material is of another kind than those of the blocks before";
    if (!isKnown || own != LinearSprings::Family::None) family = own;
    isKnown = true;
  }
  return isKnown ? "" : "no block carries load";
}

/// Where forces are those of the springs, both ends of a bond have broken it or neither, so that either may have all of
/// it. Else a bond to another rank may have broken from one end, and each end has a half.
SpringNetwork SpringTangent::networkOf(Model& model, bool isBody) {
  const Discretization& points = model.discretization();
  LinearSprings all;
  const auto nBonds = static_cast<std::size_t>(points.nBonds());
  // Millions of bonds: what the one block of a body gives is taken as it is.
  const bool isOne = model.blocks()->size() == 1;
  if (!isOne) all.along.assign(nBonds, 0.0);
  for (Block& block : *model.blocks()) {
    if (!computesForces(block)) continue;
    const LinearBonds& bonds = *linearBondsOf(block);
    const auto list = block.getNeighborhoodData();
    if (list->NumOwnedPoints() > 0) {
      LinearSprings own =
          bonds.springs({list->NumOwnedPoints(), list->OwnedIDs(), list->NeighborhoodList()}, *block.getDataManager());
      if (isOne)
        all = std::move(own);
      else
        putInOrder(points, *list, own, all);
    }
    if (bonds.springFamily() != LinearSprings::Family::None) all.family = bonds.springFamily();
  }
  all.along.resize(nBonds, 0.0);
  all.dilatational.resize(static_cast<std::size_t>(points.nOwned), 0.0);
  // Other ranks may have blocks of another kind.
  if (model.comm().any(!all.across.empty())) all.across.resize(nBonds, 0.0);
  SpringNetwork::OtherEnds others{!hasBorders(model), {}, {}};
  if (isBody && hasBorders(model)) {
    const BorderBonds border(model.comm(), model.exchange(), points);
    others.areKnown = border.areMutual();
    if (others.areKnown) others.along = border.ofOtherEnds(all.along);
    if (others.areKnown && !all.across.empty()) others.across = border.ofOtherEnds(all.across);
  }
  return SpringNetwork(model.comm(), points, all.family, all.along, all.across, all.dilatational, others);
}

SpringTangent::SpringTangent(Model& model, bool isBody)
    : model_(model),
      isBody_(isBody),
      network_(networkOf(model, isBody)),
      stiffness_(network_, model.exchange(), hasBorders(model)),
      levels_(model.comm(), stiffness_),
      seenDamage_(static_cast<std::size_t>(model.nOwned()), std::numeric_limits<double>::quiet_NaN()),
      firstBond_(seenDamage_.size()),
      isUntaken_(seenDamage_.size(), 0) {
  stalePoints_ = allPoints();
  for (Block& block : *model.blocks()) {
    const auto list = block.getNeighborhoodData();
    const int* at = list->NeighborhoodList();
    std::size_t bond = 0;
    for (int p = 0; p < list->NumOwnedPoints(); ++p, at += *at + 1) {
      firstBond_[static_cast<std::size_t>(list->OwnedIDs()[p])] = bond;
      bond += static_cast<std::size_t>(*at);
    }
  }
  for (PointVector<double>* vector : {&right_, &solution_, &full_, &change_, &knownImage_})
    *vector = PointVector<double>(model.nPoints(), network_.dimension());
  single_ = singleImage_ = PointVector<float>(model.nPoints(), network_.dimension());
}

void SpringTangent::hold(const std::vector<char>& isHeld) {
  if (isHeld == isHeld_) return;
  for (std::size_t i = 0; i < isHeld.size(); ++i)
    if (isHeld[i] && (isHeld_.empty() || !isHeld_[i])) newlyHeld_.push_back(static_cast<int>(i / 3));
  isHeld_ = isHeld;
  stiffness_.hold(isHeld);
  stalePoints_ = allPoints();
  coarseIsCurrent_ = false;
}

std::vector<int> SpringTangent::allPoints() const {
  std::vector<int> points(static_cast<std::size_t>(model_.nOwned()));
  std::iota(points.begin(), points.end(), 0);
  return points;
}

void SpringTangent::forgetHistory() {
  mustRebuild_ = true;
  freshRate_ = 0.0;
  knowsImage_ = false;
  expectedRest_ = std::numeric_limits<double>::max();
}

/// Reads the bonds of points whose Damage has changed.
void SpringTangent::takeUpDamage() {
  auto& fields = FieldManager::self();
  const int id = fields.hasField("Bond_Damage") ? fields.getFieldId("Bond_Damage") : -1;
  const double* damage = model_.hasField("Damage") ? model_.field("Damage") : nullptr;
  std::vector<int> changed;
  std::vector<const double*> bondsOf;
  for (Block& block : *model_.blocks()) {
    double* values = nullptr;
    if (id >= 0 && block.hasData(id, PeridigmField::STEP_NP1))
      block.getData(id, PeridigmField::STEP_NP1)->ExtractView(&values);
    const auto list = block.getNeighborhoodData();
    for (int p = 0; p < list->NumOwnedPoints(); ++p) {
      const auto point = static_cast<std::size_t>(list->OwnedIDs()[p]);
      const double now = damage == nullptr || values == nullptr ? 0.0 : damage[point];
      if (now == seenDamage_[point] && (damage != nullptr || values == nullptr)) continue;
      seenDamage_[point] = now;
      changed.push_back(static_cast<int>(point));
      bondsOf.push_back(values == nullptr ? nullptr : values + firstBond_[point]);
    }
  }
  if (!model_.comm().any(!changed.empty())) return;
  std::vector<const double*> ofPoint(static_cast<std::size_t>(model_.nOwned()), nullptr);
  for (std::size_t k = 0; k < changed.size(); ++k) ofPoint[static_cast<std::size_t>(changed[k])] = bondsOf[k];
  network_.setDamage(changed, [&](int point) { return ofPoint[static_cast<std::size_t>(point)]; });
  if (isBody_) requireWholeBonds(changed);
  std::sort(changed.begin(), changed.end());
  stiffness_.refresh(changed);
  changedSince_.insert(changedSince_.end(), changed.begin(), changed.end());
  for (const int i : changed) isUntaken_[static_cast<std::size_t>(i)] = 1;
  std::vector<int> stale;
  std::set_union(stalePoints_.begin(), stalePoints_.end(), changed.begin(), changed.end(), std::back_inserter(stale));
  stalePoints_ = std::move(stale);
  coarseIsCurrent_ = false;
}

/// Each end gives half of a bond's force: what one damage model breaks and another does not keeps a half, which no
/// spring of two ends has, nor one for each end, as bonds to other ranks have. Collective.
void SpringTangent::requireWholeBonds(const std::vector<int>& changed) const {
  const auto across =
      hasBorders(model_) ? network_.brokenFromOtherSide(model_.comm(), changed) : std::pair<int, int>{-1, -1};
  const auto [i, j] = network_.brokenFromOneEnd().first < 0 ? across : network_.brokenFromOneEnd();
  collectively(model_.comm(), [&, broken = i, whole = j] {
    if (broken >= 0) refuseHalfBond(broken, whole);
  });
}

void SpringTangent::refuseHalfBond(int i, int j) const {
  const auto placeOf = [&](int point) {
    const double* x = &model_.discretization().x[3 * static_cast<std::size_t>(point)];
    return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", x[0], x[1], x[2]);
  };
  throw RunError(fmt::format(
      "\"Kinematics: Small Strain\": the point at {} has broken its bond to that at {}, which has not: blocks that "
      "differ in their damage models, and tear at each other, need \"Kinematics: Finite\"; or give them one Damage "
      "Model",
      placeOf(i), placeOf(j)));
}

bool SpringTangent::hasSprings(int point) const {
  for (int k = 0; k < network_.nNeighbors(point); ++k)
    if (network_.alive(point, k) > 0.0F) return true;
  return false;
}

bool SpringTangent::keepsTogether() {
  if (!bondsAreKnown_) takeUpDamage();
  bondsAreKnown_ = true;
  return !model_.comm().any(!network_.hasKeptTogether());
}

void SpringTangent::refreshSmoother() {
  if (model_.comm().any(!stalePoints_.empty())) levels_.refreshSmoother(stalePoints_);
  stalePoints_.clear();
}

const SpringOperator& SpringTangent::stiffness() {
  if (!bondsAreKnown_) takeUpDamage();
  bondsAreKnown_ = true;
  refreshSmoother();
  return stiffness_;
}

std::vector<int> SpringTangent::takeChangedPoints() {
  std::vector<int> points;
  for (std::size_t i = 0; i < isUntaken_.size(); ++i)
    if (isUntaken_[i] != 0) points.push_back(static_cast<int>(i));
  std::fill(isUntaken_.begin(), isUntaken_.end(), 0);
  return points;
}

void SpringTangent::prepare() {
  if (!bondsAreKnown_) takeUpDamage();
  bondsAreKnown_ = true;
  const bool isCurrent = !model_.comm().any(!coarseIsCurrent_);
  if (!isCurrent) {
    ++nChanges_;
    expectedRest_ = std::numeric_limits<double>::max();
  }
  // The coarse level's displacements must be stiff against springs: those that move a held point tear at its springs.
  const bool tears = model_.comm().any(
      std::any_of(newlyHeld_.begin(), newlyHeld_.end(), [&](int point) { return hasSprings(point); }));
  newlyHeld_.clear();
  const bool isStale = mustRebuild_ || tears || nChanges_ >= mostChanges;
  coarseIsCurrent_ = true;
  refreshSmoother();
  if (isStale) rebuildLevels();
}

void SpringTangent::rebuildLevels() {
  levels_.rebuild();
  findNormOfDiagonal();
  nChanges_ = 0;
  freshRate_ = 0.0;
  mustRebuild_ = false;
}

void SpringTangent::toSinglePrecision(const PointVector<double>& x, double factor) {
  for (int c = 0; c < x.nComponents(); ++c)
    for (int i = 0; i < model_.nOwned(); ++i) single_[c][i] = static_cast<float>(factor * x[c][i]);
}

void SpringTangent::applyInSinglePrecision(const PointVector<double>& x, PointVector<double>& y) {
  const int n = model_.nOwned();
  const double largest = model_.comm().max(largestSize(x, n));
  const double scale = largest > 0.0 ? largest : 1.0;
  toSinglePrecision(x, 1.0 / scale);
  stiffness_.apply(single_, singleImage_);
  for (int c = 0; c < x.nComponents(); ++c)
    for (int i = 0; i < n; ++i) y[c][i] = scale * static_cast<double>(singleImage_[c][i]);
}

void SpringTangent::force(const double* displacement, double* forceDensity, double mostError) {
  if (!bondsAreKnown_) takeUpDamage();
  bondsAreKnown_ = true;
  const auto n = static_cast<std::size_t>(model_.nOwned());
  std::fill(forceDensity + 3 * n, forceDensity + 3 * static_cast<std::size_t>(model_.nPoints()), 0.0);
  for (int c = 0; c < network_.dimension(); ++c)
    for (std::size_t i = 0; i < n; ++i) full_[c][i] = displacement[3 * i + static_cast<std::size_t>(c)];
  applyToDisplacement(mostError);
  const double *volume = model_.field("Volume"), unit = network_.stiffnessUnit();
  std::array<const double*, 3> image{};
  for (int c = 0; c < network_.dimension(); ++c) image[static_cast<std::size_t>(c)] = knownImage_[c];
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < 3; ++c)
      forceDensity[3 * i + c] = image[c] == nullptr ? 0.0 : -unit * image[c][i] / volume[i];
}

void SpringTangent::applyToDisplacement(double mostError) {
  const auto n = static_cast<std::size_t>(model_.nOwned());
  bool isSame =
      knowsImage_ && !(stiffness_.isDistributed() && network_.hasHalves()) && changedSince_.size() <= n / mostOfChanged;
  for (int c = 0; c < network_.dimension() && isSame; ++c)
    isSame = std::equal(full_[c], full_[c] + n, knownDisplacement_[c]);
  isSame = !model_.comm().any(!isSame);
  if (isSame && model_.comm().any(!changedSince_.empty())) {
    std::sort(changedSince_.begin(), changedSince_.end());
    changedSince_.erase(std::unique(changedSince_.begin(), changedSince_.end()), changedSince_.end());
    stiffness_.updateAll(changedSince_, full_, knownResponses_, knownImage_);
  } else if (!isSame && !followDisplacement(mostError)) {
    knownDisplacement_ = full_;
    stiffness_.applyToAll(full_, knownImage_);
    knownResponses_ = stiffness_.responses();
    knownError_ = 0.0;
  }
  changedSince_.clear();
  knowsImage_ = true;
}

bool SpringTangent::followDisplacement(double mostError) {
  if (mostError <= 0.0 || model_.comm().any(!knowsImage_ || !changedSince_.empty())) return false;
  const int n = model_.nOwned();
  for (int c = 0; c < network_.dimension(); ++c)
    for (int i = 0; i < n; ++i) change_[c][i] = full_[c][i] - knownDisplacement_[c][i];
  const double largest = model_.comm().max(largestSize(change_, n));
  if (largest == 0.0) return true;
  // Each sum of a point's springs is off by no more than what rounding makes of the largest displacement.
  const double error = std::numeric_limits<float>::epsilon() * largest * normOfWholeDiagonal_;  // reactions, too
  if (!(error > 0.0 && knownError_ + error <= mostError)) return false;
  knownError_ += error;
  toSinglePrecision(change_, 1.0 / largest);
  stiffness_.applyToAll(single_, singleImage_);
  const PointVector<float>& responses = stiffness_.responses<float>();
  for (int c = 0; c < network_.dimension(); ++c)
    for (int i = 0; i < n; ++i) {
      knownImage_[c][i] += largest * static_cast<double>(singleImage_[c][i]);
      knownDisplacement_[c][i] = full_[c][i];
    }
  for (int c = 0; c < responses.nComponents(); ++c)
    for (int i = 0; i < n; ++i) knownResponses_[c][i] += largest * static_cast<double>(responses[c][i]);
  stiffness_.bringToOthers(full_, knownResponses_);
  return true;
}

void SpringTangent::copyForceToBlocks() {
  const double* total = model_.field("Force_Density");
  const int id = FieldManager::self().getFieldId("Force_Density");
  for (Block& block : *model_.blocks()) {
    double* own = nullptr;
    block.getData(id, PeridigmField::STEP_NP1)->ExtractView(&own);
    if (own != total) std::copy_n(total, 3 * static_cast<std::size_t>(model_.nPoints()), own);
  }
}

double SpringTangent::normOfRight() const { return std::sqrt(model_.comm().sum(dot(right_, right_, model_.nOwned()))); }

LinearSolveReport SpringTangent::solve(const double* b, double* x, double tolerance, int maximumIterations,
                                       const Product& product) {
  prepare();
  const auto n = static_cast<std::size_t>(model_.nOwned());
  const double unit = network_.stiffnessUnit();
  const int dimension = network_.dimension();
  for (int c = 0; c < dimension; ++c)
    for (std::size_t i = 0; i < n; ++i) right_[c][i] = b[3 * i + static_cast<std::size_t>(c)] / unit;
  stiffness_.zeroHeld(right_);
  // What the last solve left is more than it was to leave: single precision was not enough.
  const double norm = normOfRight();
  const bool hasMissed = norm > mostMissed * expectedRest_;
  expectedRest_ = tolerance * norm;
  bool isSingle = !product && tolerance >= singlePrecision && !hasMissed;
  std::vector<double> flat(product ? 3 * n : 0), flatImage(flat.size());
  const PointMap stiffness = [&](PointVector<double>& from, PointVector<double>& to) {
    if (!product) return isSingle ? applyInSinglePrecision(from, to) : stiffness_.apply(from, to);
    for (int c = 0; c < dimension; ++c)
      for (std::size_t i = 0; i < n; ++i) flat[3 * i + static_cast<std::size_t>(c)] = from[c][i];
    product(flat.data(), flatImage.data());
    for (int c = 0; c < dimension; ++c)
      for (std::size_t i = 0; i < n; ++i) to[c][i] = flatImage[3 * i + static_cast<std::size_t>(c)] / unit;
    stiffness_.addAdditions(from, to);
    stiffness_.zeroHeld(to);
  };
  const auto search = [&] {
    return conjugateGradients(
        model_.comm(), model_.nOwned(), stiffness,
        [&](PointVector<double>& r, PointVector<double>& z) { levels_.apply(r, z); }, right_, solution_, tolerance,
        maximumIterations);
  };
  ConjugateGradientsResult result = search();
  // Where something hardly hangs together, rounding may be more than what resists.
  if (isSingle && (result.hasBrokenDown || result.relativeResidual > tolerance)) {
    isSingle = false;
    result = search();
  }
  // Nor is a coarse level the last word that is of bonds that have broken since.
  if (nChanges_ > 0 && (result.hasBrokenDown || result.relativeResidual > tolerance)) {
    rebuildLevels();
    result = search();
  }
  std::fill(x, x + 3 * n, 0.0);
  for (int c = 0; c < dimension; ++c)
    for (std::size_t i = 0; i < n; ++i) x[3 * i + static_cast<std::size_t>(c)] = solution_[c][i];
  if (!product && result.iterations >= 4 && !result.hasBrokenDown) {
    const double rate = -std::log10(std::max(result.relativeResidual, 1e-16)) / result.iterations;
    if (nChanges_ == 0) freshRate_ = std::max(freshRate_, rate);
    mustRebuild_ = mustRebuild_ || (nChanges_ > 0 && rate < slowest * freshRate_);
  }
  return {result.iterations, result.hasBrokenDown ? 1.0 : result.relativeResidual,
          !result.hasBrokenDown && result.relativeResidual <= tolerance, "CG"};
}

double SpringTangent::meanBondMotion(const double* displacement) const {
  constexpr int sampleSize = 50;
  const double* x = model_.field("Model_Coordinates");
  const auto squaredDistance = [](const double* a, const double* b) {
    double sum = 0.0;
    for (int d = 0; d < 3; ++d) sum += (b[d] - a[d]) * (b[d] - a[d]);
    return sum;
  };
  double sum = 0.0, count = 0.0;
  for (int i = 0; i < model_.nOwned(); i += 1 + model_.nOwned() / sampleSize)
    for (int k = 0; k < network_.nNeighbors(i); ++k) {
      if (!(network_.alive(i, k) > 0.0F)) continue;
      const int j = network_.neighbors(i)[k];
      sum += std::sqrt(squaredDistance(displacement + 3 * i, displacement + 3 * j) /
                       squaredDistance(x + 3 * i, x + 3 * j));
      count += 1.0;
    }
  sum = model_.comm().sum(sum);
  count = model_.comm().sum(count);
  return count > 0.0 ? sum / count : 0.0;
}

void SpringTangent::findNormOfDiagonal() {
  const PointVector<double>& diagonal = levels_.diagonal();
  double free = 0.0, held = 0.0;
  for (int c = 0, at = 0; c < network_.dimension(); at += network_.dimension() - c, ++c)
    for (int i = 0; i < model_.nOwned(); ++i) {
      const double square = diagonal[at][i] * diagonal[at][i];
      (stiffness_.isHeld(i, c) ? held : free) += square;
    }
  free = model_.comm().sum(free);
  held = model_.comm().sum(held);
  normOfDiagonal_ = network_.stiffnessUnit() * std::sqrt(free);
  normOfWholeDiagonal_ = network_.stiffnessUnit() * std::sqrt(free + held);
}

}  // namespace pd
