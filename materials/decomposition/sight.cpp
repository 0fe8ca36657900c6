#include "sight.hpp"

#include <algorithm>
#include <cmath>

namespace pd::decomposition {

namespace stdx = kernels::stdx;
using kernels::allLanes;
using kernels::choose;
using kernels::greaterBits;
using kernels::Vector;

namespace {

constexpr int mostParts = 64;

struct RangeOfEach {
  Vector low, high;
};

PD_EACH_BOND Vector lengthOf(const RangeOfEach& range) { return stdx::max(range.high - range.low, Vector(0.0)); }
PD_EACH_BOND RangeOfEach common(const RangeOfEach& a, const RangeOfEach& b) {
  return {stdx::max(a.low, b.low), stdx::min(a.high, b.high)};
}

/// Length of the union of n ranges.
template <int n>
PD_EACH_BOND Vector lengthOfUnion(const RangeOfEach* ranges) {
  if constexpr (n == 0) {
    return 0.0;
  } else if constexpr (n == 1) {
    return lengthOf(ranges[0]);
  } else {
    RangeOfEach shared[n - 1];
    for (int k = 0; k + 1 < n; ++k) shared[k] = common(ranges[k], ranges[n - 1]);
    return lengthOfUnion<n - 1>(ranges) + lengthOf(ranges[n - 1]) - lengthOfUnion<n - 1>(shared);
  }
}

double sumOfFirst(const Vector& values, int n) {
  double sum = 0.0;
  for (int lane = 0; lane < n; ++lane) sum += values[static_cast<std::size_t>(lane)];
  return sum;
}

Vector alongOf(const HalfSpace& half, const Place& direction) {
  return half.normal[0] * direction[0] + half.normal[1] * direction[1] + half.normal[2] * direction[2];
}

/// 0, 1, ...
const std::array<double, mostParts>& numbers() {
  static const std::array<double, mostParts> values = [] {
    std::array<double, mostParts> result;
    for (std::size_t k = 0; k < result.size(); ++k) result[k] = static_cast<double>(k);
    return result;
  }();
  return values;
}

/// bounds[m nOther + l] = narrower(bounds[m nOther + l], start + m step + l otherStep) for m < n and l < nOther.
template <class Narrower>
PD_EACH_BOND void narrow(const Vector& start, const Vector& step, const Vector& otherStep, int n, int nOther,
                         Vector* bounds, const Narrower& narrower) {
  const double* number = numbers().data();
  for (int l = 0; l < nOther; ++l) {
    const Vector first = start + number[l] * otherStep;
    Vector* bound = bounds + l;
    for (int m = 0; m < n; ++m, bound += nOther) *bound = narrower(*bound, first + number[m] * step);
  }
}

}  // namespace

void Sight::turnTo(const Cell& cell, const LineGrid& grid, const LineMeasure& measure, const Taken& taken,
                   const std::vector<const Screen*>& screens) {
  cell_ = &cell;
  grid_ = grid;
  measure_ = measure;
  taken_ = &taken;
  screens_ = &screens;
  for (auto& starts : lines_.start) starts.clear();
  const std::size_t nCasts = std::max(screens.size(), low_.size()), nLines = static_cast<std::size_t>(grid_.size());
  low_.resize(nCasts);
  high_.resize(nCasts);
  for (auto* bounds : {&low_, &high_})
    for (auto& ofCast : *bounds)
      if (ofCast.size() < nLines) ofCast.resize(nLines);
}

double Sight::seen(const Places& places, int nPlaces) {
  nCasts_ = 0;
  for (const Screen* screen : *screens_) {
    shadow_.clear();
    if (screen->addShadow(places, cell_->center, shadow_)) {
      const Cover cover = coverOfShadow();
      if (cover == Cover::All) return 0.0;
      if (cover == Cover::Something) castShadow();
    } else {
      castHidden(*screen, places);
    }
  }
  if (nCasts_ == 0) return nPlaces * counted();
  const double all = nPlaces * measure_.whole() * grid_.size();
  switch (static_cast<int>(nCasts_) + taken_->most) {
    case 1:
      return all - sumOfFirst(takenOf<1>(), nPlaces);
    case 2:
      return all - sumOfFirst(takenOf<2>(), nPlaces);
    case 3:
      return all - sumOfFirst(takenOf<3>(), nPlaces);
    case 4:
      return all - sumOfFirst(takenOf<4>(), nPlaces);
    default:
      return all - takenBySorting(nPlaces);
  }
}

/// Of what the half-spaces have in common.
Sight::Cover Sight::coverOfShadow() const {
  bool isAll = true;
  for (const HalfSpace& half : shadow_) {
    Vector reach = 0.0;
    for (const Place& edge : cell_->edges) reach += 0.5 * stdx::abs(alongOf(half, edge));
    if (greaterBits(-reach, half.offset) == allLanes) return Cover::Nothing;
    isAll = isAll && greaterBits(reach, half.offset) == 0;
  }
  return isAll ? Cover::All : Cover::Something;
}

/// Of the half-spaces in shadow_: bounds of the part of each line that is in all of them.
void Sight::castShadow() {
  const auto nLines = static_cast<std::size_t>(grid_.size());
  Vector *low = low_[nCasts_].data(), *high = high_[nCasts_].data();
  ++nCasts_;
  const double whole = measure_.whole(), shift = measure_.counts() ? 0.5 : 0.0;
  std::fill(low, low + nLines, Vector(0.0));
  std::fill(high, high + nLines, Vector(whole));
  for (const HalfSpace& half : shadow_) {
    const Vector slope = alongOf(half, grid_.step), size = stdx::abs(half.normal[0] * grid_.step[0]) +
                                                           stdx::abs(half.normal[1] * grid_.step[1]) +
                                                           stdx::abs(half.normal[2] * grid_.step[2]);
    // Of a line along the plane all or nothing.
    const Vector least = 1e-15 * size + 1e-300;
    const Vector perSlope = whole / choose(slope, least, greaterBits(stdx::abs(slope), least));
    const unsigned char isUpper = greaterBits(perSlope, Vector(0.0));
    const Vector bound = (half.offset - alongOf(half, minus(grid_.first, cell_->center))) * perSlope - shift;
    const Vector change = -alongOf(half, grid_.strides[0]) * perSlope,
                 otherChange = -alongOf(half, grid_.strides[1]) * perSlope;
    if (isUpper != allLanes) {
      const unsigned char bits = static_cast<unsigned char>(~isUpper & allLanes);
      narrow(choose(bound, -beyondAll, bits), choose(change, 0.0, bits), choose(otherChange, 0.0, bits), grid_.n,
             grid_.nOther, low, [](const Vector& a, const Vector& b) PD_INLINED { return stdx::max(a, b); });
    }
    if (isUpper != 0)
      narrow(choose(bound, beyondAll, isUpper), choose(change, 0.0, isUpper), choose(otherChange, 0.0, isUpper),
             grid_.n, grid_.nOther, high, [](const Vector& a, const Vector& b) PD_INLINED { return stdx::min(a, b); });
  }
}

void Sight::castHidden(const Screen& screen, const Places& places) {
  if (lines_.size() == 0) lines_ = linesOf(grid_);
  const std::size_t nLines = lines_.size();
  auto &low = low_[nCasts_], &high = high_[nCasts_];
  if (!screen.hideFromEach(places, lines_, low.data(), high.data())) {
    static thread_local std::vector<double> from, to;
    from.resize(nLines);
    to.resize(nLines);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(kernels::lanes); ++lane) {
      screen.hide({places[0][lane], places[1][lane], places[2][lane]}, lines_, from.data(), to.data());
      for (std::size_t r = 0; r < nLines; ++r) {
        low[r][lane] = from[r];
        high[r][lane] = to[r];
      }
    }
  }
  const double whole = measure_.whole(), shift = measure_.counts() ? 0.5 : 0.0;
  bool hasAny = false;
  for (std::size_t r = 0; r < nLines; ++r) {
    hasAny = hasAny || greaterBits(high[r], low[r]) != 0;
    low[r] = whole * low[r] - shift;
    high[r] = whole * high[r] - shift;
  }
  if (hasAny) ++nCasts_;
}

template <int n>
Vector Sight::takenOf() const {
  Vector sum = 0.0;
  RangeOfEach ranges[n];
  const bool counts = measure_.counts();
  for (int r = 0; r < grid_.size(); ++r) {
    const auto line = static_cast<std::size_t>(r);
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
      if (k < nCasts_) {
        const Vector &low = low_[k][line], &high = high_[k][line];
        ranges[k] = {counts ? kernels::ceiling(low) : low, counts ? kernels::ceiling(high) : high};
      } else {
        const int at = static_cast<int>(k - nCasts_);
        const bool isThere = at < taken_->number(r);
        ranges[k] = {isThere ? taken_->of(r)[at].low : 0.0, isThere ? taken_->of(r)[at].high : 0.0};
      }
    sum += lengthOfUnion<n>(ranges);
  }
  return sum;
}

double Sight::takenBySorting(int nPlaces) const {
  static thread_local std::vector<Range> ranges;
  const bool counts = measure_.counts();
  double sum = 0.0;
  for (int r = 0; r < grid_.size(); ++r)
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(nPlaces); ++lane) {
      ranges.clear();
      if (taken_->most > 0) ranges.assign(taken_->of(r), taken_->of(r) + taken_->number(r));
      for (std::size_t k = 0; k < nCasts_; ++k) {
        const double low = low_[k][static_cast<std::size_t>(r)][lane],
                     high = high_[k][static_cast<std::size_t>(r)][lane];
        const Range range{counts ? std::ceil(low) : low, counts ? std::ceil(high) : high};
        if (range.low < range.high) ranges.push_back(range);
      }
      sum += joined(ranges);
    }
  return sum;
}

}  // namespace pd::decomposition
