#include "diffusion_kernel.hpp"

namespace pd::kernels {

namespace {

template <bool isContiguous, bool isUniform, bool isMasked>
Vector fluxOf(const Chunk& chunk, const int* indices, const double* weights, const unsigned char* bits,
              const Vector& own, const double* concentration) {
  Vector sum = 0.0;
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    const Vector other =
        isContiguous ? load(concentration + chunk.firstPoint + indices[k]) : gather(concentration, indices + k * lanes);
    const Vector weight = isUniform ? Vector(weights[k]) : load(weights + k * lanes);
    const Vector flux = weight * (other - own);
    sum += isMasked ? keep(flux, bits[k]) : flux;
  }
  return sum;
}

template <bool isContiguous, bool isUniform>
Vector fluxOf(const Chunk& chunk, const int* indices, const double* weights, const unsigned char* bits,
              const Vector& own, const double* concentration) {
  return bits != nullptr ? fluxOf<isContiguous, isUniform, true>(chunk, indices, weights, bits, own, concentration)
                         : fluxOf<isContiguous, isUniform, false>(chunk, indices, weights, bits, own, concentration);
}

}  // namespace

void addFluxDivergence(const ChunkedNeighborhood& neighborhood, const BondConstants& weights, const AliveBonds* alive,
                       const double* concentration, double* rate, const std::vector<std::size_t>* only) {
  const auto& chunks = neighborhood.chunks();
  const std::size_t count = only == nullptr ? chunks.size() : only->size();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t c = only == nullptr ? i : (*only)[i];
    const Chunk& chunk = chunks[c];
    const bool isUniform = weights.isUniform(c);
    // Where constants are kept a lane, they are zero in lanes that have no such neighbour.
    const unsigned char* bits = alive != nullptr             ? alive->of(chunk)
                                : isUniform && !chunk.isFull ? neighborhood.present(chunk)
                                                             : nullptr;
    Vector sum;
    if (chunk.isContiguous) {
      const Vector own = load(concentration + chunk.firstPoint);
      const int* offsets = neighborhood.offsets(chunk);
      sum = isUniform ? fluxOf<true, true>(chunk, offsets, weights.of(c), bits, own, concentration)
                      : fluxOf<true, false>(chunk, offsets, weights.of(c), bits, own, concentration);
    } else {
      const Vector own = gather(concentration, neighborhood.pointIds(chunk));
      sum = fluxOf<false, false>(chunk, neighborhood.neighborIds(chunk), weights.of(c), bits, own, concentration);
    }
    addToPoints(neighborhood, chunk, sum, rate);
  }
}

}  // namespace pd::kernels
