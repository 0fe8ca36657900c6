// Vectors of doubles as wide as the processor has them, and the few operations that bond loops need beyond arithmetic.
#ifndef PD_SIMD_HPP
#define PD_SIMD_HPP

#include <cmath>
#include <cstddef>
#include <experimental/simd>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace pd::kernels {

namespace stdx = std::experimental;

using Vector = stdx::native_simd<double>;
using Mask = Vector::mask_type;

/// Lanes of a vector: the number of points that a chunk of a neighbourhood holds.
inline constexpr int lanes = static_cast<int>(Vector::size());

inline Vector load(const double* values) { return Vector(values, stdx::element_aligned); }
inline void store(const Vector& vector, double* values) { vector.copy_to(values, stdx::element_aligned); }
inline Vector gather(const double* values, const int* indices) {
  return Vector([&](auto lane) { return values[indices[lane]]; });
}

/// 1/sqrt(x) to round-off for normal x > 0. With AVX-512 from the 14-bit estimate and two Newton steps, which costs a
/// third of a square root and a division.
inline Vector inverseSquareRoot(const Vector& x) {
#ifdef __AVX512F__
  if constexpr (lanes == 8) {
    Vector y(_mm512_maskz_rsqrt14_pd(0xff, static_cast<__m512d>(x)));
    const Vector half = 0.5 * x;
    y = y * (1.5 - half * y * y);
    y = y * (1.5 - half * y * y);
    return y;
  }
#endif
  return 1.0 / stdx::sqrt(x);
}
inline Vector squareRoot(const Vector& x) {
#ifdef __AVX512F__
  if constexpr (lanes == 8) return Vector(_mm512_maskz_sqrt_pd(0xff, static_cast<__m512d>(x)));
#endif
  return stdx::sqrt(x);
}
inline double squareRoot(double x) { return std::sqrt(x); }
inline double inverseSquareRoot(double x) { return 1.0 / std::sqrt(x); }

/// `vector` where the bit of a lane is set, 0 elsewhere.
inline Vector keep(const Vector& vector, unsigned char bits) {
#ifdef __AVX512F__
  if constexpr (lanes == 8) return Vector(_mm512_maskz_mov_pd(bits, static_cast<__m512d>(vector)));
#endif
  return Vector([&](auto lane) { return (bits >> lane) & 1 ? static_cast<double>(vector[lane]) : 0.0; });
}

/// Bits of the lanes where a > b.
inline unsigned char greaterBits(const Vector& a, const Vector& b) {
#ifdef __AVX512F__
  if constexpr (lanes == 8) return _mm512_cmp_pd_mask(static_cast<__m512d>(a), static_cast<__m512d>(b), _CMP_GT_OQ);
#endif
  unsigned char bits = 0;
  for (int lane = 0; lane < lanes; ++lane)
    if (a[static_cast<std::size_t>(lane)] > b[static_cast<std::size_t>(lane)])
      bits = static_cast<unsigned char>(bits | (1u << lane));
  return bits;
}

inline constexpr unsigned char allLanes = static_cast<unsigned char>((1u << lanes) - 1u);

}  // namespace pd::kernels

#endif
