#include "alive_bonds.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#ifdef __BMI2__
#include <immintrin.h>
#endif

namespace pd::kernels {

namespace {

static_assert(lanes <= 8, "one bit a lane in a byte");

/// Bit j of byte i becomes bit i of byte j (Warren, Hacker's Delight, 2nd ed. 2012, section 7-3).
std::uint64_t transposed(std::uint64_t x) {
  const auto exchange = [&](int shift, std::uint64_t mask) {
    const std::uint64_t differing = (x ^ (x >> shift)) & mask;
    x ^= differing ^ (differing << shift);
  };
  exchange(7, 0x00aa00aa00aa00aaULL);
  exchange(14, 0x0000cccc0000ccccULL);
  exchange(28, 0x00000000f0f0f0f0ULL);
  return x;
}

/// The lowest bits of `bits`, in order, at the places of the ones of `mask`.
unsigned deposit(unsigned bits, unsigned mask) {
#ifdef __BMI2__
  return _pdep_u32(bits, mask);
#else
  unsigned result = 0;
  for (; mask != 0; mask &= mask - 1u, bits >>= 1)
    if ((bits & 1u) != 0) result |= mask & (~mask + 1u);
  return result;
#endif
}

/// Bits of the `count` <= 8 bonds whose damage is below 1; `isWhole` becomes false where one is damaged in part.
unsigned unbrokenBits(const double* damage, int count, bool& isWhole) {
  unsigned bits = 0;
#ifdef __AVX512F__
  const auto used = static_cast<__mmask8>((1u << count) - 1u);
  const __m512d values = _mm512_maskz_loadu_pd(used, damage);
  bits = _mm512_mask_cmp_pd_mask(used, values, _mm512_set1_pd(1.0), _CMP_LT_OQ);
  const unsigned zero = _mm512_mask_cmp_pd_mask(used, values, _mm512_setzero_pd(), _CMP_EQ_OQ);
  const unsigned one = _mm512_mask_cmp_pd_mask(used, values, _mm512_set1_pd(1.0), _CMP_EQ_OQ);
  if ((zero | one) != used) isWhole = false;
#else
  for (int k = 0; k < count; ++k) {
    if (damage[k] < 1.0) bits |= 1u << k;
    if (damage[k] != 0.0 && damage[k] != 1.0) isWhole = false;
  }
#endif
  return bits;
}

}  // namespace

AliveBonds::AliveBonds(const ChunkedNeighborhood& neighborhood) {
  bits_.reserve(neighborhood.nEntries());
  for (const Chunk& chunk : neighborhood.chunks()) {
    const unsigned char* present = neighborhood.present(chunk);
    bits_.insert(bits_.end(), present, present + chunk.nNeighbors);
    seen_.resize(chunk.points + lanes, 0.0);
  }
}

void AliveBonds::forget() { std::fill(seen_.begin(), seen_.end(), std::numeric_limits<double>::quiet_NaN()); }

bool AliveBonds::refresh(const ChunkedNeighborhood& neighborhood, const double* bondDamage, const double* damage) {
  bool isWhole = true;
  for (const Chunk& chunk : neighborhood.chunks()) {
    const int* points = neighborhood.pointIds(chunk);
    unsigned changed = (1u << chunk.nLanes) - 1u;
    for (int lane = 0; damage != nullptr && lane < chunk.nLanes; ++lane) {
      double& seen = seen_[chunk.points + static_cast<std::size_t>(lane)];
      if (damage[points[lane]] == seen) changed &= ~(1u << lane);
      seen = damage[points[lane]];
    }
    if (changed != 0) isWhole = refreshLanes(neighborhood, chunk, changed, bondDamage) && isWhole;
  }
  return isWhole;
}

bool AliveBonds::refreshLanes(const ChunkedNeighborhood& neighborhood, const Chunk& chunk, unsigned changed,
                              const double* bondDamage) {
  bool isWhole = true;
  const double* next[8] = {};
  for (int lane = 0; lane < chunk.nLanes; ++lane) next[lane] = bondDamage + neighborhood.firstBond(chunk, lane);
  const unsigned char* present = neighborhood.present(chunk);
  unsigned char* bits = of(chunk);
  for (int first = 0; first < chunk.nNeighbors; first += 8) {
    const std::size_t count = static_cast<std::size_t>(std::min(8, chunk.nNeighbors - first));
    // Bytes of entries, with a bit for each lane, and bytes of lanes, with a bit for each entry.
    std::uint64_t presentEntries = 0, unbrokenEntries = 0;
    std::memcpy(&presentEntries, present + first, count);
    std::memcpy(&unbrokenEntries, bits + first, count);
    const std::uint64_t presentLanes = transposed(presentEntries);
    std::uint64_t unbrokenLanes = transposed(unbrokenEntries);
    for (int lane = 0; lane < chunk.nLanes; ++lane) {
      if (((changed >> lane) & 1u) == 0) continue;
      const int shift = 8 * lane;
      const auto has = static_cast<unsigned>(presentLanes >> shift) & 0xffu;
      const int nBonds = __builtin_popcount(has);
      const std::uint64_t unbroken = deposit(unbrokenBits(next[lane], nBonds, isWhole), has);
      unbrokenLanes = (unbrokenLanes & ~(std::uint64_t(0xff) << shift)) | (unbroken << shift);
      next[lane] += nBonds;
    }
    unbrokenEntries = transposed(unbrokenLanes);
    std::memcpy(bits + first, &unbrokenEntries, count);
  }
  return isWhole;
}

}  // namespace pd::kernels
