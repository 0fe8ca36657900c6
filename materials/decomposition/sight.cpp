#include "sight.hpp"

#include <algorithm>

namespace pd::decomposition {

namespace stdx = kernels::stdx;
using kernels::allLanes;
using kernels::choose;
using kernels::greaterBits;
using kernels::Vector;

namespace {

constexpr double beyondAll = 1e300;
constexpr int mostAtOnce = 4;  ///< ranges of a line whose union is found by inclusion and exclusion

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

/// Over all lines, of n ranges each, the last of them those that are taken.
template <int n>
Vector sumOfUnions(int nLines, const std::vector<std::vector<Vector>>& low,
                   const std::vector<std::vector<Vector>>& high, std::size_t nCasts, const Taken& taken) {
  Vector sum = 0.0;
  RangeOfEach ranges[n];
  for (int r = 0; r < nLines; ++r) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(n); ++k)
      if (k < nCasts) {
        ranges[k] = {low[k][static_cast<std::size_t>(r)], high[k][static_cast<std::size_t>(r)]};
      } else {
        const int at = static_cast<int>(k - nCasts);
        const bool isThere = at < taken.number(r);
        ranges[k] = {isThere ? taken.of(r)[at].low : 0.0, isThere ? taken.of(r)[at].high : 0.0};
      }
    sum += lengthOfUnion<n>(ranges);
  }
  return sum;
}

double sumOfFirst(const Vector& values, int n) {
  double sum = 0.0;
  for (int lane = 0; lane < n; ++lane) sum += values[static_cast<std::size_t>(lane)];
  return sum;
}

Vector alongOf(const HalfSpace& half, const Place& direction) {
  return half.normal[0] * direction[0] + half.normal[1] * direction[1] + half.normal[2] * direction[2];
}

}  // namespace

Sight::Sight(const Cell& cell, std::size_t axis, int n, const LineMeasure& measure, const Taken& taken,
             const std::vector<const Screen*>& screens)
    : cell_(cell),
      grid_(cell, axis, n),
      measure_(measure),
      taken_(taken),
      screens_(screens),
      counted_(measure.whole() * grid_.size() - taken.sum),
      low_(screens.size()),
      high_(screens.size()) {}

double Sight::seen(const Places& places, int nPlaces) {
  nCasts_ = 0;
  for (const Screen* screen : screens_) {
    shadow_.clear();
    if (screen->addShadow(places, cell_.center, shadow_)) {
      const Cover cover = coverOf(shadow_);
      if (cover == Cover::All) return 0.0;
      if (cover == Cover::Something) castShadow();
    } else {
      castHidden(*screen, places);
    }
  }
  if (nCasts_ == 0) return nPlaces * counted_;
  const int n = grid_.size();
  const double all = nPlaces * measure_.whole() * n;
  switch (static_cast<int>(nCasts_) + taken_.most) {
    case 1:
      return all - sumOfFirst(sumOfUnions<1>(n, low_, high_, nCasts_, taken_), nPlaces);
    case 2:
      return all - sumOfFirst(sumOfUnions<2>(n, low_, high_, nCasts_, taken_), nPlaces);
    case 3:
      return all - sumOfFirst(sumOfUnions<3>(n, low_, high_, nCasts_, taken_), nPlaces);
    case mostAtOnce:
      return all - sumOfFirst(sumOfUnions<mostAtOnce>(n, low_, high_, nCasts_, taken_), nPlaces);
    default:
      return all - takenBySorting(nPlaces);
  }
}

/// Of what the half-spaces have in common.
Sight::Cover Sight::coverOf(const std::vector<HalfSpace>& shadow) const {
  bool isAll = true;
  for (const HalfSpace& half : shadow) {
    Vector reach = 0.0;
    for (const Place& edge : cell_.edges) reach += 0.5 * stdx::abs(alongOf(half, edge));
    if (greaterBits(-reach, half.offset) == allLanes) return Cover::Nothing;
    isAll = isAll && greaterBits(reach, half.offset) == 0;
  }
  return isAll ? Cover::All : Cover::Something;
}

/// Of the half-spaces in shadow_: bounds of the part of each line that is in all of them.
void Sight::castShadow() {
  const auto nLines = static_cast<std::size_t>(grid_.size());
  auto &low = low_[nCasts_], &high = high_[nCasts_];
  ++nCasts_;
  const double whole = measure_.whole(), shift = measure_.counts() ? 0.5 : 0.0;
  low.assign(nLines, Vector(0.0));
  high.assign(nLines, Vector(whole));
  for (const HalfSpace& half : shadow_) {
    const Vector slope = alongOf(half, grid_.step), size = stdx::abs(half.normal[0] * grid_.step[0]) +
                                                           stdx::abs(half.normal[1] * grid_.step[1]) +
                                                           stdx::abs(half.normal[2] * grid_.step[2]);
    // Of a line along the plane all or nothing.
    const Vector least = 1e-15 * size + 1e-300;
    const Vector perSlope = whole / choose(slope, least, greaterBits(stdx::abs(slope), least));
    const unsigned char isUpper = greaterBits(perSlope, Vector(0.0));
    const Vector change = -alongOf(half, grid_.strides[0]) * perSlope,
                 otherChange = -alongOf(half, grid_.strides[1]) * perSlope;
    Vector bound = (half.offset - alongOf(half, minus(grid_.first, cell_.center))) * perSlope - shift;
    const auto narrow = [&](auto& bounds, const Vector& none, unsigned char bits, auto narrower) {
      if (bits == 0) return;
      Vector start = choose(bound, none, bits);
      const Vector step = choose(change, 0.0, bits), otherStep = choose(otherChange, 0.0, bits);
      for (int l = 0; l < grid_.nOther; ++l, start += otherStep) {
        Vector at = start;
        for (auto r = static_cast<std::size_t>(l); r < nLines; r += static_cast<std::size_t>(grid_.nOther)) {
          bounds[r] = narrower(bounds[r], at);
          at += step;
        }
      }
    };
    narrow(low, -beyondAll, static_cast<unsigned char>(~isUpper & allLanes),
           [](const Vector& a, const Vector& b) { return stdx::max(a, b); });
    narrow(high, beyondAll, isUpper, [](const Vector& a, const Vector& b) { return stdx::min(a, b); });
  }
  if (!measure_.counts()) return;
  for (Vector& bound : low) bound = kernels::ceiling(bound);
  for (Vector& bound : high) bound = kernels::ceiling(bound);
}

void Sight::castHidden(const Screen& screen, const Places& places) {
  if (lines_.size() == 0) lines_ = linesOf(grid_);
  const std::size_t nLines = lines_.size();
  auto &low = low_[nCasts_], &high = high_[nCasts_];
  low.resize(nLines);
  high.resize(nLines);
  static thread_local std::vector<double> from, to;
  from.resize(nLines);
  to.resize(nLines);
  bool hasAny = false;
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(kernels::lanes); ++lane) {
    screen.hide({places[0][lane], places[1][lane], places[2][lane]}, lines_, from.data(), to.data());
    for (std::size_t r = 0; r < nLines; ++r) {
      const bool isHidden = from[r] < to[r];
      hasAny = hasAny || isHidden;
      low[r][lane] = isHidden ? measure_.upTo(from[r]) : 0.0;
      high[r][lane] = isHidden ? measure_.upTo(to[r]) : 0.0;
    }
  }
  if (hasAny) ++nCasts_;
}

double Sight::takenBySorting(int nPlaces) {
  static thread_local std::vector<Range> ranges;
  double sum = 0.0;
  for (int r = 0; r < grid_.size(); ++r)
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(nPlaces); ++lane) {
      ranges.clear();
      if (taken_.most > 0) ranges.assign(taken_.of(r), taken_.of(r) + taken_.number(r));
      for (std::size_t k = 0; k < nCasts_; ++k) {
        const Range range{low_[k][static_cast<std::size_t>(r)][lane], high_[k][static_cast<std::size_t>(r)][lane]};
        if (range.low < range.high) ranges.push_back(range);
      }
      sum += joined(ranges);
    }
  return sum;
}

}  // namespace pd::decomposition
