// Neighbourhoods laid out for vector loops: points in chunks of as many as a vector has lanes.
#ifndef PD_CHUNKED_NEIGHBORHOOD_HPP
#define PD_CHUNKED_NEIGHBORHOOD_HPP

#include <cstddef>
#include <functional>
#include <vector>

#include "simd.hpp"

namespace pd::kernels {

/// A chunk holds up to `lanes` points. In a contiguous chunk the points have consecutive local ids and neighbours at
/// the same offsets (local id of the neighbour minus that of the point), so that the k-th neighbours of all lanes are
/// contiguous in memory; most points of a lattice are in such chunks. Any other chunk lists the neighbour of every
/// lane. Neighbour k of a point is the k-th in the flat list of the host, in either kind.
struct Chunk {
  int firstPoint;       ///< contiguous: local id of lane 0
  int nLanes;           ///< lanes in use
  int nNeighbors;       ///< of the lane with most neighbours
  bool isContiguous;    ///<
  std::size_t indices;  ///< contiguous: start of the nNeighbors offsets in offsets();
                        ///< else start of nNeighbors x lanes local ids in neighborIds() (own id where a lane has fewer)
  std::size_t points;   ///< start of the `lanes` local ids in pointIds() (lane 0's id in unused lanes)
  std::size_t entries;  ///< number of (neighbour, lane) entries of all chunks before this one: where data kept an
                        ///< entry each start; `entries / lanes` where data kept a neighbour each start
};

class ChunkedNeighborhood {
 public:
  ChunkedNeighborhood() = default;
  /// `neighborhoodList`: flat, of the points `ownedIds`, as Peridigm lays it out.
  ChunkedNeighborhood(int nOwned, const int* ownedIds, const int* neighborhoodList);

  /// Was this made from this very list? Compares sizes, addresses and a sample of the content.
  bool isFor(int nOwned, const int* ownedIds, const int* neighborhoodList) const;

  const std::vector<Chunk>& chunks() const { return chunks_; }
  const int* offsets(const Chunk& chunk) const { return &offsets_[chunk.indices]; }
  const int* neighborIds(const Chunk& chunk) const { return &neighborIds_[chunk.indices]; }
  const int* pointIds(const Chunk& chunk) const { return &pointIds_[chunk.points]; }
  /// Position of a lane's first bond in the host's bond data (without counts), and its number of neighbours.
  std::size_t firstBond(const Chunk& chunk, int lane) const { return firstBond_[chunk.points + std::size_t(lane)]; }
  int nNeighbors(const Chunk& chunk, int lane) const { return nNeighbors_[chunk.points + std::size_t(lane)]; }
  /// Local id of the k-th neighbour of a lane.
  int neighbor(const Chunk& chunk, int k, int lane) const {
    return chunk.isContiguous ? chunk.firstPoint + lane + offsets(chunk)[k] : neighborIds(chunk)[k * lanes + lane];
  }

  std::size_t nEntries() const { return nEntries_; }  ///< (neighbour, lane) entries of all chunks
  std::size_t nBonds() const { return nBonds_; }      ///< directed bonds
  double contiguousShare() const;                     ///< share of the bonds that are in contiguous chunks
  std::size_t bytes() const;

 private:
  void addChunk(const std::vector<std::size_t>& listStarts, const int* list, const int* ownedIds, int first, int count,
                bool isContiguous);

  std::vector<Chunk> chunks_;
  std::vector<int> offsets_, neighborIds_, pointIds_, nNeighbors_;
  std::vector<std::size_t> firstBond_;
  std::size_t nEntries_ = 0, nBonds_ = 0;
  int nOwned_ = 0;
  const int* ownedIds_ = nullptr;
  const int* list_ = nullptr;
  std::size_t listSize_ = 0;
  std::vector<int> sample_;
};

/// Constants of bonds, `width` doubles each, in the order of the chunks. Where all lanes of a contiguous chunk have the
/// same constants (to `tolerance`, relative to the largest of each component), one set a neighbour is kept for the
/// whole chunk, and chunks that agree share it: on a uniform lattice the constants of a whole row take no more room
/// than those of one point.
class BondConstants {
 public:
  BondConstants() = default;
  /// `fill(point, neighbor, bond, values)` writes the constants of one bond; bond = position in the host's bond data.
  /// With `OnlyUniform`, chunks whose lanes differ keep nothing (of() must not be called for them).
  /// Values of uniform chunks are replaced by representatives within `tolerance`; `derive(values)`, where given, then
  /// sets those constants of a bond that must fit the others to round-off.
  enum class Keep { All, OnlyUniform };
  BondConstants(const ChunkedNeighborhood& neighborhood, int width,
                const std::function<void(int, int, std::size_t, double*)>& fill, Keep keep = Keep::All,
                double tolerance = 1e-12, const std::function<void(double*)>& derive = {});

  bool isUniform(std::size_t chunk) const { return isUniform_[chunk] != 0; }
  /// Uniform: width doubles a neighbour, [k * width + component].
  /// Else: width vectors a neighbour, [(k * width + component) * lanes + lane]; zero where a lane has fewer neighbours.
  const double* of(std::size_t chunk) const { return &values_[start_[chunk]]; }
  std::size_t bytes() const { return values_.size() * sizeof(double) + start_.size() * (sizeof(std::size_t) + 1); }

 private:
  std::vector<double> values_;
  std::vector<std::size_t> start_;
  std::vector<char> isUniform_;
};

}  // namespace pd::kernels

#endif
