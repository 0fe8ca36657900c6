// Sums over the bonds between the phases of a dissolving body.
#ifndef PD_DISSOLUTION_KERNEL_HPP
#define PD_DISSOLUTION_KERNEL_HPP

#include <utility>
#include <vector>

#include "alive_bonds.hpp"
#include "chunked_neighborhood.hpp"

namespace pd::kernels {

/// Which bonds join two liquid points, and which a solid and a liquid one. Kept up to date point by point, since few
/// change at a time; chunks of nothing but intact solid take no part in any loop.
class PhaseBonds {
 public:
  PhaseBonds() = default;
  /// All points solid. `neighborhoodList`: what the neighbourhood was made from, as long as this lives.
  PhaseBonds(const ChunkedNeighborhood& neighborhood, int nOwned, const int* ownedIds, const int* neighborhoodList,
             int nPoints);
  /// Points where `saturation`, by local id, is 0 are walls: neither solid nor liquid. Call it before refresh().
  void excludeWalls(const double* saturation);

  /// `damage` by local id: a point is liquid where it is 1. Returns whether any point has changed phase.
  bool refresh(const ChunkedNeighborhood& neighborhood, const double* damage);

  /// By local id, as of the last refresh, in steps, since few points take one at a time.
  const double* steppedDamage() const { return steppedDamage_.data(); }
  /// Points that have taken such a step at the last refresh.
  const std::vector<int>& changedPoints() const { return changedPoints_; }
  /// Chunks with a point that has changed, or a neighbour of it, at the last refresh that found any.
  const std::vector<std::size_t>& changedChunks() const { return changedChunks_; }
  /// Chunks with bonds of solid points to liquid ones that have one of these points or a neighbour of one.
  std::vector<std::size_t> solidChunksAround(const std::vector<int>& points) const;
  /// Chunks with any bond that is not between solid points.
  const std::vector<std::size_t>& activeChunks() const { return activeChunks_; }
  /// Local ids [first, end) of liquid points, those that are not owned included.
  const std::vector<std::pair<int, int>>& liquidRanges() const { return liquidRanges_; }
  bool isLiquid(int point) const { return isLiquid_[static_cast<std::size_t>(point)] != 0; }
  /// Number of neighbours of an owned point, followed by them.
  const int* listOf(int ownedPoint) const {
    return list_ + starts_[static_cast<std::size_t>(ownedPosition_[static_cast<std::size_t>(ownedPoint)])];
  }
  /// Its neighbours that are no walls, into `neighbors`.
  void findNeighborsWithoutWalls(int ownedPoint, std::vector<int>& neighbors) const;

  const AliveBonds& liquid() const { return liquid_; }
  const std::vector<std::size_t>& liquidChunks() const { return liquidChunks_; }  ///< that have such bonds
  const AliveBonds& fromSolid() const { return fromSolid_; }  ///< bonds of solid points to liquid ones
  const std::vector<std::size_t>& solidChunks() const { return solidChunks_; }
  const AliveBonds& fromLiquid() const { return fromLiquid_; }  ///< bonds of liquid points to solid ones
  const std::vector<std::size_t>& wetChunks() const { return wetChunks_; }
  /// Liquid points with a bond to a solid one: the owned ones, and those near owned solid points.
  const std::vector<int>& sources() const { return sources_; }
  /// Solid points with a bond to a liquid one: the owned ones, and those near owned liquid points.
  const std::vector<int>& sinks() const { return sinks_; }

 private:
  void markChunksOf(int point, std::vector<char>& isMarked) const;
  void refreshChunk(const ChunkedNeighborhood& neighborhood, std::size_t c);
  void collect(const ChunkedNeighborhood& neighborhood);
  /// Points at either end of the bonds in `fromOwn`, bonds of owned points of the one phase to points of the other, and
  /// in `fromOther`, the reverse: those of the one phase, in order.
  std::vector<int> ends(const ChunkedNeighborhood& neighborhood, const AliveBonds& fromOwn,
                        const std::vector<std::size_t>& ownChunks, const AliveBonds& fromOther,
                        const std::vector<std::size_t>& otherChunks) const;

  const int* list_ = nullptr;
  std::vector<std::size_t> starts_;             ///< of the list of each owned point
  std::vector<int> chunkOf_;                    ///< by local id; -1: not owned
  std::vector<int> ownedPosition_;              ///< by local id; -1: not owned
  std::vector<std::vector<int>> chunksAround_;  ///< of points that are not owned, by local id
  std::vector<char> isWall_;                    ///< by local id; empty: none is
  std::vector<char> isLiquid_;                  ///< by local id
  std::vector<double> steppedDamage_;
  std::vector<int> changedPoints_;
  AliveBonds liquid_, fromSolid_, fromLiquid_;
  struct Kinds {
    bool liquid = false, fromSolid = false, fromLiquid = false;
  };
  std::vector<Kinds> kinds_;  ///< of bonds that a chunk has
  std::vector<std::size_t> liquidChunks_, solidChunks_, wetChunks_, changedChunks_, activeChunks_;
  std::vector<std::pair<int, int>> liquidRanges_;
  std::vector<int> sources_, sinks_;
};

/// sum_i += scale_i sum_j w_ij v_j over the bonds whose bits are set, in the chunks `only`. `scale`, `values` null: 1.
/// Arrays by local id, readable as PointArrays are.
void addWeightedSum(const ChunkedNeighborhood& neighborhood, const BondConstants& weights, const AliveBonds& bonds,
                    const std::vector<std::size_t>& only, const double* scale, const double* values, double* sum);

}  // namespace pd::kernels

#endif
