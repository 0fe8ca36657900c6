// Neighbourhoods laid out for vector loops: points in chunks of as many as a vector has lanes.
#ifndef PD_CHUNKED_NEIGHBORHOOD_HPP
#define PD_CHUNKED_NEIGHBORHOOD_HPP

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

#include "simd.hpp"

namespace pd::kernels {

/// A chunk holds up to `lanes` points. In a contiguous chunk the points have consecutive local ids, and entry k stands
/// for the neighbours at one offset (local id of the neighbour minus that of the point), so that those of all lanes are
/// contiguous in memory; a lane that has no such neighbour is left out by present(). Points of a lattice, also of a
/// jittered one, are in such chunks. Any other chunk lists the neighbour of every lane.
struct Chunk {
  int firstPoint;       ///< contiguous: local id of lane 0
  int nLanes;           ///< lanes in use
  int nNeighbors;       ///< entries
  bool isContiguous;    ///<
  bool isFull;          ///< every lane has every entry
  std::size_t indices;  ///< contiguous: start of the nNeighbors offsets in offsets();
                        ///< else start of nNeighbors x lanes local ids in neighborIds() (own id where a lane has fewer)
  std::size_t points;   ///< start of the `lanes` local ids in pointIds() (lane 0's id in unused lanes)
  std::size_t entries;  ///< entries of all chunks before this one: where data kept an entry each start
};

class ChunkedNeighborhood {
 public:
  ChunkedNeighborhood() = default;
  /// `neighborhoodList`: flat, of the points `ownedIds`, as Peridigm lays it out.
  ChunkedNeighborhood(int nOwned, const int* ownedIds, const int* neighborhoodList);

  /// Was this made from this very list? Compares sizes, addresses and a sample of the content.
  bool isFor(int nOwned, const int* ownedIds, const int* neighborhoodList) const;

  const std::vector<Chunk>& chunks() const { return chunks_; }
  const int* offsets(const Chunk& chunk) const { return offsets_.data() + chunk.indices; }
  const int* neighborIds(const Chunk& chunk) const { return neighborIds_.data() + chunk.indices; }
  const int* pointIds(const Chunk& chunk) const { return pointIds_.data() + chunk.points; }
  /// Points and neighbours of chunks that are not contiguous, each once.
  const std::vector<int>& scatteredPoints() const { return scatteredPoints_; }
  /// One byte an entry; bit = lane that has this neighbour.
  const unsigned char* present(const Chunk& chunk) const { return present_.data() + chunk.entries; }

  /// Local id of the neighbour of a lane at entry k.
  int neighbor(const Chunk& chunk, int k, int lane) const {
    return chunk.isContiguous ? chunk.firstPoint + lane + offsets(chunk)[k] : neighborIds(chunk)[k * lanes + lane];
  }
  /// Position of a lane's first bond in the host's bond data (without counts), and its number of neighbours.
  std::size_t firstBond(const Chunk& chunk, int lane) const { return firstBond_[chunk.points + std::size_t(lane)]; }
  int nNeighbors(const Chunk& chunk, int lane) const { return nNeighbors_[chunk.points + std::size_t(lane)]; }
  /// Position of the bond of a lane at entry k in the host's bond data.
  std::size_t bond(const Chunk& chunk, int k, int lane) const {
    std::size_t position = firstBond(chunk, lane);
    if (chunk.isFull) return position + static_cast<std::size_t>(k);
    const unsigned char* has = present(chunk);
    for (int before = 0; before < k; ++before) position += (has[before] >> lane) & 1u;
    return position;
  }
  /// Calls visit(k, bond) for every bond of a lane, in the host's order.
  template <class Visit>
  void forEachBond(const Chunk& chunk, int lane, Visit visit) const {
    std::size_t position = firstBond(chunk, lane);
    const unsigned char* has = present(chunk);
    for (int k = 0; k < chunk.nNeighbors; ++k)
      if ((has[k] >> lane) & 1u) visit(k, position++);
  }

  std::size_t nEntries() const { return present_.size(); }  ///< of all chunks, `lanes` bonds each
  std::size_t nBonds() const { return nBonds_; }            ///< directed bonds
  std::size_t bytes() const;

 private:
  struct Lists;
  /// `least`: share of the lanes that a contiguous chunk must use.
  void makeChunks(const Lists& lists, double least);
  using OffsetPlaces = std::map<std::vector<int>, std::size_t>;  ///< where in offsets_ they are
  void addContiguous(const Lists& lists, int first, int count, const std::vector<int>& offsets, OffsetPlaces& known);
  void addScattered(const Lists& lists, int first, int count);
  Chunk newChunk(const Lists& lists, int first, int count, bool isContiguous);
  void finish(Chunk chunk);

  std::vector<Chunk> chunks_;
  std::vector<int> offsets_, neighborIds_, pointIds_, nNeighbors_, scatteredPoints_;
  std::vector<unsigned char> present_;
  std::vector<std::size_t> firstBond_;
  std::size_t nBonds_ = 0;
  int nOwned_ = 0;
  const int* ownedIds_ = nullptr;
  const int* list_ = nullptr;
  std::size_t listSize_ = 0;
  std::vector<int> sample_;
};

/// Adds the lanes in use to `values`, by local id, at the points of the chunk.
inline void addToPoints(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, const Vector& sum,
                        double* values) {
  if (chunk.isContiguous && chunk.nLanes == lanes) {
    double* own = values + chunk.firstPoint;
    store(load(own) + sum, own);
    return;
  }
  const int* points = neighborhood.pointIds(chunk);
  for (int lane = 0; lane < chunk.nLanes; ++lane) values[points[lane]] += sum[static_cast<std::size_t>(lane)];
}

/// Constants that follow from others of the same bond.
struct DerivedConstants {
  int width = 0;                         ///< 0: nothing is derived
  std::function<void(double*)> replace;  ///< writes `width` constants over those that it reads
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
  /// Values of uniform chunks are replaced by representatives within `tolerance`, and these by what `derived` makes of
  /// them.
  enum class Keep { All, OnlyUniform };
  BondConstants(const ChunkedNeighborhood& neighborhood, int width,
                const std::function<void(int, int, std::size_t, double*)>& fill, Keep keep = Keep::All,
                double tolerance = 1e-12, const DerivedConstants& derived = {});

  bool isUniform(std::size_t chunk) const { return isUniform_[chunk] != 0; }
  /// Uniform: width (or derived width) doubles a neighbour, [k * width + component].
  /// Else: width vectors a neighbour, [(k * width + component) * lanes + lane]; zero where a lane has no neighbour.
  const double* of(std::size_t chunk) const { return values_.data() + start_[chunk]; }
  std::size_t bytes() const { return values_.size() * sizeof(double) + start_.size() * (sizeof(std::size_t) + 1); }

 private:
  std::vector<double> values_;
  std::vector<std::size_t> start_;
  std::vector<char> isUniform_;
};

}  // namespace pd::kernels

#endif
