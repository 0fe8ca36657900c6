// Compiled without contraction of a * b + c, so that a distance does not depend on where a compiler fuses.
#include "neighbor_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pd {

NeighborRule NeighborRule::make(const std::vector<double>& horizon, const std::vector<double>& spacing) {
  constexpr double tolerance = 1e-10;
  const bool reachesBeyond = !spacing.empty();
  const double factor = reachesBeyond ? 1.0 - tolerance : 1.0 + tolerance;
  NeighborRule rule;
  rule.margin.assign(horizon.size(), 0.0);
  for (const double value : horizon) rule.reach.push_back(value * factor);
  for (std::size_t i = 0; i < spacing.size(); ++i) rule.margin[i] = 0.25 * spacing[i] * factor;
  return rule;
}

NeighborRule NeighborRule::exact(const std::vector<double>& horizon, bool includesLimit) {
  NeighborRule rule;
  rule.reach = horizon;
  rule.margin.assign(horizon.size(), 0.0);
  rule.includesLimit = includesLimit;
  return rule;
}

double NeighborRule::widest() const {
  if (reach.empty()) return 0.0;
  return *std::max_element(reach.begin(), reach.end()) + 2.0 * *std::max_element(margin.begin(), margin.end());
}

void NeighborSearch::chooseCells(const std::vector<double>& x, const NeighborRule& rule,
                                 const std::vector<int>& candidates) {
  std::array<double, 3> high{};
  double sumOfReaches = 0.0;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    const auto i = static_cast<std::size_t>(candidates[c]);
    sumOfReaches += rule.reach[i] + 2.0 * rule.margin[i];
    widestMargin_ = std::max(widestMargin_, rule.margin[i]);
    for (std::size_t k = 0; k < 3; ++k) {
      low_[k] = c == 0 ? x[3 * i + k] : std::min(low_[k], x[3 * i + k]);
      high[k] = c == 0 ? x[3 * i + k] : std::max(high[k], x[3 * i + k]);
    }
  }
  const auto n = static_cast<double>(candidates.size());
  const double extent = std::max({high[0] - low_[0], high[1] - low_[1], high[2] - low_[2]});
  double cellSize = n > 0.0 ? std::max(0.5 * sumOfReaches / n, 1e-9 * extent) : 1.0;
  const auto cellsAlong = [&](std::size_t k) { return std::floor((high[k] - low_[k]) / cellSize) + 1.0; };
  // A sparse cloud (fragments far apart) would have more cells than points.
  while (cellsAlong(0) * cellsAlong(1) * cellsAlong(2) > 2.0 * n + 100.0) cellSize *= 1.25;
  for (std::size_t k = 0; k < 3; ++k) nCells_[k] = static_cast<int>(cellsAlong(k));
  inverseCellSize_ = 1.0 / cellSize;
}

NeighborSearch::Cell NeighborSearch::cellOf(double x, double y, double z) const {
  const std::array<double, 3> point{x, y, z};
  Cell cell{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double at = (point[k] - low_[k]) * inverseCellSize_;
    cell[k] = static_cast<int>(std::clamp(at, 0.0, nCells_[k] - 1.0));
  }
  return cell;
}

std::size_t NeighborSearch::indexOf(const Cell& cell) const {
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(nCells_[1]) +
          static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(nCells_[0]) +
         static_cast<std::size_t>(cell[0]);
}

NeighborSearch::NeighborSearch(const std::vector<double>& x, const NeighborRule& rule,
                               const std::vector<int>& candidates)
    : isBox_(rule.isBox), includesLimit_(rule.includesLimit) {
  chooseCells(x, rule, candidates);
  const std::size_t n = candidates.size();
  std::vector<std::size_t> cell(n);
  cellStart_.assign(indexOf({nCells_[0] - 1, nCells_[1] - 1, nCells_[2] - 1}) + 2, 0);
  for (std::size_t c = 0; c < n; ++c) {
    const double* point = &x[3 * static_cast<std::size_t>(candidates[c])];
    cell[c] = indexOf(cellOf(point[0], point[1], point[2]));
    ++cellStart_[cell[c] + 1];
  }
  for (std::size_t k = 1; k < cellStart_.size(); ++k) cellStart_[k] += cellStart_[k - 1];

  std::vector<int> next(cellStart_.begin(), cellStart_.end() - 1);
  for (auto* array : {&x_, &y_, &z_, &reach_, &margin_}) array->resize(n);
  position_.resize(n);
  slot_.resize(n);
  for (std::size_t c = 0; c < n; ++c) {
    const auto i = static_cast<std::size_t>(candidates[c]);
    const auto slot = static_cast<std::size_t>(next[cell[c]]++);
    x_[slot] = x[3 * i];
    y_[slot] = x[3 * i + 1];
    z_[slot] = x[3 * i + 2];
    reach_[slot] = rule.reach[i];
    margin_[slot] = rule.margin[i];
    position_[slot] = static_cast<int>(c);
    slot_[c] = static_cast<int>(slot);
  }
}

double NeighborSearch::find(int position, std::vector<int>& neighbors) const {
  const int self = slot_[position];
  const auto s = static_cast<std::size_t>(self);
  const double x = x_[s], y = y_[s], z = z_[s], reach = reach_[s], margin = margin_[s];
  const double radius = (reach + (margin + widestMargin_)) * (1.0 + 1e-9);  // rounding of x - radius loses no point
  const Cell from = cellOf(x - radius, y - radius, z - radius), to = cellOf(x + radius, y + radius, z + radius);
  double shortest = std::numeric_limits<double>::infinity();
  std::size_t n = 0;
  for (int cz = from[2]; cz <= to[2]; ++cz)
    for (int cy = from[1]; cy <= to[1]; ++cy) {
      // The cells of a row along x follow each other.
      const int begin = cellStart_[indexOf({from[0], cy, cz})], end = cellStart_[indexOf({to[0], cy, cz}) + 1];
      const std::size_t room = n + static_cast<std::size_t>(end - begin);
      if (neighbors.size() < room) neighbors.resize(2 * room);
      int* out = neighbors.data();
      for (int slot = begin; slot < end; ++slot) {
        const auto k = static_cast<std::size_t>(slot);
        const double dx = x_[k] - x, dy = y_[k] - y, dz = z_[k] - z;
        const double largest = std::max({std::abs(dx), std::abs(dy), std::abs(dz)});
        const double distanceSquared = isBox_ ? largest * largest : dx * dx + dy * dy + dz * dz;
        const double limit = reach + (margin + margin_[k]), limitSquared = limit * limit;
        const bool isWithin = includesLimit_ ? distanceSquared <= limitSquared : distanceSquared < limitSquared;
        const bool isNeighbor = isWithin && slot != self;
        out[n] = position_[k];
        n += isNeighbor ? 1 : 0;
        shortest = isNeighbor && distanceSquared < shortest ? distanceSquared : shortest;
      }
    }
  neighbors.resize(n);
  return shortest;
}

}  // namespace pd
