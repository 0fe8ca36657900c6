#include "chunked_neighborhood.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <set>
#include <unordered_map>

namespace pd::kernels {

namespace {

constexpr int samplesOfList = 64;
constexpr std::size_t patternsKept = 5000;  ///< of chunks: a lattice has few, and on other meshes none comes twice
/// Of the lanes of a contiguous chunk. With fewer, gathering is quicker: but for a few chunks, at the ends of a
/// lattice's rows, it does not pay to lay out the points for it.
constexpr double leastUseOnLattice = 0.35, leastUse = 0.5;

std::vector<int> sampleOf(const int* list, std::size_t size) {
  std::vector<int> sample;
  if (size == 0) return sample;
  for (std::size_t s = 0; s < samplesOfList; ++s) sample.push_back(list[s * (size - 1) / (samplesOfList - 1)]);
  return sample;
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

/// Constants of the chunks so far, to be found again although they differ by round-off.
class KnownPatterns {
 public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  /// Of values in units in which `tolerance` (of each component) is small: round-off rarely changes it, and then costs
  /// no more than a copy.
  static std::uint64_t hashOf(const std::vector<double>& values, const std::vector<double>& tolerance) {
    std::uint64_t hash = values.size();
    for (std::size_t i = 0; i < values.size();)
      for (std::size_t c = 0; c < tolerance.size(); ++c, ++i) {
        const double coarse = 1e4 * std::max(tolerance[c], std::numeric_limits<double>::min());
        hash = (hash ^ static_cast<std::uint64_t>(std::llround(values[i] / coarse))) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 32;
      }
    return hash;
  }
  std::size_t find(std::uint64_t hash, const std::vector<double>& values, const std::vector<double>& tolerance) const {
    for (auto [it, end] = patterns_.equal_range(hash); it != end; ++it) {
      const std::vector<double>& other = it->second.values;
      bool isSame = other.size() == values.size();
      for (std::size_t i = 0; isSame && i < values.size();)
        for (std::size_t c = 0; c < tolerance.size(); ++c, ++i)
          isSame = isSame && std::abs(values[i] - other[i]) <= tolerance[c];
      if (isSame) return it->second.start;
    }
    return none;
  }
  void add(std::uint64_t hash, const std::vector<double>& values, std::size_t start) {
    if (patterns_.size() < patternsKept) patterns_.emplace(hash, Pattern{values, start});
  }

 private:
  struct Pattern {
    std::vector<double> values;
    std::size_t start;
  };
  std::unordered_multimap<std::uint64_t, Pattern> patterns_;
};

}  // namespace

struct ChunkedNeighborhood::Lists {
  const int* list;
  const int* ownedIds;
  std::vector<std::size_t> starts;  ///< of each point's count in `list`

  int count(int p) const { return list[starts[std::size_t(p)]]; }
  const int* neighbors(int p) const { return list + starts[std::size_t(p)] + 1; }
  bool isSorted(int p) const { return std::is_sorted(neighbors(p), neighbors(p) + count(p)); }
  bool hasOffsets(int p, const std::vector<int>& offsets) const {
    if (std::size_t(count(p)) != offsets.size()) return false;
    const int* ids = neighbors(p);
    for (int k = 0; k < count(p); ++k)
      if (ids[k] - ownedIds[p] != offsets[std::size_t(k)]) return false;
    return true;
  }
  /// The offsets of `nPoints` points from `first` on, in an order in which every point's list is; empty where there is
  /// none, or where the points have too few in common.
  std::vector<int> commonOffsets(int first, int nPoints, double least) const {
    std::vector<int> offsets;
    for (int k = 0; k < count(first); ++k) offsets.push_back(neighbors(first)[k] - ownedIds[first]);
    bool areSame = true, areSorted = isSorted(first);
    for (int p = first + 1; p < first + nPoints; ++p) {
      if (areSame && hasOffsets(p, offsets)) continue;
      areSame = false;
      areSorted = areSorted && isSorted(p);
      if (!areSorted) return {};
      std::vector<int> own, united;
      for (int k = 0; k < count(p); ++k) own.push_back(neighbors(p)[k] - ownedIds[p]);
      std::set_union(offsets.begin(), offsets.end(), own.begin(), own.end(), std::back_inserter(united));
      offsets.swap(united);
      // Early out for points that have nothing in common; the other lanes may yet fill up.
      if (least * double(offsets.size()) > double(count(first) + count(p))) return {};
    }
    double nBonds = 0.0;
    for (int p = first; p < first + nPoints; ++p) nBonds += count(p);
    return nBonds < least * lanes * double(offsets.size()) ? std::vector<int>{} : offsets;
  }
};

ChunkedNeighborhood::ChunkedNeighborhood(int nOwned, const int* ownedIds, const int* neighborhoodList)
    : nOwned_(nOwned), ownedIds_(ownedIds), list_(neighborhoodList) {
  Lists lists{neighborhoodList, ownedIds, {}};
  lists.starts.reserve(static_cast<std::size_t>(nOwned));
  for (int p = 0; p < nOwned; ++p) {
    lists.starts.push_back(listSize_);
    listSize_ += static_cast<std::size_t>(neighborhoodList[listSize_]) + 1;
  }
  sample_ = sampleOf(neighborhoodList, listSize_);
  nBonds_ = listSize_ - static_cast<std::size_t>(nOwned);

  makeChunks(lists, leastUseOnLattice);
  if (double(nBonds_) < leastUse * double(lanes * nEntries())) makeChunks(lists, leastUse);
}

void ChunkedNeighborhood::makeChunks(const Lists& lists, double least) {
  chunks_.clear();
  for (std::vector<int>* values : {&offsets_, &neighborIds_, &pointIds_, &nNeighbors_}) values->clear();
  present_.clear();
  firstBond_.clear();
  OffsetPlaces known;
  int firstScattered = 0;
  for (int p = 0; p < nOwned_;) {
    int end = p + 1;
    while (end < nOwned_ && end < p + lanes && ownedIds_[end] == ownedIds_[end - 1] + 1) ++end;
    const std::vector<int> offsets = lists.commonOffsets(p, end - p, least);
    if (!offsets.empty()) {
      addScattered(lists, firstScattered, p - firstScattered);
      addContiguous(lists, p, end - p, offsets, known);
      firstScattered = end;
    }
    p = end;
  }
  addScattered(lists, firstScattered, nOwned_ - firstScattered);
  scatteredPoints_ = neighborIds_;
  for (const Chunk& chunk : chunks_)
    if (!chunk.isContiguous) scatteredPoints_.insert(scatteredPoints_.end(), pointIds(chunk), pointIds(chunk) + lanes);
  std::sort(scatteredPoints_.begin(), scatteredPoints_.end());
  scatteredPoints_.erase(std::unique(scatteredPoints_.begin(), scatteredPoints_.end()), scatteredPoints_.end());
}

Chunk ChunkedNeighborhood::newChunk(const Lists& lists, int first, int count, bool isContiguous) {
  Chunk chunk{lists.ownedIds[first], count, 0, isContiguous, true, 0, pointIds_.size(), present_.size()};
  for (int lane = 0; lane < lanes; ++lane) {
    const int p = first + (lane < count ? lane : 0);
    pointIds_.push_back(lists.ownedIds[p]);
    firstBond_.push_back(lists.starts[std::size_t(p)] - std::size_t(p));
    nNeighbors_.push_back(lane < count ? lists.count(p) : 0);
    chunk.nNeighbors = std::max(chunk.nNeighbors, nNeighbors_.back());
  }
  return chunk;
}

void ChunkedNeighborhood::finish(Chunk chunk) {
  for (std::size_t k = chunk.entries; k < present_.size(); ++k) chunk.isFull = chunk.isFull && present_[k] == allLanes;
  chunks_.push_back(chunk);
}

void ChunkedNeighborhood::addContiguous(const Lists& lists, int first, int count, const std::vector<int>& offsets,
                                        OffsetPlaces& known) {
  Chunk chunk = newChunk(lists, first, count, true);
  chunk.nNeighbors = static_cast<int>(offsets.size());
  const auto found = known.find(offsets);
  chunk.indices = found != known.end() ? found->second : offsets_.size();
  if (found == known.end()) {
    offsets_.insert(offsets_.end(), offsets.begin(), offsets.end());
    if (known.size() < patternsKept) known.emplace(offsets, chunk.indices);
  }
  present_.resize(present_.size() + offsets.size(), 0);
  for (int lane = 0; lane < count; ++lane) {
    const int p = first + lane;
    std::size_t k = 0;
    for (int n = 0; n < lists.count(p); ++n, ++k) {
      while (offsets[k] != lists.neighbors(p)[n] - lists.ownedIds[p]) ++k;
      present_[chunk.entries + k] = static_cast<unsigned char>(present_[chunk.entries + k] | (1u << lane));
    }
  }
  finish(chunk);
}

void ChunkedNeighborhood::addScattered(const Lists& lists, int first, int count) {
  for (const int end = first + count; first < end; first += lanes) {
    Chunk chunk = newChunk(lists, first, std::min(lanes, end - first), false);
    chunk.indices = neighborIds_.size();
    for (int k = 0; k < chunk.nNeighbors; ++k) {
      unsigned bits = 0;
      for (int lane = 0; lane < lanes; ++lane) {
        const bool isBond = k < nNeighbors_[chunk.points + std::size_t(lane)];
        neighborIds_.push_back(isBond ? lists.neighbors(first + lane)[k] : pointIds_[chunk.points + std::size_t(lane)]);
        bits |= isBond ? 1u << lane : 0u;
      }
      present_.push_back(static_cast<unsigned char>(bits));
    }
    finish(chunk);
  }
}

bool ChunkedNeighborhood::isFor(int nOwned, const int* ownedIds, const int* neighborhoodList) const {
  return nOwned == nOwned_ && ownedIds == ownedIds_ && neighborhoodList == list_ &&
         (sample_.empty() || neighborhoodList[0] == sample_[0]) && sampleOf(neighborhoodList, listSize_) == sample_;
}

std::size_t ChunkedNeighborhood::bytes() const {
  return chunks_.size() * sizeof(Chunk) + firstBond_.size() * sizeof(std::size_t) + present_.size() +
         (offsets_.size() + neighborIds_.size() + pointIds_.size() + nNeighbors_.size() + scatteredPoints_.size()) *
             sizeof(int);
}

BondConstants::BondConstants(const ChunkedNeighborhood& neighborhood, int width,
                             const std::function<void(int, int, std::size_t, double*)>& fill, Keep keep,
                             double tolerance, const DerivedConstants& derived) {
  const auto w = static_cast<std::size_t>(width);
  std::vector<double> one(w), all, first, scale(w);
  CanonicalValues canonical(tolerance);
  KnownPatterns known;
  for (const Chunk& chunk : neighborhood.chunks()) {
    const std::size_t count = static_cast<std::size_t>(chunk.nNeighbors) * w;
    all.assign(count * lanes, 0.0);
    first.assign(count, 0.0);  // of the lanes that have the entry, the first one's constants
    std::fill(scale.begin(), scale.end(), 0.0);
    const unsigned char* present = neighborhood.present(chunk);
    for (int lane = 0; lane < chunk.nLanes; ++lane)
      neighborhood.forEachBond(chunk, lane, [&](int k, std::size_t bond) {
        fill(neighborhood.pointIds(chunk)[lane], neighborhood.neighbor(chunk, k, lane), bond, one.data());
        const bool isFirst = (present[k] & ((1u << lane) - 1u)) == 0;
        for (std::size_t c = 0; c < w; ++c) {
          const std::size_t at = static_cast<std::size_t>(k) * w + c;
          all[at * lanes + static_cast<std::size_t>(lane)] = one[c];
          if (isFirst) first[at] = one[c];
          scale[c] = std::max(scale[c], std::abs(one[c]));
        }
      });
    for (std::size_t c = 0; c < w; ++c) scale[c] *= tolerance;
    bool uniform = chunk.isContiguous;
    for (std::size_t k = 0, at = 0; uniform && k < static_cast<std::size_t>(chunk.nNeighbors); ++k)
      for (std::size_t c = 0; c < w; ++c, ++at)
        uniform = uniform && (present[k] & greaterBits(abs(load(&all[at * lanes]) - first[at]), scale[c])) == 0;
    isUniform_.push_back(uniform);
    if (!uniform) {
      start_.push_back(values_.size());
      if (keep == Keep::All) values_.insert(values_.end(), all.begin(), all.end());
      continue;
    }
    const std::uint64_t hash = KnownPatterns::hashOf(first, scale);
    std::size_t start = known.find(hash, first, scale);
    if (start == KnownPatterns::none) {
      start = values_.size();
      known.add(hash, first, start);
      for (std::size_t i = 0; i < count; i += w) {
        const std::size_t at = values_.size();
        for (std::size_t c = 0; c < w; ++c) values_.push_back(canonical(first[i + c]));
        if (derived.width == 0) continue;
        values_.resize(at + static_cast<std::size_t>(derived.width));
        derived.replace(&values_[at]);
      }
    }
    start_.push_back(start);
  }
}

}  // namespace pd::kernels
