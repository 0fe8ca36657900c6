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

/// Squared lengths of the k-th bonds of a chunk's lanes, and the largest stretch they may have.
struct BondLengths {
  Vector reference2, current2, limit;
};

template <int D, bool isContiguous, bool hasCoverage>
class ChunkLengths {
 public:
  ChunkLengths(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, const StretchFields& fields,
               const CriticalStretchLaw& law)
      : chunk_(chunk),
        indices_(isContiguous ? neighborhood.offsets(chunk) : neighborhood.neighborIds(chunk)),
        fields_(fields),
        law_(law) {
    const int* points = neighborhood.pointIds(chunk);
    const auto atPoints = [&](const double* values) {
      return isContiguous ? load(values + chunk.firstPoint) : gather(values, points);
    };
    for (int d = 0; d < D; ++d) {
      x_[d] = atPoints(fields.reference[d]);
      y_[d] = atPoints(fields.current[d]);
    }
    if constexpr (hasCoverage) psi_ = atPoints(fields.coverage);
    limit_ = 1.0 + stretchAt(law, 0.0);
  }
  BondLengths operator()(int k) const {
    BondLengths bond{0.0, 0.0, limit_};
    for (int d = 0; d < D; ++d) {
      const Vector xi = atNeighbors(fields_.reference[d], k) - x_[d], y = atNeighbors(fields_.current[d], k) - y_[d];
      bond.reference2 += xi * xi;
      bond.current2 += y * y;
    }
    if constexpr (hasCoverage)
      bond.limit = 1.0 + stretchAt(law_, Vector(0.5 * (psi_ + atNeighbors(fields_.coverage, k))));
    return bond;
  }

 private:
  Vector atNeighbors(const double* values, int k) const {
    return isContiguous ? load(values + chunk_.firstPoint + indices_[k]) : gather(values, indices_ + k * lanes);
  }
  const Chunk& chunk_;
  const int* indices_;
  const StretchFields& fields_;
  const CriticalStretchLaw& law_;
  Vector x_[D], y_[D], psi_ = 0.0, limit_;
};

/// Calls visit(lengths of the chunk's bonds) with the type that fits chunk and fields.
template <int D, class Visit>
void withLengthsOf(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, const StretchFields& fields,
                   const CriticalStretchLaw& law, Visit visit) {
  const bool hasCoverage = fields.coverage != nullptr;
  if (chunk.isContiguous && hasCoverage)
    visit(ChunkLengths<D, true, true>(neighborhood, chunk, fields, law));
  else if (chunk.isContiguous)
    visit(ChunkLengths<D, true, false>(neighborhood, chunk, fields, law));
  else if (hasCoverage)
    visit(ChunkLengths<D, false, true>(neighborhood, chunk, fields, law));
  else
    visit(ChunkLengths<D, false, false>(neighborhood, chunk, fields, law));
}

template <class Visit>
void withDimension(int dimension, Visit visit) {
  if (dimension == 1)
    visit(std::integral_constant<int, 1>());
  else if (dimension == 2)
    visit(std::integral_constant<int, 2>());
  else
    visit(std::integral_constant<int, 3>());
}

double shortestShare(const CriticalStretchLaw& law) { return 1.0 - std::min(law.compressiveStretch, 1.0); }

}  // namespace

double CriticalStretchLaw::at(double psi) const { return stretchAt(*this, std::clamp(psi, 0.0, 1.0)); }

double CriticalStretchLaw::steepest() const {
  const auto& p = polynomial;
  const double slope = std::abs(p[1]) + 2.0 * std::abs(p[2]) + 3.0 * std::abs(p[3]);
  if (!scalesEnergy) return stretch * slope;
  constexpr int samples = 1000;
  double lowest = p[0];
  for (int i = 0; i <= samples; ++i) {
    const double psi = static_cast<double>(i) / samples;
    lowest = std::min(lowest, p[0] + psi * (p[1] + psi * (p[2] + psi * p[3])));
  }
  lowest -= slope / samples;
  return lowest > 0.0 ? 0.5 * stretch * slope / std::sqrt(lowest) : std::numeric_limits<double>::infinity();
}

void findOverstretchedBonds(const ChunkedNeighborhood& neighborhood, const AliveBonds& alive,
                            const StretchFields& fields, const CriticalStretchLaw& law,
                            const std::function<void(const Chunk&, int, int)>& onBreak,
                            const std::vector<std::size_t>* only) {
  const bool limitsCompression = std::isfinite(law.compressiveStretch);
  const double shortest2 = shortestShare(law) * shortestShare(law);
  const auto& chunks = neighborhood.chunks();
  withDimension(fields.dimension, [&](auto dimension) {
    const std::size_t count = only == nullptr ? chunks.size() : only->size();
    for (std::size_t c = 0; c < count; ++c) {
      const Chunk& chunk = chunks[only == nullptr ? c : (*only)[c]];
      const unsigned char* bits = alive.of(chunk);
      withLengthsOf<decltype(dimension)::value>(neighborhood, chunk, fields, law, [&](const auto& lengthsOf) {
        for (int k = 0; k < chunk.nNeighbors; ++k) {
          if (bits[k] == 0) continue;
          const BondLengths bond = lengthsOf(k);
          unsigned over = bits[k] & greaterBits(bond.current2, bond.limit * bond.limit * bond.reference2);
          if (limitsCompression) over |= bits[k] & greaterBits(shortest2 * bond.reference2, bond.current2);
          for (int lane = 0; over != 0; ++lane, over >>= 1)
            if (over & 1u) onBreak(chunk, k, lane);
        }
      });
    }
  });
}

std::vector<double> slackOfChunks(const ChunkedNeighborhood& neighborhood, const AliveBonds& alive,
                                  const StretchFields& fields, const CriticalStretchLaw& law) {
  constexpr double endless = std::numeric_limits<double>::max();
  const bool limitsCompression = std::isfinite(law.compressiveStretch);
  const double shortest = shortestShare(law);
  std::vector<double> slack;
  slack.reserve(neighborhood.chunks().size());
  withDimension(fields.dimension, [&](auto dimension) {
    for (const Chunk& chunk : neighborhood.chunks()) {
      const unsigned char* bits = alive.of(chunk);
      Vector smallest = endless;
      withLengthsOf<decltype(dimension)::value>(neighborhood, chunk, fields, law, [&](const auto& lengthsOf) {
        for (int k = 0; k < chunk.nNeighbors; ++k) {
          if (bits[k] == 0) continue;
          const BondLengths bond = lengthsOf(k);
          const Vector reference = squareRoot(bond.reference2), current = squareRoot(bond.current2);
          Vector room = bond.limit * reference - current;
          if (limitsCompression) room = min(room, current - shortest * reference);
          // Broken bonds have no limit.
          smallest = min(smallest, keep(room, bits[k]) + keep(endless, static_cast<unsigned char>(~bits[k])));
        }
      });
      slack.push_back(stdx::hmin(smallest));
    }
  });
  return slack;
}

}  // namespace pd::kernels
