#include "stretch_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace pd::kernels {

namespace {

template <class Scalar>
PD_EACH_BOND Scalar stretchAt(const CriticalStretchLaw& law, const Scalar& psi) {
  using std::max;
  const auto& p = law.polynomial;
  const Scalar value = p[0] + psi * (p[1] + psi * (p[2] + psi * p[3]));
  const Scalar factor = max(value, Scalar(0.0));
  return law.stretch * (law.scalesEnergy ? squareRoot(factor) : factor);
}

/// Squares of the lengths of the k-th bonds of a chunk's lanes, of today's and of those at which they break.
struct BondLengths {
  Vector current2, longest2, shortest2;
};

template <int D, bool isContiguous, bool hasCoverage>
class ChunkLengths {
 public:
  ChunkLengths(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, const StretchFields& fields,
               const CriticalStretchLaw& law)
      : indices_(isContiguous ? neighborhood.offsets(chunk) : neighborhood.neighborIds(chunk)), law_(law) {
    const int* points = neighborhood.pointIds(chunk);
    const int first = isContiguous ? chunk.firstPoint : 0;
    const auto own = [&](const double* values) { return isContiguous ? load(values) : gather(values, points); };
    for (int d = 0; d < D; ++d) {
      reference_[d] = fields.reference[d] + first;
      current_[d] = fields.current[d] + first;
      x_[d] = own(reference_[d]);
      y_[d] = own(current_[d]);
    }
    if constexpr (hasCoverage) {
      coverage_ = (*fields.coverage)[0] + first;
      psi_ = own(coverage_);
    }
    longestShare2_ = (1.0 + law.at(0.0)) * (1.0 + law.at(0.0));
    shortestShare2_ = std::pow(1.0 - std::min(law.compressiveStretch, 1.0), 2);
  }
  PD_EACH_BOND BondLengths operator()(int k) const {
    Vector reference2 = 0.0, current2 = 0.0;
    for (int d = 0; d < D; ++d) {
      const Vector xi = atNeighbors(reference_[d], k) - x_[d], y = atNeighbors(current_[d], k) - y_[d];
      reference2 += xi * xi;
      current2 += y * y;
    }
    if constexpr (!hasCoverage) return {current2, longestShare2_ * reference2, shortestShare2_ * reference2};
    const Vector longest = 1.0 + stretchAt(law_, Vector(0.5 * (psi_ + atNeighbors(coverage_, k))));
    return {current2, longest * longest * reference2, shortestShare2_ * reference2};
  }

 private:
  PD_EACH_BOND Vector atNeighbors(const double* values, int k) const {
    return isContiguous ? load(values + indices_[k]) : gather(values, indices_ + k * lanes);
  }
  const int* indices_;
  const CriticalStretchLaw& law_;
  const double *reference_[D], *current_[D], *coverage_ = nullptr;
  Vector x_[D], y_[D], psi_ = 0.0;
  double longestShare2_, shortestShare2_;
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

/// Reports the bonds of a chunk that break, and returns its slack.
template <bool limitsCompression, class Lengths, class OnBreak>
double testChunk(const Chunk& chunk, const unsigned char* bits, const Lengths& lengthsOf, const OnBreak& onBreak) {
  constexpr double endless = std::numeric_limits<double>::max();
  Vector room2 = endless, longest2 = 0.0;
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    const BondLengths bond = lengthsOf(k);
    Vector room = bond.longest2 - bond.current2;
    if constexpr (limitsCompression) room = min(room, bond.current2 - bond.shortest2);
    const unsigned char isOver = bits[k] & greaterBits(Vector(0.0), room);
    room2 = min(room2, choose(room, endless, bits[k]));
    longest2 = max(longest2, bond.longest2);
    for (int lane = 0, over = isOver; over != 0; ++lane, over >>= 1)
      if (over & 1) onBreak(chunk, k, lane);
  }
  // a - b = (a^2 - b^2)/(a + b), with no length beyond the longest.
  return 0.5 * stdx::hmin(room2) / std::sqrt(stdx::hmax(longest2));
}

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
                            const std::vector<std::size_t>* only, std::vector<double>* slack) {
  const bool limitsCompression = std::isfinite(law.compressiveStretch);
  const auto& chunks = neighborhood.chunks();
  if (slack != nullptr) slack->resize(chunks.size());
  withDimension(fields.dimension, [&](auto dimension) {
    const std::size_t count = only == nullptr ? chunks.size() : only->size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t c = only == nullptr ? i : (*only)[i];
      const unsigned char* bits = alive.of(chunks[c]);
      withLengthsOf<decltype(dimension)::value>(neighborhood, chunks[c], fields, law, [&](const auto& lengthsOf) {
        const double room = limitsCompression ? testChunk<true>(chunks[c], bits, lengthsOf, onBreak)
                                              : testChunk<false>(chunks[c], bits, lengthsOf, onBreak);
        if (slack != nullptr) (*slack)[c] = room;
      });
    }
  });
}

}  // namespace pd::kernels
