// Middles of equal parts of a line, as many as a vector of the processor has lanes at once, a bit each.
#ifndef PD_MIDDLES_PER_LANE_HPP
#define PD_MIDDLES_PER_LANE_HPP

#include <bitset>
#include <cstdint>

#include "simd.hpp"

namespace pd::decomposition {

constexpr int mostMiddles = 64;  ///< of a line

/// For each lane some of the middles.
struct MiddlesPerLane {
  alignas(sizeof(kernels::Vector)) std::uint64_t bits[kernels::lanes] = {};
};

/// Adds those from `low` to before `high`, whole numbers from 0 to mostMiddles.
PD_EACH_BOND void addMiddles(const kernels::Vector& low, const kernels::Vector& high, MiddlesPerLane& middles) {
#ifdef __AVX512DQ__
  if constexpr (kernels::lanes == 8) {
    const __m512i all = _mm512_set1_epi64(-1);  // shifted by 64 it is 0
    const __m512i from = _mm512_maskz_cvtpd_epi64(0xff, static_cast<__m512d>(low)),
                  beyond = _mm512_maskz_cvtpd_epi64(0xff, static_cast<__m512d>(mostMiddles - high));
    const __m512i range =
        _mm512_and_epi64(_mm512_maskz_sllv_epi64(0xff, all, from), _mm512_maskz_srlv_epi64(0xff, all, beyond));
    _mm512_store_epi64(middles.bits, _mm512_or_epi64(_mm512_load_epi64(middles.bits), range));
    return;
  }
#endif
  constexpr std::uint64_t all = ~std::uint64_t{0};
  for (std::size_t lane = 0; lane < static_cast<std::size_t>(kernels::lanes); ++lane)
    if (low[lane] < high[lane])
      middles.bits[lane] |= all << static_cast<int>(low[lane]) & all >> (mostMiddles - static_cast<int>(high[lane]));
}

/// How many each lane has.
PD_EACH_BOND kernels::Vector numberOf(const MiddlesPerLane& middles) {
  return kernels::Vector(
      [&](auto lane) { return static_cast<double>(std::bitset<mostMiddles>(middles.bits[lane]).count()); });
}

}  // namespace pd::decomposition

#endif
