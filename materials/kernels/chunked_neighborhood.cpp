#include "chunked_neighborhood.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace pd::kernels {

namespace {

constexpr int samplesOfList = 64;
constexpr int shortestRun = 2;  ///< points; a contiguous chunk with idle lanes still beats gathering

std::vector<int> sampleOf(const int* list, std::size_t size) {
  std::vector<int> sample;
  if (size == 0) return sample;
  for (std::size_t s = 0; s < samplesOfList; ++s) sample.push_back(list[s * (size - 1) / (samplesOfList - 1)]);
  return sample;
}

bool haveSameOffsets(const int* list, std::size_t a, std::size_t b, int pointA, int pointB) {
  if (pointB != pointA + 1 || list[a] != list[b]) return false;
  for (int k = 1; k <= list[a]; ++k)
    if (list[b + static_cast<std::size_t>(k)] != list[a + static_cast<std::size_t>(k)] + 1) return false;
  return true;
}

/// Replaces values that differ by round-off alone by one of them, so that the constants of a bond are the same from
/// both of its ends (to the sign) although coordinate differences are not.
class CanonicalValues {
 public:
  explicit CanonicalValues(double tolerance) : tolerance_(tolerance) {}
  double operator()(double value) {
    const double magnitude = std::abs(value);
    const auto next = values_.lower_bound(magnitude * (1.0 - tolerance_));
    if (next != values_.end() && *next <= magnitude * (1.0 + tolerance_)) return std::copysign(*next, value);
    values_.insert(magnitude);
    return value;
  }

 private:
  double tolerance_;
  std::set<double> values_;
};

}  // namespace

ChunkedNeighborhood::ChunkedNeighborhood(int nOwned, const int* ownedIds, const int* neighborhoodList)
    : nOwned_(nOwned), ownedIds_(ownedIds), list_(neighborhoodList) {
  std::vector<std::size_t> starts;
  starts.reserve(static_cast<std::size_t>(nOwned) + 1);
  for (int p = 0; p < nOwned; ++p) {
    starts.push_back(listSize_);
    listSize_ += static_cast<std::size_t>(neighborhoodList[listSize_]) + 1;
  }
  sample_ = sampleOf(neighborhoodList, listSize_);
  nBonds_ = listSize_ - static_cast<std::size_t>(nOwned);

  int p = 0;
  std::vector<int> scattered;
  const auto flush = [&](int end) {
    for (int first = end - static_cast<int>(scattered.size()); first < end; first += lanes)
      addChunk(starts, neighborhoodList, ownedIds, first, std::min(lanes, end - first), false);
    scattered.clear();
  };
  while (p < nOwned) {
    int end = p + 1;
    while (end < nOwned && haveSameOffsets(neighborhoodList, starts[static_cast<std::size_t>(end) - 1],
                                           starts[static_cast<std::size_t>(end)], ownedIds[end - 1], ownedIds[end]))
      ++end;
    if (end - p < shortestRun) {
      scattered.push_back(p);
      p = end;
      continue;
    }
    flush(p);
    for (; p < end; p += lanes) addChunk(starts, neighborhoodList, ownedIds, p, std::min(lanes, end - p), true);
    p = end;
  }
  flush(nOwned);
}

void ChunkedNeighborhood::addChunk(const std::vector<std::size_t>& starts, const int* list, const int* ownedIds,
                                   int first, int count, bool isContiguous) {
  Chunk chunk{ownedIds[first], count, 0, isContiguous, 0, pointIds_.size(), nEntries_};
  for (int lane = 0; lane < lanes; ++lane) {
    const bool isUsed = lane < count;
    const auto position = static_cast<std::size_t>(first + (isUsed ? lane : 0));
    pointIds_.push_back(ownedIds[position]);
    firstBond_.push_back(starts[position] - position);
    nNeighbors_.push_back(isUsed ? list[starts[position]] : 0);
    chunk.nNeighbors = std::max(chunk.nNeighbors, nNeighbors_.back());
  }
  if (isContiguous) {
    const int* neighbors = list + starts[static_cast<std::size_t>(first)] + 1;
    const Chunk* previous = chunks_.empty() ? nullptr : &chunks_.back();
    const auto isOffset = [&](int k) {
      return offsets_[previous->indices + std::size_t(k)] == neighbors[k] - ownedIds[first];
    };
    bool canShare = previous != nullptr && previous->isContiguous && previous->nNeighbors == chunk.nNeighbors;
    for (int k = 0; canShare && k < chunk.nNeighbors; ++k) canShare = isOffset(k);
    chunk.indices = canShare ? previous->indices : offsets_.size();
    for (int k = 0; !canShare && k < chunk.nNeighbors; ++k) offsets_.push_back(neighbors[k] - ownedIds[first]);
  } else {
    chunk.indices = neighborIds_.size();
    for (int k = 0; k < chunk.nNeighbors; ++k)
      for (int lane = 0; lane < lanes; ++lane) {
        const bool isBond = k < nNeighbors_[chunk.points + std::size_t(lane)];
        const std::size_t start = starts[static_cast<std::size_t>(first + (isBond ? lane : 0))];
        neighborIds_.push_back(isBond ? list[start + 1 + std::size_t(k)] : pointIds_[chunk.points + std::size_t(lane)]);
      }
  }
  nEntries_ += static_cast<std::size_t>(chunk.nNeighbors) * lanes;
  chunks_.push_back(chunk);
}

bool ChunkedNeighborhood::isFor(int nOwned, const int* ownedIds, const int* neighborhoodList) const {
  return nOwned == nOwned_ && ownedIds == ownedIds_ && neighborhoodList == list_ &&
         (sample_.empty() || neighborhoodList[0] == sample_[0]) && sampleOf(neighborhoodList, listSize_) == sample_;
}

double ChunkedNeighborhood::contiguousShare() const {
  std::size_t contiguous = 0;
  for (const Chunk& chunk : chunks_)
    if (chunk.isContiguous) contiguous += static_cast<std::size_t>(chunk.nLanes * chunk.nNeighbors);
  return nBonds_ == 0 ? 0.0 : static_cast<double>(contiguous) / static_cast<double>(nBonds_);
}

std::size_t ChunkedNeighborhood::bytes() const {
  return chunks_.size() * sizeof(Chunk) + firstBond_.size() * sizeof(std::size_t) +
         (offsets_.size() + neighborIds_.size() + pointIds_.size() + nNeighbors_.size()) * sizeof(int);
}

BondConstants::BondConstants(const ChunkedNeighborhood& neighborhood, int width,
                             const std::function<void(int, int, std::size_t, double*)>& fill, Keep keep,
                             double tolerance, const std::function<void(double*)>& derive) {
  const auto w = static_cast<std::size_t>(width);
  std::vector<double> one(w), all, shared, scale(w);
  CanonicalValues canonical(tolerance);
  std::size_t lastUniform = 0;
  std::size_t lastUniformSize = 0;
  for (const Chunk& chunk : neighborhood.chunks()) {
    const std::size_t count = static_cast<std::size_t>(chunk.nNeighbors) * w;
    all.assign(count * lanes, 0.0);
    std::fill(scale.begin(), scale.end(), 0.0);
    for (int lane = 0; lane < chunk.nLanes; ++lane)
      for (int k = 0; k < neighborhood.nNeighbors(chunk, lane); ++k) {
        fill(neighborhood.pointIds(chunk)[lane], neighborhood.neighbor(chunk, k, lane),
             neighborhood.firstBond(chunk, lane) + static_cast<std::size_t>(k), one.data());
        for (std::size_t c = 0; c < w; ++c) {
          all[(static_cast<std::size_t>(k) * w + c) * lanes + static_cast<std::size_t>(lane)] = one[c];
          scale[c] = std::max(scale[c], std::abs(one[c]));
        }
      }
    bool uniform = chunk.isContiguous;
    for (std::size_t i = 0; uniform && i < count; ++i)
      for (int lane = 1; uniform && lane < chunk.nLanes; ++lane)
        uniform =
            std::abs(all[i * lanes + static_cast<std::size_t>(lane)] - all[i * lanes]) <= tolerance * scale[i % w];
    isUniform_.push_back(uniform);
    if (!uniform) {
      start_.push_back(values_.size());
      if (keep == Keep::OnlyUniform) continue;
      values_.insert(values_.end(), all.begin(), all.end());
      continue;
    }
    bool canShare = lastUniformSize == count;
    for (std::size_t i = 0; canShare && i < count; ++i)
      canShare = std::abs(all[i * lanes] - values_[lastUniform + i]) <= tolerance * scale[i % w];
    if (!canShare) {
      lastUniform = values_.size();
      lastUniformSize = count;
      for (std::size_t i = 0; i < count; ++i) values_.push_back(canonical(all[i * lanes]));
      for (std::size_t i = 0; derive && i < count; i += w) derive(&values_[lastUniform + i]);
    }
    start_.push_back(lastUniform);
  }
}

}  // namespace pd::kernels
