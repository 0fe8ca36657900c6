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

/// Where the bonds of a chunk come from.
enum class Bonds { Uniform, Contiguous, Gathered };

/// The lengths of a chunk's bonds. In uniform chunks the reference lengths are those of the constants, which the two
/// ends of a bond may have rounded apart: limits are taken closer by more than that, and exactly() decides.
template <int D, Bonds kind, bool hasCoverage>
class ChunkLengths {
 public:
  static constexpr bool isUniform = kind == Bonds::Uniform;

  ChunkLengths(const ChunkedNeighborhood& neighborhood, std::size_t c, const StretchFields& fields,
               const CriticalStretchLaw& law)
      : law_(law) {
    const Chunk& chunk = neighborhood.chunks()[c];
    indices_ = isGathered ? neighborhood.neighborIds(chunk) : neighborhood.offsets(chunk);
    if constexpr (isUniform) reference2_ = fields.reference2.of(c);
    const int* points = neighborhood.pointIds(chunk);
    const int first = isGathered ? 0 : chunk.firstPoint;
    const auto own = [&](const double* values) { return isGathered ? gather(values, points) : load(values); };
    for (int d = 0; d < D; ++d) {
      reference_[d] = fields.reference[d] + first;
      current_[d] = fields.current[d] + first;
      if constexpr (!isUniform) x_[d] = own(reference_[d]);
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
    if constexpr (isUniform)
      return lengths(k, (1.0 - rounding) * reference2_[k], (1.0 + rounding) * reference2_[k]);
    else
      return exactly(k);
  }
  PD_EACH_BOND BondLengths exactly(int k) const {
    Vector reference2 = 0.0;
    unrolled<D>([&](auto d) PD_INLINED {
      const Vector xi = atNeighbors(reference_[d], k) - (isUniform ? load(reference_[d]) : x_[d]);
      reference2 += xi * xi;
    });
    return lengths(k, reference2, reference2);
  }

 private:
  static constexpr bool isGathered = kind == Bonds::Gathered;
  static constexpr double rounding = 1e-10;  ///< beyond the tolerance of the constants

  template <class Scalar>
  PD_EACH_BOND BondLengths lengths(int k, const Scalar& low, const Scalar& high) const {
    Vector current2 = 0.0;
    unrolled<D>([&](auto d) PD_INLINED {
      const Vector y = atNeighbors(current_[d], k) - y_[d];
      current2 += y * y;
    });
    if constexpr (!hasCoverage) return {current2, Vector(longestShare2_ * low), Vector(shortestShare2_ * high)};
    const Vector longest = 1.0 + stretchAt(law_, Vector(0.5 * (psi_ + atNeighbors(coverage_, k))));
    return {current2, longest * longest * low, Vector(shortestShare2_ * high)};
  }
  PD_EACH_BOND Vector atNeighbors(const double* values, int k) const {
    return isGathered ? gather(values, indices_ + k * lanes) : load(values + indices_[k]);
  }
  const int* indices_ = nullptr;
  const double* reference2_ = nullptr;
  const CriticalStretchLaw& law_;
  const double *reference_[D], *current_[D], *coverage_ = nullptr;
  Vector x_[D], y_[D], psi_ = 0.0;
  double longestShare2_, shortestShare2_;
};

/// Calls visit(lengths of the chunk's bonds) with the type that fits chunk and fields.
template <int D, class Visit>
void withLengthsOf(const ChunkedNeighborhood& neighborhood, std::size_t c, const StretchFields& fields,
                   const CriticalStretchLaw& law, const Visit& visit) {
  const auto call = [&](auto kind) {
    if (fields.coverage != nullptr)
      visit(ChunkLengths<D, decltype(kind)::value, true>(neighborhood, c, fields, law));
    else
      visit(ChunkLengths<D, decltype(kind)::value, false>(neighborhood, c, fields, law));
  };
  if (fields.reference2.isUniform(c))
    call(std::integral_constant<Bonds, Bonds::Uniform>());
  else if (neighborhood.chunks()[c].isContiguous)
    call(std::integral_constant<Bonds, Bonds::Contiguous>());
  else
    call(std::integral_constant<Bonds, Bonds::Gathered>());
}

/// How far bonds are from breaking, in squares of lengths.
template <bool limitsCompression>
PD_EACH_BOND Vector roomOf(const BondLengths& bond) {
  const Vector room = bond.longest2 - bond.current2;
  if constexpr (limitsCompression) return min(room, Vector(bond.current2 - bond.shortest2));
  return room;
}

/// Reports the bonds of a chunk that break, and returns its slack: negative then, since a host may undo the breakage
/// and ask again.
template <bool limitsCompression, class Lengths, class OnBreak>
double testChunk(const Chunk& chunk, const unsigned char* bits, const Lengths& lengthsOf, const OnBreak& onBreak) {
  constexpr double endless = std::numeric_limits<double>::max();
  Vector room2 = endless, longest2 = 0.0;
  for (int k = 0; k < chunk.nNeighbors; ++k) {
    const unsigned char unbroken = bits[k];
    if (unbroken == 0) continue;
    const BondLengths bond = lengthsOf(k);
    const Vector room = roomOf<limitsCompression>(bond);
    longest2 = max(longest2, bond.longest2);
    unsigned char isOver = unbroken & greaterBits(Vector(0.0), room);
    if (isOver != 0) {
      if constexpr (Lengths::isUniform)
        isOver = unbroken & greaterBits(Vector(0.0), roomOf<limitsCompression>(lengthsOf.exactly(k)));
      if (isOver != 0) onBreak(chunk, k, isOver);
    }
    room2 = min(room2, choose(room, endless, unbroken));
  }
  // a - b = (a^2 - b^2)/(a + b), with no length beyond the longest.
  const double longest = stdx::hmax(longest2);
  return longest > 0.0 ? 0.5 * stdx::hmin(room2) / std::sqrt(longest) : endless;
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
                            const std::function<void(const Chunk&, int, unsigned char)>& onBreak,
                            const std::vector<std::size_t>* only, std::vector<double>* slack) {
  const bool limitsCompression = std::isfinite(law.compressiveStretch);
  const auto& chunks = neighborhood.chunks();
  if (slack != nullptr) slack->resize(chunks.size());
  withDimension(fields.dimension, [&](auto dimension) {
    const std::size_t count = only == nullptr ? chunks.size() : only->size();
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t c = only == nullptr ? i : (*only)[i];
      const unsigned char* bits = alive.of(chunks[c]);
      withLengthsOf<decltype(dimension)::value>(neighborhood, c, fields, law, [&](const auto& lengthsOf) {
        const double room = limitsCompression ? testChunk<true>(chunks[c], bits, lengthsOf, onBreak)
                                              : testChunk<false>(chunks[c], bits, lengthsOf, onBreak);
        if (slack != nullptr) (*slack)[c] = room;
      });
    }
  });
}

}  // namespace pd::kernels
