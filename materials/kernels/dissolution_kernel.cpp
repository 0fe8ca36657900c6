#include "dissolution_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace pd::kernels {

PhaseBonds::PhaseBonds(const ChunkedNeighborhood& neighborhood, int nOwned, const int* ownedIds,
                       const int* neighborhoodList, int nPoints)
    : list_(neighborhoodList) {
  const auto n = static_cast<std::size_t>(nPoints);
  isLiquid_.assign(n, 0);
  steppedDamage_.assign(n, 0.0);
  chunkOf_.assign(n, -1);
  ownedPosition_.assign(n, -1);
  chunksAround_.resize(n);
  std::size_t at = 0;
  for (int p = 0; p < nOwned; ++p) {
    ownedPosition_[static_cast<std::size_t>(ownedIds[p])] = p;
    starts_.push_back(at);
    at += static_cast<std::size_t>(neighborhoodList[at]) + 1;
  }
  const auto& chunks = neighborhood.chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c)
    for (int lane = 0; lane < chunks[c].nLanes; ++lane)
      chunkOf_[static_cast<std::size_t>(neighborhood.pointIds(chunks[c])[lane])] = static_cast<int>(c);
  for (int p = 0; p < nOwned; ++p) {
    const int* neighbors = list_ + starts_[static_cast<std::size_t>(p)] + 1;
    const int chunk = chunkOf_[static_cast<std::size_t>(ownedIds[p])];
    for (int k = 0; k < neighbors[-1]; ++k) {
      auto& around = chunksAround_[static_cast<std::size_t>(neighbors[k])];
      if (ownedPosition_[static_cast<std::size_t>(neighbors[k])] < 0 && (around.empty() || around.back() != chunk))
        around.push_back(chunk);
    }
  }
  kinds_.resize(chunks.size());
  liquid_ = fromSolid_ = fromLiquid_ = AliveBonds(neighborhood);
  for (const Chunk& chunk : chunks)
    for (AliveBonds* bonds : {&liquid_, &fromSolid_, &fromLiquid_})
      std::fill(bonds->of(chunk), bonds->of(chunk) + chunk.nNeighbors, static_cast<unsigned char>(0));
}

void PhaseBonds::excludeWalls(const double* saturation) {
  isWall_.clear();
  const std::size_t n = isLiquid_.size();
  if (std::find(saturation, saturation + n, 0.0) == saturation + n) return;
  for (std::size_t i = 0; i < n; ++i) isWall_.push_back(saturation[i] == 0.0 ? 1 : 0);
}

void PhaseBonds::findNeighborsWithoutWalls(int ownedPoint, std::vector<int>& neighbors) const {
  const int* list = listOf(ownedPoint);
  neighbors.clear();
  std::copy_if(list + 1, list + 1 + *list, std::back_inserter(neighbors),
               [this](int j) { return isWall_.empty() || isWall_[static_cast<std::size_t>(j)] == 0; });
}

void PhaseBonds::markChunksOf(int point, std::vector<char>& isMarked) const {
  const auto i = static_cast<std::size_t>(point);
  if (ownedPosition_[i] < 0) {
    for (const int chunk : chunksAround_[i]) isMarked[static_cast<std::size_t>(chunk)] = 1;
    return;
  }
  // Neighbourhoods are symmetric.
  isMarked[static_cast<std::size_t>(chunkOf_[i])] = 1;
  const int* neighbors = list_ + starts_[static_cast<std::size_t>(ownedPosition_[i])] + 1;
  for (int k = 0; k < neighbors[-1]; ++k) {
    const int chunk = chunkOf_[static_cast<std::size_t>(neighbors[k])];
    if (chunk >= 0) isMarked[static_cast<std::size_t>(chunk)] = 1;
  }
}

bool PhaseBonds::refresh(const ChunkedNeighborhood& neighborhood, const double* damage) {
  constexpr double steps = 256.0;
  std::vector<char> isMarked;
  changedPoints_.clear();
  for (std::size_t i = 0; i < isLiquid_.size(); ++i) {
    if (damage[i] == steppedDamage_[i] || (!isWall_.empty() && isWall_[i] != 0)) continue;
    const double stepped = std::floor(steps * damage[i]) / steps;
    if (stepped == steppedDamage_[i]) continue;
    steppedDamage_[i] = stepped;
    changedPoints_.push_back(static_cast<int>(i));
    const char isLiquid = stepped >= 1.0 ? 1 : 0;
    if (isLiquid == isLiquid_[i]) continue;
    isMarked.resize(neighborhood.chunks().size(), 0);
    isLiquid_[i] = isLiquid;
    markChunksOf(static_cast<int>(i), isMarked);
  }
  if (isMarked.empty()) return false;
  changedChunks_.clear();
  for (std::size_t c = 0; c < isMarked.size(); ++c)
    if (isMarked[c] != 0) changedChunks_.push_back(c);
  for (const std::size_t c : changedChunks_) refreshChunk(neighborhood, c);
  collect(neighborhood);
  return true;
}

std::vector<std::size_t> PhaseBonds::solidChunksAround(const std::vector<int>& points) const {
  std::vector<char> isMarked(kinds_.size(), 0);
  for (const int i : points) markChunksOf(i, isMarked);
  std::vector<std::size_t> result;
  for (const std::size_t c : solidChunks_)
    if (isMarked[c] != 0) result.push_back(c);
  return result;
}

void PhaseBonds::refreshChunk(const ChunkedNeighborhood& neighborhood, std::size_t c) {
  const Chunk& chunk = neighborhood.chunks()[c];
  const int* points = neighborhood.pointIds(chunk);
  const unsigned char* present = neighborhood.present(chunk);
  unsigned char own = 0;
  for (int lane = 0; lane < chunk.nLanes; ++lane)
    if (isLiquid_[static_cast<std::size_t>(points[lane])] != 0) own = static_cast<unsigned char>(own | (1u << lane));
  Kinds kinds;
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    unsigned char other = 0, wall = 0;
    for (int lane = 0; lane < chunk.nLanes; ++lane) {
      if (((present[k] >> lane) & 1u) == 0) continue;
      const auto neighbor = static_cast<std::size_t>(neighborhood.neighbor(chunk, k, lane));
      if (isLiquid_[neighbor] != 0) other = static_cast<unsigned char>(other | (1u << lane));
      if (!isWall_.empty() && isWall_[neighbor] != 0) wall = static_cast<unsigned char>(wall | (1u << lane));
    }
    liquid_.of(chunk)[k] = own & other;
    fromSolid_.of(chunk)[k] = static_cast<unsigned char>(~own & other);
    fromLiquid_.of(chunk)[k] = static_cast<unsigned char>(own & ~other & ~wall & present[k]);
    kinds.liquid = kinds.liquid || liquid_.of(chunk)[k] != 0;
    kinds.fromSolid = kinds.fromSolid || fromSolid_.of(chunk)[k] != 0;
    kinds.fromLiquid = kinds.fromLiquid || fromLiquid_.of(chunk)[k] != 0;
  }
  kinds_[c] = kinds;
}

void PhaseBonds::collect(const ChunkedNeighborhood& neighborhood) {
  liquidChunks_.clear();
  solidChunks_.clear();
  wetChunks_.clear();
  activeChunks_.clear();
  for (std::size_t c = 0; c < kinds_.size(); ++c) {
    if (kinds_[c].liquid) liquidChunks_.push_back(c);
    if (kinds_[c].fromSolid) solidChunks_.push_back(c);
    if (kinds_[c].fromLiquid) wetChunks_.push_back(c);
    if (kinds_[c].liquid || kinds_[c].fromSolid || kinds_[c].fromLiquid) activeChunks_.push_back(c);
  }
  liquidRanges_.clear();
  const auto n = static_cast<int>(isLiquid_.size());
  for (int i = 0; i < n; ++i) {
    if (!isLiquid(i)) continue;
    const int first = i;
    while (i < n && isLiquid(i)) ++i;
    liquidRanges_.emplace_back(first, i);
  }
  sources_ = ends(neighborhood, fromLiquid_, wetChunks_, fromSolid_, solidChunks_);
  sinks_ = ends(neighborhood, fromSolid_, solidChunks_, fromLiquid_, wetChunks_);
}

std::vector<int> PhaseBonds::ends(const ChunkedNeighborhood& neighborhood, const AliveBonds& fromOwn,
                                  const std::vector<std::size_t>& ownChunks, const AliveBonds& fromOther,
                                  const std::vector<std::size_t>& otherChunks) const {
  const auto& chunks = neighborhood.chunks();
  std::vector<char> isEnd(isLiquid_.size(), 0);
  for (const std::size_t c : otherChunks) {
    const unsigned char* bits = fromOther.of(chunks[c]);
    for (int k = 0; k < chunks[c].nNeighbors; ++k)
      for (int lane = 0; lane < chunks[c].nLanes && bits[k] != 0; ++lane)
        if (((bits[k] >> lane) & 1u) != 0)
          isEnd[static_cast<std::size_t>(neighborhood.neighbor(chunks[c], k, lane))] = 1;
  }
  for (const std::size_t c : ownChunks) {
    unsigned char any = 0;
    for (int k = 0; k < chunks[c].nNeighbors; ++k) any = static_cast<unsigned char>(any | fromOwn.of(chunks[c])[k]);
    for (int lane = 0; lane < chunks[c].nLanes; ++lane)
      if (((any >> lane) & 1u) != 0) isEnd[static_cast<std::size_t>(neighborhood.pointIds(chunks[c])[lane])] = 1;
  }
  std::vector<int> result;
  for (std::size_t i = 0; i < isEnd.size(); ++i)
    if (isEnd[i] != 0) result.push_back(static_cast<int>(i));
  return result;
}

void addWeightedSum(const ChunkedNeighborhood& neighborhood, const BondConstants& weights, const AliveBonds& bonds,
                    const std::vector<std::size_t>& only, const double* scale, const double* values, double* sum) {
  for (const std::size_t c : only) {
    const Chunk& chunk = neighborhood.chunks()[c];
    const unsigned char* bits = bonds.of(chunk);
    const double* w = weights.of(c);
    const bool isUniform = weights.isUniform(c);
    Vector total = 0.0;
    for (int k = 0; k < chunk.nNeighbors; ++k) {
      if (bits[k] == 0) continue;
      const Vector value = values == nullptr    ? Vector(1.0)
                           : chunk.isContiguous ? load(values + chunk.firstPoint + neighborhood.offsets(chunk)[k])
                                                : gather(values, neighborhood.neighborIds(chunk) + k * lanes);
      const Vector weight = isUniform ? Vector(w[k]) : load(w + k * lanes);
      total += keep(weight * value, bits[k]);
    }
    if (scale != nullptr) total *= gather(scale, neighborhood.pointIds(chunk));
    addToPoints(neighborhood, chunk, total, sum);
  }
}

}  // namespace pd::kernels
