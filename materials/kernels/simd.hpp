// Vectors of doubles as wide as the processor has them, and the few operations that bond loops need beyond arithmetic.
#ifndef PD_SIMD_HPP
#define PD_SIMD_HPP

#include <cmath>
#include <cstddef>
#include <experimental/simd>
#include <utility>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

/// For what runs once a bond: a call would pass vectors through memory. The compiler's own estimate is too shy here.
#define PD_EACH_BOND [[gnu::always_inline]] inline
/// The same for lambdas, behind their parameters.
#define PD_INLINED __attribute__((always_inline))

namespace pd::kernels {

namespace stdx = std::experimental;

using Vector = stdx::native_simd<double>;
using Mask = Vector::mask_type;

/// Lanes of a vector: the number of points that a chunk of a neighbourhood holds.
inline constexpr int lanes = static_cast<int>(Vector::size());
#ifdef PD_LANES
static_assert(lanes == PD_LANES, "the installed library was compiled for another processor (see PD_ARCH)");
#endif

inline Vector load(const double* values) { return Vector(values, stdx::element_aligned); }
inline void store(const Vector& vector, double* values) { vector.copy_to(values, stdx::element_aligned); }
inline Vector gather(const double* values, const int* indices) {
  return Vector([&](auto lane) { return values[indices[lane]]; });
}

/// 1/sqrt(x) to round-off for normal x > 0. With AVX-512 from an estimate y to 14 bits: 1/sqrt(x) = y/sqrt(1 - e) with
/// e = 1 - x y^2 < 2^-13, by four terms of the series. A third of the cost of a square root and a division.
inline Vector inverseSquareRoot(const Vector& x) {
#ifdef __AVX512F__
  if constexpr (lanes == 8) {
    const Vector y(_mm512_maskz_rsqrt14_pd(0xff, static_cast<__m512d>(x)));
    const Vector e = 1.0 - (x * y) * y;
    return y + (y * e) * (0.5 + e * (0.375 + 0.3125 * e));
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
/// The next integer that is not below.
inline Vector ceiling(const Vector& x) {
#ifdef __AVX512F__
  if constexpr (lanes == 8)
    return Vector(_mm512_maskz_roundscale_pd(0xff, static_cast<__m512d>(x), _MM_FROUND_TO_POS_INF));
#endif
  return stdx::ceil(x);
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

/// `vector` where the bit of a lane is set, `other` elsewhere.
inline Vector choose(const Vector& vector, const Vector& other, unsigned char bits) {
#ifdef __AVX512F__
  if constexpr (lanes == 8)
    return Vector(_mm512_mask_mov_pd(static_cast<__m512d>(other), bits, static_cast<__m512d>(vector)));
#endif
  return Vector([&](auto lane) { return static_cast<double>((bits >> lane) & 1 ? vector[lane] : other[lane]); });
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

/// `vector` where x > 0, `other` elsewhere and where x is not a number. In place of stdx::where(), which Clang 14 with
/// AVX-512 makes assign nothing.
inline Vector wherePositive(const Vector& x, const Vector& vector, const Vector& other) {
  return choose(vector, other, greaterBits(x, Vector(0.0)));
}

/// visit(0), ..., visit(n - 1) with constants that index arrays: a loop, even a short one, keeps arrays of vectors in
/// memory.
template <class Visit, int... i>
PD_EACH_BOND void unrolled(std::integer_sequence<int, i...>, const Visit& visit) {
  (visit(std::integral_constant<int, i>()), ...);
}
template <int n, class Visit>
PD_EACH_BOND void unrolled(const Visit& visit) {
  unrolled(std::make_integer_sequence<int, n>(), visit);
}

#ifdef __AVX512F__
/// r[l]: four values of lane l, then four of lane l + 4. Becomes one vector a value; done twice, it is what it was.
PD_EACH_BOND void transposeFour(__m512d (&r)[4]) {
  const __m512d low01 = __builtin_shufflevector(r[0], r[1], 0, 8, 2, 10, 4, 12, 6, 14);
  const __m512d high01 = __builtin_shufflevector(r[0], r[1], 1, 9, 3, 11, 5, 13, 7, 15);
  const __m512d low23 = __builtin_shufflevector(r[2], r[3], 0, 8, 2, 10, 4, 12, 6, 14);
  const __m512d high23 = __builtin_shufflevector(r[2], r[3], 1, 9, 3, 11, 5, 13, 7, 15);
  r[0] = __builtin_shufflevector(low01, low23, 0, 1, 8, 9, 4, 5, 12, 13);
  r[1] = __builtin_shufflevector(high01, high23, 0, 1, 8, 9, 4, 5, 12, 13);
  r[2] = __builtin_shufflevector(low01, low23, 2, 3, 10, 11, 6, 7, 14, 15);
  r[3] = __builtin_shufflevector(high01, high23, 2, 3, 10, 11, 6, 7, 14, 15);
}
#endif

/// out[c] = values[width * indices[lane] + c] for c < 4: four neighbouring values of each point, by as many loads as
/// one value would take.
template <int width>
PD_EACH_BOND void gatherFour(const double* values, const int* indices, Vector* out) {
#ifdef __AVX512F__
  if constexpr (lanes == 8) {
    const auto row = [&](int lane) { return _mm256_loadu_pd(values + width * std::ptrdiff_t(indices[lane])); };
    __m512d r[4];
    unrolled<4>([&](auto l) PD_INLINED { r[l] = __builtin_shufflevector(row(l), row(l + 4), 0, 1, 2, 3, 4, 5, 6, 7); });
    transposeFour(r);
    unrolled<4>([&](auto c) PD_INLINED { out[c] = Vector(r[c]); });
    return;
  }
#endif
  for (int c = 0; c < 4; ++c)
    out[c] = Vector([&](auto lane) { return values[width * std::ptrdiff_t(indices[lane]) + c]; });
}

/// values[width * indices[lane] + c] += in[c] for c < 4, lane after lane.
template <int width>
PD_EACH_BOND void scatterAddFour(const Vector* in, const int* indices, double* values) {
#ifdef __AVX512F__
  if constexpr (lanes == 8) {
    __m512d r[4];
    unrolled<4>([&](auto c) PD_INLINED { r[c] = static_cast<__m512d>(in[c]); });
    transposeFour(r);
    const auto add = [&](int lane, __m256d row) {
      double* at = values + width * std::ptrdiff_t(indices[lane]);
      _mm256_storeu_pd(at, _mm256_add_pd(_mm256_loadu_pd(at), row));
    };
    unrolled<4>([&](auto l) PD_INLINED {
      add(l, __builtin_shufflevector(r[l], r[l], 0, 1, 2, 3));
      add(l + 4, __builtin_shufflevector(r[l], r[l], 4, 5, 6, 7));
    });
    return;
  }
#endif
  for (int lane = 0; lane < lanes; ++lane)
    for (int c = 0; c < 4; ++c)
      values[width * std::ptrdiff_t(indices[lane]) + c] += in[c][static_cast<std::size_t>(lane)];
}

/// Calls visit(dimension) with the integral constant 1, 2 or 3.
template <class Visit>
void withDimension(int dimension, const Visit& visit) {
  if (dimension == 1)
    visit(std::integral_constant<int, 1>());
  else if (dimension == 2)
    visit(std::integral_constant<int, 2>());
  else
    visit(std::integral_constant<int, 3>());
}

inline constexpr unsigned char allLanes = static_cast<unsigned char>((1u << lanes) - 1u);

}  // namespace pd::kernels

#endif
