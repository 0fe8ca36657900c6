// Which bonds are unbroken, as one bit a bond in the order of the chunks.
#ifndef PD_ALIVE_BONDS_HPP
#define PD_ALIVE_BONDS_HPP

#include <vector>

#include "chunked_neighborhood.hpp"

namespace pd::kernels {

/// A view of the field Bond_Damage for vector loops. The field stays the only memory: refresh() reads it again for
/// every point whose `Damage` has changed since (a damage model that changes bonds of a point changes its Damage).
class AliveBonds {
 public:
  AliveBonds() = default;
  /// All bonds unbroken.
  explicit AliveBonds(const ChunkedNeighborhood& neighborhood);

  /// `bondDamage`: in the host's order; `damage`: by local id; null: read every bond again. Returns false where a bond
  /// is damaged in part (0 < d < 1).
  bool refresh(const ChunkedNeighborhood& neighborhood, const double* bondDamage, const double* damage);

  /// The next refresh() reads every bond.
  void forget();

  /// What a damage model does itself need not be read again: a bond that it breaks, and the Damage of the point then.
  void markBroken(const Chunk& chunk, int k, int lane) {
    unsigned char& bits = of(chunk)[k];
    bits = static_cast<unsigned char>(bits & ~(1u << lane));
  }
  void markSeen(const Chunk& chunk, int lane, double damage) {
    seen_[chunk.points + static_cast<std::size_t>(lane)] = damage;
  }

  /// One byte an entry of the chunk; bit = lane. Zero where the lane has no such neighbour.
  const unsigned char* of(const Chunk& chunk) const { return bits_.data() + chunk.entries; }
  unsigned char* of(const Chunk& chunk) { return bits_.data() + chunk.entries; }
  std::size_t bytes() const { return bits_.size() + seen_.size() * sizeof(double); }

 private:
  /// Of the lanes whose bits are set in `changed`.
  bool refreshLanes(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, unsigned changed,
                    const double* bondDamage);

  std::vector<unsigned char> bits_;
  std::vector<double> seen_;  ///< Damage of each lane at the last refresh
};

}  // namespace pd::kernels

#endif
