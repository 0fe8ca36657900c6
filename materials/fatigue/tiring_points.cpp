#include "tiring_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "bond_family.hpp"

namespace pd {

namespace {

// Where bonds of more points than one in so many may have reached a limit, all are looked at again.
constexpr std::size_t mostReaching = 4;
// Where that shows as many, so many calls do without a look.
constexpr int callsBetweenVainLooks = 20;
// Of a stretch: what rounding of coordinates may make of it.
constexpr double roundingOfStretch = 1e-12;

// Of the square of a length: what rounding may make of it.
constexpr double roundingOfSquare = 1e-12;

bool isSame(const std::vector<double>& before, const double* now) {
  return std::memcmp(before.data(), now, before.size() * sizeof(double)) == 0;
}

double squaredDistance(const double* a, const double* b) {
  double sum = 0.0;
  for (int d = 0; d < 3; ++d) sum += (b[d] - a[d]) * (b[d] - a[d]);
  return sum;
}

}  // namespace

TiringPoints::TiringPoints(const Call& call)
    : nOwned_(call.nOwned), ownedIds_(call.ownedIds), list_(call.neighborhoodList), firstBond_{0} {
  const int* entry = call.neighborhoodList;
  for (int p = 0; p < call.nOwned; ++p, entry += *entry + 1) {
    firstBond_.push_back(firstBond_.back() + static_cast<std::size_t>(*entry));
    IdRange range{ownedIds_[p], ownedIds_[p] + 1};
    for (int k = 1; k <= *entry; ++k) range = {std::min(range.first, entry[k]), std::max(range.last, entry[k] + 1)};
    family_.push_back(range);
  }
  for (int p = 1; p < nOwned_; ++p) areConsecutive_ = areConsecutive_ && ownedIds_[p] == ownedIds_[p - 1] + 1;
}

void TiringPoints::clear(double* values) const {
  if (areConsecutive_ && nOwned_ > 0) {
    std::fill_n(values + ownedIds_[0], nOwned_, 0.0);
  } else {
    for (int p = 0; p < nOwned_; ++p) values[ownedIds_[p]] = 0.0;
  }
}

bool TiringPoints::isFor(const Call& call) const {
  return nOwned_ == call.nOwned && ownedIds_ == call.ownedIds && list_ == call.neighborhoodList;
}

/// Ids [first, last) of what differs; none where first is last.
TiringPoints::IdRange TiringPoints::takeUpCracked(const double* damage, int nPoints, double cracked) {
  const auto n = static_cast<std::size_t>(nPoints);
  if (isCracked_.size() != n) {
    isCracked_.clear();
    for (std::size_t i = 0; i < n; ++i) isCracked_.push_back(damage[i] >= cracked ? 1 : 0);
    return {0, nPoints};
  }
  char anyDiffers = 0;
  for (std::size_t i = 0; i < n; ++i) anyDiffers |= static_cast<char>(isCracked_[i] ^ (damage[i] >= cracked ? 1 : 0));
  IdRange range{0, 0};
  for (std::size_t i = 0; anyDiffers != 0 && i < n; ++i) {
    const char isCracked = damage[i] >= cracked ? 1 : 0;
    if (std::exchange(isCracked_[i], isCracked) == isCracked) continue;
    const auto id = static_cast<int>(i);
    range = {range.last == 0 ? id : range.first, id + 1};
  }
  return range;
}

void TiringPoints::markTips(const double* damage, int nPoints, double cracked, double* nearTip) {
  const auto nPointsOfBlock = static_cast<std::size_t>(nOwned_);
  const IdRange changed = takeUpCracked(damage, nPoints, cracked);
  marks_.resize(nPointsOfBlock, 0.0);
  for (std::size_t p = 0; changed.last > 0 && p < nPointsOfBlock; ++p) {
    if (!reaches(p, changed)) continue;
    bool isNear = isCracked_[static_cast<std::size_t>(ownedIds_[p])] != 0;
    for (std::size_t bond = firstBond_[p]; bond < firstBond_[p + 1] && !isNear; ++bond)
      isNear = isCracked_[static_cast<std::size_t>(neighbor(bond, p))] != 0;
    marks_[p] = isNear ? 1.0 : 0.0;
  }
  if (areConsecutive_ && nOwned_ > 0) {
    std::copy(marks_.begin(), marks_.end(), nearTip + ownedIds_[0]);
  } else {
    for (std::size_t p = 0; p < nPointsOfBlock; ++p) nearTip[ownedIds_[p]] = marks_[p];
  }
}

void TiringPoints::startFrom(const double* before, double* lost) {
  if (before_ != before || lost_ != lost) {
    std::copy(before, before + firstBond_.back(), lost);
  } else {
    for (const std::size_t p : tiring_)
      std::copy(before + firstBond_[p], before + firstBond_[p + 1], lost + firstBond_[p]);
  }
  before_ = before;
  lost_ = lost;
  tiring_.clear();
}

void TiringPoints::findBesideTips(const double* nearTip, int nPoints) {
  const auto n = static_cast<std::size_t>(nPoints);
  if (nearTip_.size() == n && isSame(nearTip_, nearTip)) return;
  IdRange changed{0, nPoints};
  if (nearTip_.size() == n) {
    const auto first = std::mismatch(nearTip_.begin(), nearTip_.end(), nearTip).first;
    const auto fromEnd =
        std::mismatch(nearTip_.rbegin(), nearTip_.rend(), std::make_reverse_iterator(nearTip + n)).first;
    changed = {static_cast<int>(first - nearTip_.begin()), static_cast<int>(nearTip_.rend() - fromEnd)};
  }
  nearTip_.assign(nearTip, nearTip + n);
  tipsHaveChanged_ = true;
  isBesideTip_.resize(static_cast<std::size_t>(nOwned_), 0);
  besideTips_.clear();
  for (std::size_t p = 0; p < isBesideTip_.size(); ++p) {
    if (reaches(p, changed)) {
      bool isBeside = nearTip[ownedIds_[p]] != 0.0;
      for (std::size_t bond = firstBond_[p]; bond < firstBond_[p + 1] && !isBeside; ++bond)
        isBeside = nearTip[neighbor(bond, p)] != 0.0;
      isBesideTip_[p] = isBeside ? 1 : 0;
    }
    if (isBesideTip_[p] != 0) besideTips_.push_back(p);
  }
}

TiringPoints::Known* TiringPoints::known(const double* x, const double* y, int nPoints, double strainRange,
                                         double peak) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  if (tiring_.size() > static_cast<std::size_t>(nOwned_) / mostReaching) return nullptr;
  const auto nPlaces = 3 * static_cast<std::size_t>(nPoints);
  const bool areSame = !tipsHaveChanged_ && knownPoints_ == tiring_;
  const bool isHere = areSame && knownPlaces_.size() == nPlaces && isSame(knownPlaces_, y);
  if (isHere && strainRange == knownRange_ && peak == knownPeak_) {
    tiring_.erase(std::remove_if(tiring_.begin(), tiring_.end(), [&](std::size_t p) { return isLeftOut_[p] != 0; }),
                  tiring_.end());
    return &known_;
  }
  isLeftOut_.assign(static_cast<std::size_t>(nOwned_), 0);
  knownPeak_ = peak;
  if (isHere && strainRange == knownRange_) return &known_;
  knownRange_ = strainRange;
  if (isHere) {
    for (const std::size_t p : seen_)
      std::fill_n(known_.rates.begin() + static_cast<std::ptrdiff_t>(firstKnown_[p]), nBonds(p), nothing);
    return &known_;
  }
  if (!areSame) {
    knownPoints_ = tiring_;
    tipsHaveChanged_ = false;
    findWeights(x);
  }
  knownPlaces_.assign(y, y + nPlaces);
  for (const std::size_t p : knownPoints_) squares_[p] = nothing;
  seen_.clear();
  return &known_;
}

void TiringPoints::findWeights(const double* x) {
  firstKnown_.resize(static_cast<std::size_t>(nOwned_));
  squares_.resize(static_cast<std::size_t>(nOwned_));
  weights_.clear();
  for (const std::size_t p : knownPoints_) {
    firstKnown_[p] = weights_.size();
    const double* own = x + 3LL * ownedIds_[p];
    for (std::size_t bond = firstBond_[p]; bond < firstBond_[p + 1]; ++bond)
      weights_.push_back(before_[bond] >= 1.0 ? 0.0 : 1.0 / squaredDistance(own, x + 3LL * neighbor(bond, p)));
  }
  known_.stretches.resize(weights_.size());
  known_.rates.resize(weights_.size());
}

double TiringPoints::largestSquare(std::size_t point, const double* y) const {
  const double *own = y + 3LL * ownedIds_[point], *weight = &weights_[firstKnown_[point]];
  const int *neighbors = list_ + firstBond_[point] + point + 1, n = nBonds(point);
  double largest[2] = {0.0, 0.0};
  for (int k = 0; k < n; ++k) {
    double& most = largest[k % 2];
    most = std::max(most, squaredDistance(own, y + 3LL * neighbors[k]) * weight[k]);
  }
  return std::max(largest[0], largest[1]);
}

bool TiringPoints::mayStretch(std::size_t point, const double* y, double least) {
  double& square = squares_[point];
  if (std::isnan(square)) {
    // What has come to its end by now shows no more.
    double* weight = &weights_[firstKnown_[point]];
    for (std::size_t bond = firstBond_[point]; bond < firstBond_[point + 1]; ++bond, ++weight)
      if (before_[bond] >= 1.0) *weight = 0.0;
    square = largestSquare(point, y);
    seen_.push_back(point);
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    const auto first = static_cast<std::ptrdiff_t>(firstKnown_[point]);
    std::fill_n(known_.stretches.begin() + first, nBonds(point), nothing);
    std::fill_n(known_.rates.begin() + first, nBonds(point), nothing);
  }
  return least < -1.0 || square > (1.0 + least) * (1.0 + least) * (1.0 - roundingOfSquare);
}

/// Since all were looked at no bond has stretched by more than twice the largest displacement over its length. Returns
/// false where too many may have reached a limit.
bool TiringPoints::findReaching(const double* y, const Limits& limits) {
  double moved2 = 0.0;
  for (std::size_t i = 0; i < seenPlaces_.size(); i += 3)
    moved2 = std::max(moved2, squaredDistance(y + i, seenPlaces_.data() + i));
  const double reach = 2.0 * std::sqrt(moved2) / shortestBond_ * (1.0 + 1e-9) + roundingOfStretch;
  if (!limits.areReachedBy(largestOfAll_ + reach)) {
    tiring_ = besideTips_;
    return tiring_.size() <= largest_.size() / mostReaching;
  }
  tiring_.clear();
  for (std::size_t p = 0; p < largest_.size(); ++p) {
    if (!isBesideTip(p) && !limits.areReachedBy(largest_[p] + reach)) continue;
    tiring_.push_back(p);
    if (tiring_.size() > largest_.size() / mostReaching) return false;
  }
  return true;
}

void TiringPoints::lookAtAll(const double* x, const double* y, int nPoints) {
  seenPlaces_.assign(y, y + 3LL * nPoints);
  largest_.assign(static_cast<std::size_t>(nOwned_), 0.0);
  shortestBond_ = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < largest_.size(); ++p)
    for (std::size_t bond = firstBond_[p]; bond < firstBond_[p + 1]; ++bond) {
      const int i = ownedIds_[p], j = neighbor(bond, p);
      const double length = ReferenceBond(x, i, j).length;
      shortestBond_ = std::min(shortestBond_, length);
      largest_[p] = std::max(largest_[p], std::abs(ReferenceBond(y, i, j).length / length - 1.0));
    }
  largestOfAll_ = largest_.empty() ? 0.0 : *std::max_element(largest_.begin(), largest_.end());
}

const std::vector<std::size_t>& TiringPoints::find(const double* nearTip, const double* x, const double* y, int nPoints,
                                                   const Limits& limits) {
  if (nearTip != nullptr) findBesideTips(nearTip, nPoints);
  const auto all = [&]() -> const std::vector<std::size_t>& {
    tiring_.resize(static_cast<std::size_t>(nOwned_));
    std::iota(tiring_.begin(), tiring_.end(), 0U);
    return tiring_;
  };
  if (!limits.areReachedBy(std::numeric_limits<double>::max())) {
    tiring_ = besideTips_;
    return tiring_;
  }
  if (limits.areReachedBy(roundingOfStretch)) return all();
  if (nCallsToWait_ > 0) {
    --nCallsToWait_;
    return all();
  }
  if (seenPlaces_.size() == 3 * static_cast<std::size_t>(nPoints) && findReaching(y, limits)) return tiring_;
  lookAtAll(x, y, nPoints);
  if (findReaching(y, limits)) return tiring_;
  nCallsToWait_ = callsBetweenVainLooks;
  return all();
}

}  // namespace pd
