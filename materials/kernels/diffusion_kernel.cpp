#include "diffusion_kernel.hpp"

namespace pd::kernels {

namespace {

/// Adds the lanes in use to the points of the chunk.
void addToPoints(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, const Vector& sum, double* rate) {
  if (chunk.isContiguous && chunk.nLanes == lanes) {
    double* own = rate + chunk.firstPoint;
    store(load(own) + sum, own);
    return;
  }
  const int* points = neighborhood.pointIds(chunk);
  for (int lane = 0; lane < chunk.nLanes; ++lane) rate[points[lane]] += sum[static_cast<std::size_t>(lane)];
}

template <bool isContiguous, bool isUniform, bool isCut>
Vector fluxOf(const Chunk& chunk, const int* indices, const double* weights, const unsigned char* bits,
              const Vector& own, const double* concentration) {
  Vector sum = 0.0;
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    const Vector other =
        isContiguous ? load(concentration + chunk.firstPoint + indices[k]) : gather(concentration, indices + k * lanes);
    const Vector weight = isUniform ? Vector(weights[k]) : load(weights + k * lanes);
    const Vector flux = weight * (other - own);
    sum += isCut ? keep(flux, bits[k]) : flux;
  }
  return sum;
}

template <bool isCut>
void addFlux(const ChunkedNeighborhood& neighborhood, const BondConstants& weights, const AliveBonds* alive,
             const double* concentration, double* rate) {
  const auto& chunks = neighborhood.chunks();
  for (std::size_t c = 0; c < chunks.size(); ++c) {
    const Chunk& chunk = chunks[c];
    const unsigned char* bits = isCut ? alive->of(chunk) : nullptr;
    Vector sum;
    if (chunk.isContiguous) {
      const Vector own = load(concentration + chunk.firstPoint);
      const int* offsets = neighborhood.offsets(chunk);
      sum = weights.isUniform(c) ? fluxOf<true, true, isCut>(chunk, offsets, weights.of(c), bits, own, concentration)
                                 : fluxOf<true, false, isCut>(chunk, offsets, weights.of(c), bits, own, concentration);
    } else {
      const Vector own = gather(concentration, neighborhood.pointIds(chunk));
      sum =
          fluxOf<false, false, isCut>(chunk, neighborhood.neighborIds(chunk), weights.of(c), bits, own, concentration);
    }
    addToPoints(neighborhood, chunk, sum, rate);
  }
}

}  // namespace

void addFluxDivergence(const ChunkedNeighborhood& neighborhood, const BondConstants& weights, const AliveBonds* alive,
                       const double* concentration, double* rate) {
  if (alive == nullptr)
    addFlux<false>(neighborhood, weights, alive, concentration, rate);
  else
    addFlux<true>(neighborhood, weights, alive, concentration, rate);
}

}  // namespace pd::kernels
