#include "alive_bonds.hpp"

namespace pd::kernels {

AliveBonds::AliveBonds(const ChunkedNeighborhood& neighborhood) {
  bits_.reserve(neighborhood.nEntries());
  for (const Chunk& chunk : neighborhood.chunks()) {
    const unsigned char* present = neighborhood.present(chunk);
    bits_.insert(bits_.end(), present, present + chunk.nNeighbors);
    seen_.resize(chunk.points + lanes, 0.0);
  }
}

bool AliveBonds::refresh(const ChunkedNeighborhood& neighborhood, const double* bondDamage, const double* damage) {
  bool isWhole = true;
  for (const Chunk& chunk : neighborhood.chunks()) {
    unsigned char* bits = of(chunk);
    const int* points = neighborhood.pointIds(chunk);
    for (int lane = 0; lane < chunk.nLanes; ++lane) {
      if (damage != nullptr) {
        double& seen = seen_[chunk.points + static_cast<std::size_t>(lane)];
        if (damage[points[lane]] == seen) continue;
        seen = damage[points[lane]];
      }
      neighborhood.forEachBond(chunk, lane, [&](int k, std::size_t bond) {
        isWhole = isWhole && (bondDamage[bond] == 0.0 || bondDamage[bond] == 1.0);
        const unsigned bit = 1u << lane;
        bits[k] = static_cast<unsigned char>(bondDamage[bond] < 1.0 ? bits[k] | bit : bits[k] & ~bit);
      });
    }
  }
  return isWhole;
}

}  // namespace pd::kernels
