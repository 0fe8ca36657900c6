#include "diffusion_kernel.hpp"

#include <array>

namespace pd::kernels {

namespace {

// A sum waits for each of its terms: so many chunks whose offsets and weights are the same are summed side by side.
constexpr std::size_t nAlike = 4;

/// Of nAlike contiguous chunks, full and uniform.
void addFluxesOfAlike(const ChunkedNeighborhood& neighborhood, const std::array<const Chunk*, nAlike>& chunks,
                      const double* weights, const double* concentration, double* rate) {
  const int* offsets = neighborhood.offsets(*chunks[0]);
  std::array<const double*, nAlike> at;
  std::array<Vector, nAlike> own, sum;
  for (std::size_t c = 0; c < nAlike; ++c) {
    at[c] = concentration + chunks[c]->firstPoint;
    own[c] = load(at[c]);
    sum[c] = 0.0;
  }
  for (int k = 0; k < chunks[0]->nNeighbors; ++k) {
    const Vector weight(weights[k]);
    for (std::size_t c = 0; c < nAlike; ++c) sum[c] += weight * (load(at[c] + offsets[k]) - own[c]);
  }
  for (std::size_t c = 0; c < nAlike; ++c) addToPoints(neighborhood, *chunks[c], sum[c], rate);
}

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

template <bool isContiguous, bool isUniform>
Vector scaledFluxOf(const Chunk& chunk, const int* indices, const double* weights, const unsigned char* bits,
                    const int* points, const double* scale, const double* concentration) {
  const auto own = [&](const double* values) {
    return isContiguous ? load(values + chunk.firstPoint) : gather(values, points);
  };
  const Vector ownConcentration = own(concentration), ownScale = own(scale);
  Vector sum = 0.0;
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    if (bits[k] == 0) continue;
    const auto other = [&](const double* values) {
      return isContiguous ? load(values + chunk.firstPoint + indices[k]) : gather(values, indices + k * lanes);
    };
    const Vector weight = isUniform ? Vector(weights[k]) : load(weights + k * lanes);
    sum += keep(weight * ((ownScale + other(scale)) * (other(concentration) - ownConcentration)), bits[k]);
  }
  return 0.5 * sum;
}

}  // namespace

void addFluxDivergence(const ChunkedNeighborhood& neighborhood, const BondConstants& weights, const AliveBonds* alive,
                       const double* concentration, double* rate, const std::vector<std::size_t>* only) {
  const auto& chunks = neighborhood.chunks();
  const std::size_t count = only == nullptr ? chunks.size() : only->size();
  const auto chunkAt = [&](std::size_t i) { return only == nullptr ? i : (*only)[i]; };
  /// Those of nAlike chunks from i on, if they are; else null.
  const auto findAlike = [&](std::size_t i) {
    std::array<const Chunk*, nAlike> alike{};
    if (alive != nullptr || i + nAlike > count) return alike;
    for (std::size_t k = 0; k < nAlike; ++k) {
      const std::size_t c = chunkAt(i + k), first = chunkAt(i);
      const bool isLikeFirst = chunks[c].isContiguous && chunks[c].isFull && weights.isUniform(c) &&
                               chunks[c].indices == chunks[first].indices && weights.of(c) == weights.of(first);
      if (!isLikeFirst) return std::array<const Chunk*, nAlike>{};
      alike[k] = &chunks[c];
    }
    return alike;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t c = chunkAt(i);
    if (const auto alike = findAlike(i); alike[0] != nullptr) {
      addFluxesOfAlike(neighborhood, alike, weights.of(c), concentration, rate);
      i += nAlike - 1;
      continue;
    }
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

void addScaledFluxDivergence(const ChunkedNeighborhood& neighborhood, const BondConstants& weights,
                             const AliveBonds& alive, const std::vector<std::size_t>& only, const double* scale,
                             const double* concentration, double* rate) {
  for (const std::size_t c : only) {
    const Chunk& chunk = neighborhood.chunks()[c];
    const int* indices = chunk.isContiguous ? neighborhood.offsets(chunk) : neighborhood.neighborIds(chunk);
    const auto flux = !chunk.isContiguous    ? scaledFluxOf<false, false>
                      : weights.isUniform(c) ? scaledFluxOf<true, true>
                                             : scaledFluxOf<true, false>;
    addToPoints(
        neighborhood, chunk,
        flux(chunk, indices, weights.of(c), alive.of(chunk), neighborhood.pointIds(chunk), scale, concentration), rate);
  }
}

}  // namespace pd::kernels
