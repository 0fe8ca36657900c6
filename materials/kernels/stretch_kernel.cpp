#include "stretch_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace pd::kernels {

namespace {

template <class Scalar>
Scalar stretchAt(const CriticalStretchLaw& law, const Scalar& psi) {
  using std::max;
  const auto& p = law.polynomial;
  const Scalar value = p[0] + psi * (p[1] + psi * (p[2] + psi * p[3]));
  const Scalar factor = max(value, Scalar(0.0));
  return law.stretch * (law.scalesEnergy ? squareRoot(factor) : factor);
}

template <int D, bool isContiguous, bool hasCoverage>
void findInChunk(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, const unsigned char* bits,
                 const PointArrays& reference, const PointArrays& current, const double* coverage,
                 const CriticalStretchLaw& law, const std::function<void(const Chunk&, int, int)>& onBreak) {
  const int* indices = isContiguous ? neighborhood.offsets(chunk) : neighborhood.neighborIds(chunk);
  const int* points = neighborhood.pointIds(chunk);
  const auto atPoints = [&](const double* values) {
    return isContiguous ? load(values + chunk.firstPoint) : gather(values, points);
  };
  const auto atNeighbors = [&](const double* values, int k) {
    return isContiguous ? load(values + chunk.firstPoint + indices[k]) : gather(values, indices + k * lanes);
  };
  Vector x[D], y[D], ownPsi = 0.0;
  for (int d = 0; d < D; ++d) {
    x[d] = atPoints(reference[d]);
    y[d] = atPoints(current[d]);
  }
  if (hasCoverage) ownPsi = atPoints(coverage);
  const bool limitsCompression = std::isfinite(law.compressiveStretch);
  const double shortest = 1.0 - std::min(law.compressiveStretch, 1.0);
  Vector limit = 1.0 + stretchAt(law, 0.0);
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    if (bits[k] == 0) continue;
    Vector length2 = 0.0, current2 = 0.0;
    for (int d = 0; d < D; ++d) {
      const Vector xi = atNeighbors(reference[d], k) - x[d], bond = atNeighbors(current[d], k) - y[d];
      length2 += xi * xi;
      current2 += bond * bond;
    }
    if (hasCoverage) limit = 1.0 + stretchAt(law, Vector(0.5 * (ownPsi + atNeighbors(coverage, k))));
    unsigned char over = static_cast<unsigned char>(bits[k] & greaterBits(current2, limit * limit * length2));
    if (limitsCompression)
      over = static_cast<unsigned char>(over | (bits[k] & greaterBits(shortest * shortest * length2, current2)));
    for (int lane = 0; over != 0; ++lane, over = static_cast<unsigned char>(over >> 1))
      if (over & 1) onBreak(chunk, k, lane);
  }
}

template <int D>
void find(const ChunkedNeighborhood& neighborhood, const AliveBonds& alive, const PointArrays& reference,
          const PointArrays& current, const double* coverage, const CriticalStretchLaw& law,
          const std::function<void(const Chunk&, int, int)>& onBreak) {
  for (const Chunk& chunk : neighborhood.chunks()) {
    const auto search = [&](auto find) {
      find(neighborhood, chunk, alive.of(chunk), reference, current, coverage, law, onBreak);
    };
    if (chunk.isContiguous)
      coverage != nullptr ? search(findInChunk<D, true, true>) : search(findInChunk<D, true, false>);
    else
      coverage != nullptr ? search(findInChunk<D, false, true>) : search(findInChunk<D, false, false>);
  }
}

}  // namespace

double CriticalStretchLaw::at(double psi) const { return stretchAt(*this, std::clamp(psi, 0.0, 1.0)); }

void findOverstretchedBonds(const ChunkedNeighborhood& neighborhood, const AliveBonds& alive, int dimension,
                            const PointArrays& reference, const PointArrays& current, const double* coverage,
                            const CriticalStretchLaw& law, const std::function<void(const Chunk&, int, int)>& onBreak) {
  if (dimension == 1)
    find<1>(neighborhood, alive, reference, current, coverage, law, onBreak);
  else if (dimension == 2)
    find<2>(neighborhood, alive, reference, current, coverage, law, onBreak);
  else
    find<3>(neighborhood, alive, reference, current, coverage, law, onBreak);
}

}  // namespace pd::kernels
