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
      const unsigned bit = 1u << lane;
      const unsigned char* present = neighborhood.present(chunk);
      const double* next = bondDamage + neighborhood.firstBond(chunk, lane);
      for (int k = 0; k < chunk.nNeighbors; ++k) {
        if ((present[k] & bit) == 0) continue;
        const double value = *next++;
        isWhole = isWhole && (value == 0.0 || value == 1.0);
        bits[k] = static_cast<unsigned char>((bits[k] & ~bit) | (value < 1.0 ? bit : 0u));
      }
    }
  }
  return isWhole;
}

}  // namespace pd::kernels
