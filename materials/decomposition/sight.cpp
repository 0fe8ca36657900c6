#include "sight.hpp"

#include <algorithm>
#include <cmath>

#include "convex_geometry.hpp"

namespace pd::decomposition {

namespace stdx = kernels::stdx;
using kernels::allLanes;
using kernels::choose;
using kernels::greaterBits;
using kernels::Vector;

namespace {

/// Length of the union of ranges, lane by lane.
Vector lengthOfMany(const std::vector<RangePerLane>& ranges) {
  static thread_local std::vector<Range> ofLane;
  Vector length = 0.0;
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(kernels::lanes); ++lane) {
    ofLane.clear();
    for (const RangePerLane& range : ranges)
      if (range.low[lane] < range.high[lane]) ofLane.push_back({range.low[lane], range.high[lane]});
    length[lane] = joined(ofLane);
  }
  return length;
}

/// The same of several ranges from 0 on, of which lanes have few each: as lengthOfUnion, to the last digit.
Vector lengthOfSeveral(const std::vector<RangePerLane>& ranges) {
  static thread_local std::array<std::vector<Range>, kernels::lanes> ofLanes;
  for (auto& ofLane : ofLanes) ofLane.clear();
  for (const RangePerLane& range : ranges)
    for (unsigned bits = greaterBits(range.high, range.low); bits != 0; bits &= bits - 1) {
      const auto lane = static_cast<std::size_t>(__builtin_ctz(bits));
      const Range latest{range.low[lane], range.high[lane]};
      auto& ofLane = ofLanes[lane];
      ofLane.push_back(latest);
      std::size_t k = ofLane.size() - 1;
      for (; k > 0 && ofLane[k - 1].low > latest.low; --k) ofLane[k] = ofLane[k - 1];
      ofLane[k] = latest;
    }
  Vector length = 0.0;
  for (std::size_t lane = 0; lane < ofLanes.size(); ++lane) {
    double sum = 0.0, end = 0.0;
    for (const Range& range : ofLanes[lane]) {
      sum += std::max(range.high - std::max(range.low, end), 0.0);
      end = std::max(end, range.high);
    }
    length[lane] = sum;
  }
  return length;
}

/// The same of ranges from 0 on, which it puts in order.
PD_EACH_BOND Vector lengthOfUnion(std::vector<RangePerLane>& ranges) {
  constexpr std::size_t several = 6, many = 32;  // exchanges of neighbours go as the square
  if (ranges.size() > many) return lengthOfMany(ranges);
  if (ranges.size() > several) return lengthOfSeveral(ranges);
  sortEach(ranges);
  Vector length = 0.0, end = 0.0;
  for (const RangePerLane& range : ranges) {
    length += stdx::max(range.high - stdx::max(range.low, end), Vector(0.0));
    end = stdx::max(end, range.high);
  }
  return length;
}

Vector alongOf(const HalfSpace& half, const Place& direction) {
  return half.normal[0] * direction[0] + half.normal[1] * direction[1] + half.normal[2] * direction[2];
}

/// 0, 1, ...
const std::array<double, mostMiddles>& numbers() {
  static const std::array<double, mostMiddles> values = [] {
    std::array<double, mostMiddles> result;
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
  const auto nLines = static_cast<std::size_t>(grid_.size());
  low_.resize(nLines);
  high_.resize(nLines);
  if (!measure_.counts()) {
    if (hidden_.size() < nLines) hidden_.resize(nLines);
    return;
  }
  takenMiddles_.assign(nLines, {});
  for (int r = 0; r < grid_.size(); ++r)
    for (int k = 0; k < taken.number(r); ++k)
      addMiddles(taken.of(r)[k].low, taken.of(r)[k].high, takenMiddles_[static_cast<std::size_t>(r)]);
}

double Sight::seen(const Places& places, int nPlaces) {
  isHidden_ = false;
  for (const Screen* screen : *screens_) {
    shadow_.clear();
    if (screen->addShadow(places, cell_->center, shadow_)) {
      const Cover cover = coverOfShadow();
      if (cover == Cover::All) return 0.0;
      if (cover == Cover::Nothing) continue;
      castShadow();
    } else if (!castHidden(*screen, places)) {
      continue;
    }
    keepHidden();
  }
  if (!isHidden_) return nPlaces * counted();
  const Vector unseen = measure_.counts() ? unseenMiddles() : unseenLength();
  double sum = 0.0;
  for (int lane = 0; lane < nPlaces; ++lane) sum += unseen[static_cast<std::size_t>(lane)];
  return nPlaces * measure_.whole() * grid_.size() - sum;
}

/// Of what the half-spaces have in common; leaves those out that have all of the cell in them.
Sight::Cover Sight::coverOfShadow() {
  constexpr double surely = 1.0 + 1e-9;  // beyond rounding
  bool isAll = true;
  std::size_t n = 0;
  for (const HalfSpace& half : shadow_) {
    Vector reach = 0.0;
    for (const Place& edge : cell_->edges) reach += 0.5 * stdx::abs(alongOf(half, edge));
    if (greaterBits(-reach, half.offset) == allLanes) return Cover::Nothing;
    isAll = isAll && greaterBits(reach, half.offset) == 0;
    if (greaterBits(half.offset, surely * reach) != allLanes) shadow_[n++] = half;
  }
  if (isAll) return Cover::All;
  shadow_.resize(n);
  return Cover::Something;
}

/// Of the half-spaces in shadow_: bounds of the part of each line that is in all of them.
void Sight::castShadow() {
  const auto nLines = static_cast<std::size_t>(grid_.size());
  Vector *low = low_.data(), *high = high_.data();
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

bool Sight::castHidden(const Screen& screen, const Places& places) {
  if (lines_.size() == 0) lines_ = linesOf(grid_);
  const std::size_t nLines = lines_.size();
  if (!screen.hideFromEach(places, lines_, low_.data(), high_.data())) {
    static thread_local std::vector<double> from, to;
    from.resize(nLines);
    to.resize(nLines);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(kernels::lanes); ++lane) {
      screen.hide({places[0][lane], places[1][lane], places[2][lane]}, lines_, from.data(), to.data());
      for (std::size_t r = 0; r < nLines; ++r) {
        low_[r][lane] = from[r];
        high_[r][lane] = to[r];
      }
    }
  }
  const double whole = measure_.whole(), shift = measure_.counts() ? 0.5 : 0.0;
  bool hasAny = false;
  for (std::size_t r = 0; r < nLines; ++r) {
    hasAny = hasAny || greaterBits(high_[r], low_[r]) != 0;
    low_[r] = whole * low_[r] - shift;
    high_[r] = whole * high_[r] - shift;
  }
  return hasAny;
}

void Sight::keepHidden() {
  const auto nLines = static_cast<std::size_t>(grid_.size());
  if (measure_.counts()) {
    if (!isHidden_) hiddenMiddles_ = takenMiddles_;
    for (std::size_t r = 0; r < nLines; ++r)
      addMiddles(kernels::ceiling(low_[r]), kernels::ceiling(high_[r]), hiddenMiddles_[r]);
  } else {
    for (std::size_t r = 0; r < nLines; ++r) {
      if (!isHidden_) hidden_[r].clear();
      if (greaterBits(high_[r], low_[r]) != 0) hidden_[r].push_back({low_[r], high_[r]});
    }
  }
  isHidden_ = true;
}

Vector Sight::unseenMiddles() const {
  Vector sum = 0.0;
  for (const MiddlesPerLane& set : hiddenMiddles_) sum += numberOf(set);
  return sum;
}

Vector Sight::unseenLength() {
  Vector sum = 0.0;
  for (int r = 0; r < grid_.size(); ++r) {
    std::vector<RangePerLane>& ranges = hidden_[static_cast<std::size_t>(r)];
    for (int k = 0; k < taken_->number(r); ++k) ranges.push_back({taken_->of(r)[k].low, taken_->of(r)[k].high});
    sum += lengthOfUnion(ranges);
  }
  return sum;
}

}  // namespace pd::decomposition
