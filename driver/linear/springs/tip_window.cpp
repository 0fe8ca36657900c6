#include "tip_window.hpp"

#include <Teuchos_BLAS.hpp>
#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pd {

namespace {

// Changes that are kept beside G: a few times as many take longer in each event than what is saved.
constexpr std::size_t mostChanges = 96;

using Blas = Teuchos::BLAS<int, double>;
using Lapack = Teuchos::LAPACK<int, double>;

long long keyOf(int i, int j) {
  return (static_cast<long long>(std::min(i, j)) << 32) + static_cast<long long>(std::max(i, j));
}

}  // namespace

std::string TipWindow::obstacle(const SpringOperator& stiffness) {
  const SpringNetwork& network = stiffness.network();
  if (stiffness.isDistributed()) return "the body is on several ranks, or has planes of symmetry";
  if (network.dimension() != 2) return "the body is no plane one";
  if (network.familyWidth() > 0 || network.hasAcross())
    return "the material's bonds do more than resist along themselves (PDHE at the one Poisson's ratio, or Elastic "
           "Bond "
           "Based, are of those that do not)";
  return "";
}

TipWindow::TipWindow(const SpringOperator& stiffness, const Corridor& corridor, const std::vector<int>& read,
                     const std::vector<int>& changing, const double* displacement)
    : stiffness_(stiffness),
      dimension_(stiffness.network().dimension()),
      points_(read),
      nRead_(static_cast<int>(read.size())) {
  points_.insert(points_.end(), changing.begin(), changing.end());
  const SpringNetwork& network = stiffness.network();
  const auto n = static_cast<std::size_t>(network.points().nOwned);
  placeOf_.assign(n, -1);
  for (std::size_t p = 0; p < points_.size(); ++p) placeOf_[static_cast<std::size_t>(points_[p])] = static_cast<int>(p);
  isInside_.assign(n, 0);
  for (const int i : points_)
    isInside_[static_cast<std::size_t>(i)] =
        std::all_of(network.neighbors(i), network.neighbors(i) + network.nNeighbors(i),
                    [&](int j) { return contains(j); })
            ? 1
            : 0;
  isHeld_.resize(3 * n);
  for (std::size_t d = 0; d < isHeld_.size(); ++d)
    isHeld_[d] = stiffness.isHeld(static_cast<int>(d / 3), static_cast<int>(d % 3)) ? 1 : 0;
  additions_ = stiffness.additions();
  for (const int i : points_)
    for (int c = 0; c < dimension_; ++c) {
      const bool isHeld = stiffness.isHeld(i, c);
      unknownOf_.push_back(isHeld ? -1 : nUnknowns_++);
      if (isHeld) continue;
      base_.push_back(displacement[3 * i + c]);
      if (!hasColumns(i)) firstColumn_ = nUnknowns_;
    }
  now_ = base_;
  remember();
  CorridorResponse columns = corridor.response(points_, changing);
  trouble_ = std::move(columns.trouble);
  inverse_ = std::move(columns.values);
}

/// The springs of the window, and which of its bonds are unbroken.
void TipWindow::remember() {
  const SpringNetwork& network = stiffness_.network();
  for (const int i : points_) {
    std::vector<float>& own = alive_.emplace_back();
    for (int k = 0; k < network.nNeighbors(i); ++k) own.push_back(network.alive(i, k));
  }
  network.forEachSpringIn([&](int i) { return contains(i); },
                          [&](int i, int j, const double*, const SpringConstants<double>& c) {
                            if (contains(j)) springs_.emplace_back(keyOf(i, j), c.radial);
                          });
  std::sort(springs_.begin(), springs_.end());
}

int TipWindow::unknownOf(int point, int component) const {
  const int place = placeOf_[static_cast<std::size_t>(point)];
  return place < 0 ? -1
                   : unknownOf_[static_cast<std::size_t>(place) * static_cast<std::size_t>(dimension_) +
                                static_cast<std::size_t>(component)];
}

bool TipWindow::hasColumns(int point) const { return placeOf_[static_cast<std::size_t>(point)] >= nRead_; }

double TipWindow::Change::elongation(const double* unknowns) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < unknown.size(); ++k)
    if (unknown[k] >= 0) sum += factor[k] * unknowns[unknown[k]];
  return sum;
}

/// Its column of G, and what it has to do with the changes before.
void TipWindow::add(const Change& change) {
  const auto n = static_cast<std::size_t>(nUnknowns_);
  columns_.resize((changes_.size() + 1) * n, 0.0);
  double* column = &columns_[changes_.size() * n];
  for (std::size_t k = 0; k < change.unknown.size(); ++k) {
    if (change.unknown[k] < 0) continue;
    const double* from = &inverse_[static_cast<std::size_t>(change.unknown[k] - firstColumn_) * n];
    for (std::size_t r = 0; r < n; ++r) column[r] += change.factor[k] * from[r];
  }
  changes_.push_back(change);
  for (const Change& other : changes_) couplings_.push_back(other.elongation(column));
}

void TipWindow::breakSpring(int i, int j, double change, const double* displacement) {
  const PointVector<double>& places = stiffness_.network().places<double>();
  Change spring;
  spring.flexibility = 1.0 / change;
  std::size_t at = 0;
  for (int c = 0; c < dimension_; ++c) {
    const double xi = places[c][j] - places[c][i];
    for (const int point : {i, j}) {
      const double factor = point == i ? -xi : xi;
      spring.unknown[at] = unknownOf(point, c);
      spring.factor[at] = factor;
      if (spring.unknown[at] < 0) spring.rest -= factor * displacement[3 * point + c];
      ++at;
    }
  }
  add(spring);
}

/// False where something must not change.
bool TipWindow::supportUnknown(int unknown, double flexibility, double place) {
  if (unknown < firstColumn_) return false;
  Change support;
  support.unknown[0] = unknown;
  support.factor[0] = 1.0;
  support.flexibility = flexibility;
  support.rest = place;
  add(support);
  return true;
}

double TipWindow::stiffnessOf(int i, int j) const {
  const auto found = std::lower_bound(springs_.begin(), springs_.end(), std::make_pair(keyOf(i, j), -HUGE_VAL));
  return found != springs_.end() && found->first == keyOf(i, j) ? found->second : 0.0;
}

bool TipWindow::takeUpPoint(int point, const double* displacement) {
  const SpringNetwork& network = stiffness_.network();
  if (!contains(point)) return false;
  std::vector<float>& seen = alive_[static_cast<std::size_t>(placeOf_[static_cast<std::size_t>(point)])];
  for (int k = 0; k < network.nNeighbors(point); ++k) {
    const int other = network.neighbors(point)[k];
    const float before = seen[static_cast<std::size_t>(k)], after = network.alive(point, k);
    if (before == after) continue;
    // Springs break as a whole.
    if (!hasColumns(point) || !hasColumns(other) || after != 0.0F || before != 1.0F) return false;
    seen[static_cast<std::size_t>(k)] = after;
    const double stiffness = stiffnessOf(point, other);
    if (point < other && stiffness != 0.0) breakSpring(point, other, -stiffness, displacement);
  }
  return true;
}

bool TipWindow::takeUpHeld(const double* displacement) {
  if (isHeld_ == stiffness_.held()) return true;
  for (std::size_t d = 0; d < isHeld_.size(); ++d) {
    const auto point = static_cast<int>(d / 3), component = static_cast<int>(d % 3);
    const bool isHeld = stiffness_.isHeld(point, component);
    if (isHeld == (isHeld_[d] != 0)) continue;
    const int unknown = component < dimension_ ? unknownOf(point, component) : -1;
    if (!isHeld || !supportUnknown(unknown, 0.0, displacement[d])) return false;
    isHeld_[d] = 1;
  }
  return true;
}

/// Additions carry no force where the point is now.
bool TipWindow::takeUpAdditions(const double* displacement) {
  const auto isBefore = [](const auto& a, const auto& b) {
    return a.point < b.point || (a.point == b.point && a.component < b.component);
  };
  const std::vector<SpringOperator::Addition>& now = stiffness_.additions();
  const auto change = [&](const SpringOperator::Addition& addition, double value) {
    if (value == 0.0) return true;
    const int unknown = unknownOf(addition.point, addition.component);
    if (unknown < firstColumn_) return false;
    return stiffness_.isHeld(addition.point, addition.component) ||
           supportUnknown(unknown, 1.0 / value, displacement[3 * addition.point + addition.component]);
  };
  bool isInside = true;
  auto old = additions_.begin();
  for (const SpringOperator::Addition& addition : now) {
    for (; old != additions_.end() && isBefore(*old, addition); ++old) isInside = change(*old, -old->value) && isInside;
    double value = addition.value;
    if (old != additions_.end() && !isBefore(addition, *old)) value -= old++->value;
    isInside = change(addition, value) && isInside;
  }
  for (; old != additions_.end(); ++old) isInside = change(*old, -old->value) && isInside;
  additions_ = now;
  return isInside;
}

bool TipWindow::takeUp(const std::vector<int>& changed, const double* displacement) {
  for (const int point : changed)
    if (!takeUpPoint(point, displacement)) return false;
  return takeUpHeld(displacement) && takeUpAdditions(displacement);
}

/// Of the matrix between the changes.
bool TipWindow::findFactors(std::vector<double>& matrix, std::vector<int>& pivots) const {
  const std::size_t k = changes_.size();
  matrix.resize(k * k);
  for (std::size_t c = 0, at = 0; c < k; ++c)
    for (std::size_t r = 0; r <= c; ++r, ++at)
      matrix[c * k + r] = matrix[r * k + c] = couplings_[at] + (r == c ? changes_[c].flexibility : 0.0);
  pivots.resize(k);
  int info = 0;
  const auto size = static_cast<int>(k);
  Lapack().GETRF(size, size, matrix.data(), size, pivots.data(), &info);
  return info == 0;
}

bool TipWindow::solve(double* displacement) {
  if (!changes_.empty()) {
    std::vector<double> matrix, forces;
    std::vector<int> pivots;
    if (!findFactors(matrix, pivots)) return false;
    for (const Change& change : changes_) forces.push_back(change.elongation(base_.data()) - change.rest);
    const std::vector<double> elongations = forces;
    int info = 0;
    const auto size = static_cast<int>(changes_.size());
    Lapack().GETRS('N', size, 1, matrix.data(), size, pivots.data(), forces.data(), size, &info);
    releasedByChanges_ = -0.5 * stiffness_.network().stiffnessUnit() *
                         std::inner_product(forces.begin(), forces.end(), elongations.begin(), 0.0);
    now_ = base_;
    Blas().GEMV(Teuchos::NO_TRANS, nUnknowns_, size, -1.0, columns_.data(), nUnknowns_, forces.data(), 1, 1.0,
                now_.data(), 1);
    if (!std::all_of(now_.begin(), now_.end(), [](double u) { return std::isfinite(u); })) return false;
  }
  std::size_t at = 0;
  for (const int i : points_)
    for (int c = 0; c < dimension_; ++c, ++at)
      if (unknownOf_[at] >= 0 && !stiffness_.isHeld(i, c))
        displacement[3 * i + c] = now_[static_cast<std::size_t>(unknownOf_[at])];
  return changes_.size() < mostChanges || workIn();
}

double TipWindow::distanceFrom(const double* displacement) const {
  double most = 0.0, largest = std::numeric_limits<double>::min();
  for (std::size_t at = 0; at < unknownOf_.size(); ++at) {
    const auto c = static_cast<int>(at) % dimension_, i = points_[at / static_cast<std::size_t>(dimension_)];
    const double u = displacement[3 * i + c];
    largest = std::max(largest, std::abs(u));
    if (unknownOf_[at] >= 0 && !stiffness_.isHeld(i, c))
      most = std::max(most, std::abs(u - now_[static_cast<std::size_t>(unknownOf_[at])]));
  }
  return most / largest;
}

/// G takes the changes up.
bool TipWindow::workIn() {
  std::vector<double> matrix;
  std::vector<int> pivots;
  if (!findFactors(matrix, pivots)) return false;
  const std::size_t k = changes_.size(), n = static_cast<std::size_t>(nUnknowns_),
                    first = static_cast<std::size_t>(firstColumn_);
  std::vector<double> rows(k * (n - first));
  for (std::size_t c = 0; c < k; ++c)
    for (std::size_t r = first; r < n; ++r) rows[(r - first) * k + c] = columns_[c * n + r];
  int info = 0;
  const int size = static_cast<int>(k), nColumns = nUnknowns_ - firstColumn_;
  Lapack().GETRS('N', size, nColumns, matrix.data(), size, pivots.data(), rows.data(), size, &info);
  Blas().GEMM(Teuchos::NO_TRANS, Teuchos::NO_TRANS, nUnknowns_, nColumns, size, -1.0, columns_.data(), nUnknowns_,
              rows.data(), size, 1.0, inverse_.data(), nUnknowns_);
  base_ = now_;
  released_ += std::exchange(releasedByChanges_, 0.0);
  changes_.clear();
  columns_.clear();
  couplings_.clear();
  return true;
}

}  // namespace pd
