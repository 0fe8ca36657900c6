#include "alive_bonds.hpp"

namespace pd::kernels {

AliveBonds::AliveBonds(const ChunkedNeighborhood& neighborhood) : bits_(neighborhood.nEntries() / lanes, 0) {
  for (const Chunk& chunk : neighborhood.chunks()) {
    unsigned char* bits = of(chunk);
    for (int lane = 0; lane < chunk.nLanes; ++lane)
      for (int k = 0; k < neighborhood.nNeighbors(chunk, lane); ++k)
        bits[k] = static_cast<unsigned char>(bits[k] | (1u << lane));
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
      const double* ofPoint = bondDamage + neighborhood.firstBond(chunk, lane);
      for (int k = 0; k < neighborhood.nNeighbors(chunk, lane); ++k) {
        isWhole = isWhole && (ofPoint[k] == 0.0 || ofPoint[k] == 1.0);
        const unsigned bit = 1u << lane;
        bits[k] = static_cast<unsigned char>(ofPoint[k] < 1.0 ? bits[k] | bit : bits[k] & ~bit);
      }
    }
  }
  return isWhole;
}

}  // namespace pd::kernels
