#include "flow_surroundings.hpp"

#include <algorithm>
#include <cmath>

namespace pd {

long long FlowSurroundings::like(int point, std::size_t row) {
  if (!isInside(point)) return -1;
  std::size_t key = 0;
  for (const int neighbor : geometry_.neighborsOf(point)) {
    key = (key ^ static_cast<std::size_t>(static_cast<long long>(neighbor - point))) * 0x9E3779B97F4A7C15ULL;
    key ^= key >> 29U;
  }
  const auto [known, isNew] = rowByKey_.emplace(key, row);
  if (isNew) return -1;
  if (areEqual(point, geometry_.fluid()[known->second])) return static_cast<long long>(known->second);
  known->second = row;
  return -1;
}

/// Fits of the pressure at its neighbours count for the row, so that none of them may be near a boundary either.
bool FlowSurroundings::isInside(int point) const {
  if (geometry_.rings().areUsed() || geometry_.isNearBoundary(point)) return false;
  const std::vector<int> neighbors = geometry_.neighborsOf(point);
  return std::none_of(neighbors.begin(), neighbors.end(), [&](int neighbor) {
    return geometry_.isNearBoundary(neighbor) || geometry_.mesh().isImage(neighbor);
  });
}

bool FlowSurroundings::areEqual(int point, int other) const {
  constexpr double rounding = 1e-11;
  const Discretization& mesh = geometry_.mesh();
  const std::vector<int> ofPoint = geometry_.neighborsOf(point), ofOther = geometry_.neighborsOf(other);
  if (ofPoint.size() != ofOther.size()) return false;
  const auto volume = [&](int p) { return mesh.volume[static_cast<std::size_t>(p)]; };
  const auto isEqual = [&](int a, int b) {
    if (a - point != b - other || std::abs(volume(a) - volume(b)) > rounding * volume(b)) return false;
    const double *xa = &mesh.x[3 * static_cast<std::size_t>(a)], *xb = &mesh.x[3 * static_cast<std::size_t>(b)];
    const double* from = &mesh.x[3 * static_cast<std::size_t>(point)];
    const double* fromOther = &mesh.x[3 * static_cast<std::size_t>(other)];
    for (int k = 0; k < 3; ++k)
      if (std::abs((xa[k] - from[k]) - (xb[k] - fromOther[k])) > rounding * geometry_.law().family.horizon)
        return false;
    return true;
  };
  if (!isEqual(point, other) || !std::equal(ofPoint.begin(), ofPoint.end(), ofOther.begin(), isEqual)) return false;
  // Fits at neighbours are made of their own lists; of ghosts there are none.
  const std::vector<int> reached = compactOffsets(point);
  return reached == compactOffsets(other) && std::all_of(reached.begin(), reached.end(), [&](int offset) {
           const int one = point + offset, its = other + offset;
           const bool isOwned = one < mesh.nOwned;
           return isOwned == (its < mesh.nOwned) && (!isOwned || compactOffsets(one) == compactOffsets(its));
         });
}

/// Of the neighbours of an owned point that gradients reach.
std::vector<int> FlowSurroundings::compactOffsets(int point) const {
  std::vector<int> offsets;
  for (const int neighbor : geometry_.neighborsOf(point))
    if (geometry_.law().gradientsReach(ReferenceBond(geometry_.mesh().x.data(), point, neighbor).length))
      offsets.push_back(neighbor - point);
  return offsets;
}

}  // namespace pd
