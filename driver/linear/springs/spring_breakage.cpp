// What broken bonds change in a network of springs: what is left of its springs, the corrections of runs and strips,
// and whether bonds have broken from both ends.
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "spring_network.hpp"

namespace pd {

namespace {

// Fewer broken bonds side by side are a list's.
constexpr int shortestStretch = 4;

}  // namespace

void SpringNetwork::setDamage(const std::vector<int>& changed, const std::function<const double*(int)>& damageOf) {
  std::vector<std::pair<int, int>> broken;
  for (const int i : changed) {
    const double* damage = damageOf(i);
    const int n = nNeighbors(i);
    std::vector<float>& own = aliveOfPoint_[static_cast<std::size_t>(i)];
    for (int k = 0; k < n; ++k)
      if (damage != nullptr && damage[k] >= 1.0 && alive(i, k) > 0.0F) broken.emplace_back(i, neighbors(i)[k]);
    own.clear();
    if (damage == nullptr || std::all_of(damage, damage + n, [](double d) { return d == 0.0; })) continue;
    for (int k = 0; k < n; ++k) own.push_back(static_cast<float>(1.0 - damage[k]));
  }
  for (const int i : changed) {
    setAlive(pairs_, pairRow_[static_cast<std::size_t>(i)], i);
    setAlive(singles_, singleRow_[static_cast<std::size_t>(i)], i);
  }
  makeCorrections();
  brokenFromOneEnd_ = findBrokenFromOneEnd(changed);
  hasKeptTogether_ =
      std::all_of(broken.begin(), broken.end(), [&](const auto& bond) { return areJoined(bond.first, bond.second); });
}

std::pair<int, int> SpringNetwork::findBrokenFromOneEnd(const std::vector<int>& changed) const {
  for (const int i : changed) {
    if (!isDamaged(i)) continue;
    for (int k = 0; k < nNeighbors(i); ++k) {
      const int j = neighbors(i)[k];
      if (j >= points_.nOwned || alive(i, k) > 0.0F) continue;
      const int* end = neighbors(j) + nNeighbors(j);
      const int* back = std::lower_bound(neighbors(j), end, i);
      if (back != end && *back == i && alive(j, static_cast<int>(back - neighbors(j))) > 0.0F) return {i, j};
    }
  }
  return {-1, -1};
}

int SpringNetwork::nUnbroken(int point, int globalId) const {
  int n = 0;
  for (int k = 0; k < nNeighbors(point); ++k)
    if (globalIdOf(neighbors(point)[k]) == globalId && alive(point, k) > 0.0F) ++n;
  return n;
}

std::pair<int, int> SpringNetwork::brokenFromOtherSide(const Communicator& comm,
                                                       const std::vector<int>& changed) const {
  std::vector<double> broken;  // ids of the end that has broken it and of the other, bonds left between them
  for (const int i : changed) {
    if (!isDamaged(i)) continue;
    for (int k = 0; k < nNeighbors(i); ++k) {
      const int j = neighbors(i)[k];
      if (j < points_.nOwned || alive(i, k) > 0.0F) continue;
      for (const int value : {globalIdOf(i), globalIdOf(j), nUnbroken(i, globalIdOf(j))}) broken.push_back(value);
    }
  }
  broken = comm.gather(broken);
  if (broken.empty()) return {-1, -1};
  std::unordered_map<int, int> owned;
  for (int i = 0; i < points_.nOwned; ++i) owned.emplace(globalIdOf(i), i);
  for (std::size_t at = 0; at < broken.size(); at += 3) {
    const int i = static_cast<int>(broken[at]);
    const auto other = owned.find(static_cast<int>(broken[at + 1]));
    if (other == owned.end() || nUnbroken(other->second, i) <= static_cast<int>(broken[at + 2])) continue;
    const int j = other->second;
    const int* ghost = std::find_if(neighbors(j), neighbors(j) + nNeighbors(j),
                                    [&](int point) { return point >= points_.nOwned && globalIdOf(point) == i; });
    return {*ghost, j};
  }
  return {-1, -1};
}

/// Looks around i, as far as a bond across a crack has to go around its tip.
bool SpringNetwork::areJoined(int i, int j) {
  constexpr std::size_t mostVisited = 3000;
  if (j >= points_.nOwned) return false;
  visitedBy_.resize(aliveOfPoint_.size(), 0);
  ++nVisits_;
  std::vector<int> reached{i};
  visitedBy_[static_cast<std::size_t>(i)] = nVisits_;
  for (std::size_t next = 0; next < reached.size() && reached.size() < mostVisited; ++next)
    for (int k = 0; k < nNeighbors(reached[next]); ++k) {
      const int point = neighbors(reached[next])[k];
      if (point >= points_.nOwned || alive(reached[next], k) == 0.0F) continue;
      if (point == j) return true;
      int& visit = visitedBy_[static_cast<std::size_t>(point)];
      if (visit == nVisits_) continue;
      visit = nVisits_;
      reached.push_back(point);
    }
  return false;
}

void SpringNetwork::setAlive(SpringList& list, int row, int point) {
  if (row < 0) return;
  const auto r = static_cast<std::size_t>(row);
  int k = 0;
  for (std::size_t s = list.start[r]; s < list.start[r + 1]; ++s) {
    while (neighbors(point)[k] != list.other[s]) ++k;
    list.alive[s] = alive(point, k);
  }
}

void SpringNetwork::addCorrection(int i, int j, float left, const SpringConstants<double>& c) {
  if (left == 1.0F || !c.acts()) return;
  if (!isComplete(j))
    add(singleCorrections_, i, j, left - 1.0F, c);
  else if (j > i)
    add(corrections_, i, j, left - 1.0F, c);
}

float SpringNetwork::aliveTo(int point, int neighbor) const {
  const int* end = neighbors(point) + nNeighbors(point);
  return alive(point, static_cast<int>(std::lower_bound(neighbors(point), end, neighbor) - neighbors(point)));
}

/// A crack breaks the same bonds of one point and the next: what a loop can take away by vectors is kept so. Most bonds
/// of damaged points are whole: which are not is found once, and lies side by side for each neighbour.
void SpringNetwork::correctRun(const SpringRun& run, int first, int last) {
  const SpringPattern& pattern = patterns_[static_cast<std::size_t>(run.pattern)];
  const std::size_t n = static_cast<std::size_t>(last - first), nNeighbors = pattern.offsets.size();
  std::vector<char> isDamagedBond(n * nNeighbors);
  for (std::size_t p = 0; p < n; ++p) {
    const std::vector<float>& own = aliveOfPoint_[static_cast<std::size_t>(first) + p];
    for (std::size_t k = 0; k < nNeighbors; ++k) isDamagedBond[k * n + p] = own[k] != 1.0F ? 1 : 0;
  }
  for (std::size_t k = 0; k < nNeighbors; ++k) {
    if (!pattern.constants[k].acts()) continue;
    const int offset = pattern.offsets[k];
    const auto isBroken = [&](int i) {
      return offset > 0 && alive(i, static_cast<int>(k)) == 0.0F && isComplete(i + offset);
    };
    const auto bonds = isDamagedBond.begin() + static_cast<std::ptrdiff_t>(k * n), none = bonds + (last - first);
    for (auto bond = std::find(bonds, none, 1); bond != none; bond = std::find(bond, none, 1)) {
      const int i = first + static_cast<int>(bond - bonds);
      int end = i;
      while (end < last && isBroken(end)) ++end;
      if (end - i >= shortestStretch) {
        brokenStretches_.push_back({i, end - i, run.pattern, static_cast<int>(k)});
      } else {
        end = std::max(end, i + 1);
        for (int point = i; point < end; ++point)
          addCorrection(point, point + offset, alive(point, static_cast<int>(k)), pattern.constants[k]);
      }
      bond += end - i;
    }
  }
}

void SpringNetwork::makeCorrections() {
  corrections_ = singleCorrections_ = {};
  brokenStretches_.clear();
  for (const SpringRun& run : runs_)
    for (int i = run.first; i < run.first + run.count;) {
      int last = i;
      while (last < run.first + run.count && isDamaged(last)) ++last;
      if (last > i) correctRun(run, i, last);
      i = std::max(last, i + 1);
    }
  for (const SpringStrip& strip : strips_)
    forEachOf(
        strip, [&](int i) { return isDamaged(i); },
        [&](int i, int k, std::size_t at) {
          const int j = neighbors(i)[k];
          addCorrection(i, j, alive(i, k), constantsOf(strip.in<double>(), at, difference(i, j), j));
        });
}

std::vector<char> SpringNetwork::around(const std::vector<int>& points) const {
  std::vector<char> isAround(static_cast<std::size_t>(points_.nPoints), 0);
  int nMarked = 0;
  for (const int i : points) {
    nMarked += isAround[static_cast<std::size_t>(i)] == 0 ? 1 : 0;
    isAround[static_cast<std::size_t>(i)] = 1;
  }
  // Around all owned points there are others alone, at the ends of their lists.
  const int known = nMarked == points_.nOwned ? points_.nOwned : 0;
  for (const int i : points)
    for (int k = nNeighbors(i); k > 0 && neighbors(i)[k - 1] >= known; --k)
      isAround[static_cast<std::size_t>(neighbors(i)[k - 1])] = 1;
  return isAround;
}

}  // namespace pd
