#pragma once

// Numbers in lanes, for kernels.cc, which is compiled once for each lane width with the instructions of that width. The
// linker keeps one copy of an inline function for the whole program; a copy with wide instructions would crash on
// machines without them. So everything here is in an unnamed namespace, and kernels.cc includes no header of the
// project that has functions elsewhere.

#include <cstdint>

#if defined(__AVX__) || defined(__SSE2__)
#include <immintrin.h>
#endif

namespace tumble::sim {
namespace {

template <int kWidth>
struct VectorOf {
  typedef double Type __attribute__((vector_size(kWidth * 8)));  // NOLINT(modernize-use-using): GCC wants it so
};
template <>
struct VectorOf<1> {
  using Type = double;
};

inline double square_root(double x) { return __builtin_sqrt(x); }
#ifdef __SSE2__
inline VectorOf<2>::Type square_root(VectorOf<2>::Type x) { return _mm_sqrt_pd(x); }
#else
inline VectorOf<2>::Type square_root(VectorOf<2>::Type x) {
  const VectorOf<2>::Type roots = {__builtin_sqrt(x[0]), __builtin_sqrt(x[1])};
  return roots;
}
#endif
#ifdef __AVX__
inline VectorOf<4>::Type square_root(VectorOf<4>::Type x) { return _mm256_sqrt_pd(x); }
#endif
#ifdef __AVX512F__
inline VectorOf<8>::Type square_root(VectorOf<8>::Type x) { return _mm512_maskz_sqrt_pd(0xff, x); }
#endif

template <class V>
inline V load(const double* from) {
  if constexpr (sizeof(V) == sizeof(double)) return *from;  // GCC copies eight bytes by way of another kind of register
  V v;
  __builtin_memcpy(&v, from, sizeof v);
  return v;
}
inline void store(double* to, double v) { *to = v; }
template <class V>
inline void store(double* to, V v) {
  __builtin_memcpy(to, &v, sizeof v);
}

// std::max and std::min of two numbers, with the sign of zero as well, in which the instructions of processors differ.
template <class V>
inline V larger(V a, V b) {
  return a < b ? b : a;
}
template <class V>
inline V smaller(V a, V b) {
  return b < a ? b : a;
}

template <class V>
inline V magnitude(V a) {
  return a < 0.0 ? -a : a;
}

// std::fabs, with the sign of zero as well.
inline double absolute(double a) { return __builtin_fabs(a); }
template <class V>
inline V absolute(V a) {
  typedef std::int64_t Bits __attribute__((vector_size(sizeof(V))));  // NOLINT(modernize-use-using): GCC wants it so
  return reinterpret_cast<V>(reinterpret_cast<Bits>(a) & INT64_MAX);
}

// power_of_two of src/math/grid.h.
inline double power_of_two(double a) {
  std::uint64_t bits = 0;
  __builtin_memcpy(&bits, &a, sizeof bits);
  bits &= 0x7ff0000000000000ULL;
  __builtin_memcpy(&a, &bits, sizeof a);
  return a;
}
template <class V>
inline V power_of_two(V a) {
  typedef std::int64_t Bits __attribute__((vector_size(sizeof(V))));  // NOLINT(modernize-use-using): GCC wants it so
  return reinterpret_cast<V>(reinterpret_cast<Bits>(a) & 0x7ff0000000000000LL);
}

// 1 / √a within 3.5 %, for a > 0: half the exponent, and a straight line in each octave (Blinn 1997; Lomont 2003).
inline double inverse_root_estimate(double a) {
  std::uint64_t bits = 0;
  __builtin_memcpy(&bits, &a, sizeof bits);
  bits = 0x5fe6eb50c7b537a9ULL - (bits >> 1U);
  __builtin_memcpy(&a, &bits, sizeof a);
  return a;
}
template <class V>
inline V inverse_root_estimate(V a) {
  typedef std::uint64_t Bits __attribute__((vector_size(sizeof(V))));  // NOLINT(modernize-use-using): GCC wants it so
  return reinterpret_cast<V>(0x5fe6eb50c7b537a9ULL - (reinterpret_cast<Bits>(a) >> 1U));
}

// Whether a comparison holds in any lane.
inline bool any(bool holds) { return holds; }
inline bool any(int holds) { return holds != 0; }
template <class Mask>
inline bool any(Mask holds) {
  constexpr int kWidth = sizeof(Mask) / sizeof(std::int64_t);
#ifdef __AVX512DQ__
  if constexpr (kWidth == 8) return _mm512_movepi64_mask(reinterpret_cast<__m512i>(holds)) != 0;
#endif
#ifdef __AVX__
  if constexpr (kWidth == 4) return _mm256_movemask_pd(reinterpret_cast<__m256d>(holds)) != 0;
#endif
  std::int64_t joined = 0;
  for (int k = 0; k < kWidth; ++k) joined |= holds[k];
  return joined != 0;
}

// Whether a comparison holds in all lanes.
inline bool all_of(bool holds) { return holds; }
inline bool all_of(int holds) { return holds != 0; }
template <class Mask>
inline bool all_of(Mask holds) {
  return !any(~holds);
}

// Whether a < b in all lanes; a NaN is not.
inline bool all_below(double a, double b) { return a < b; }
template <class V>
inline bool all_below(V a, V b) {
#ifdef __AVX512F__
  if constexpr (sizeof(V) == 64) return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ) == 0xff;
#endif
  return !any(~(a < b));
}

// Whether a > b in any lane; a NaN is not.
inline bool any_above(double a, double b) { return a > b; }
template <class V>
inline bool any_above(V a, V b) {
#ifdef __AVX512F__
  if constexpr (sizeof(V) == 64) return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ) != 0;
#endif
  return any(a > b);
}

// Whether a and b differ in any lane.
inline bool any_differ(double a, double b) { return a != b; }
template <class V>
inline bool any_differ(V a, V b) {
#ifdef __AVX512F__
  if constexpr (sizeof(V) == 64) return _mm512_cmp_pd_mask(a, b, _CMP_NEQ_UQ) != 0;
#endif
  return any(a != b);
}

// Vectors in space, a number of each lane in each coordinate; sums in the order of src/math/vec.h.
template <class V>
struct Space {
  V x, y, z;
};
template <class V>
inline Space<V> operator+(Space<V> a, Space<V> b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class V>
inline Space<V> operator-(Space<V> a, Space<V> b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class V>
inline Space<V> operator-(Space<V> a) {
  return {-a.x, -a.y, -a.z};
}
template <class V>
inline Space<V> operator*(Space<V> a, V s) {
  return {a.x * s, a.y * s, a.z * s};
}
template <class V>
inline V dot(Space<V> a, Space<V> b) {
  return (a.x * b.x + a.y * b.y) + a.z * b.z;
}
template <class V>
inline Space<V> cross(Space<V> a, Space<V> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace
}  // namespace tumble::sim
