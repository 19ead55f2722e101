#pragma once

// Transposes rows of bodies into lanes and back: lane k holds the row of its own body. lane_vector.h says who may
// include this.

#include <cstddef>
#include <cstdint>

#include "src/kernels/lanes/lane_vector.h"

namespace tumble::sim {
namespace {

constexpr unsigned kFrameDoubles = 15;  // of a BoxFrame: position, three axes, half extents

using Two = VectorOf<2>::Type;

// Gathers four numbers of each row, from `at` on: out[k] holds number at + k of every lane's row.
inline void gather4(const double* rows, unsigned stride, const std::uint32_t* row, unsigned at, double* out) {
  for (unsigned k = 0; k < 4; ++k) out[k] = rows[row[0] * stride + at + k];
}

inline void gather4(const double* rows, unsigned stride, const std::uint32_t* row, unsigned at, Two* out) {
  for (unsigned half = 0; half < 4; half += 2) {
    const Two r0 = load<Two>(rows + row[0] * stride + at + half), r1 = load<Two>(rows + row[1] * stride + at + half);
    out[half] = __builtin_shufflevector(r0, r1, 0, 2);
    out[half + 1] = __builtin_shufflevector(r0, r1, 1, 3);
  }
}

// Stores four numbers of each lane as a row; the rows lie `stride` doubles apart.
inline void scatter4(double* rows, unsigned /*stride*/, const double* v) {
  for (unsigned k = 0; k < 4; ++k) rows[k] = v[k];
}

inline void scatter4(double* rows, unsigned stride, const Two* v) {
  for (unsigned half = 0; half < 4; half += 2) {
    store(rows + half, __builtin_shufflevector(v[half], v[half + 1], 0, 2));
    store(rows + stride + half, __builtin_shufflevector(v[half], v[half + 1], 1, 3));
  }
}

#ifdef __AVX2__
using Four = VectorOf<4>::Type;

inline void transpose(Four& r0, Four& r1, Four& r2, Four& r3) {
  const Four t0 = __builtin_shufflevector(r0, r1, 0, 4, 2, 6), t1 = __builtin_shufflevector(r0, r1, 1, 5, 3, 7);
  const Four t2 = __builtin_shufflevector(r2, r3, 0, 4, 2, 6), t3 = __builtin_shufflevector(r2, r3, 1, 5, 3, 7);
  r0 = __builtin_shufflevector(t0, t2, 0, 1, 4, 5);
  r1 = __builtin_shufflevector(t1, t3, 0, 1, 4, 5);
  r2 = __builtin_shufflevector(t0, t2, 2, 3, 6, 7);
  r3 = __builtin_shufflevector(t1, t3, 2, 3, 6, 7);
}

inline void gather4(const double* rows, unsigned stride, const std::uint32_t* row, unsigned at, Four* out) {
  for (unsigned k = 0; k < 4; ++k) out[k] = load<Four>(rows + row[k] * stride + at);
  transpose(out[0], out[1], out[2], out[3]);
}

inline void scatter4(double* rows, unsigned stride, const Four* v) {
  Four r[4] = {v[0], v[1], v[2], v[3]};
  transpose(r[0], r[1], r[2], r[3]);
  for (unsigned k = 0; k < 4; ++k) store(rows + k * stride, r[k]);
}

#endif  // __AVX2__

#ifdef __AVX512F__
using Eight = VectorOf<8>::Type;

// As for Four, in both halves.
inline void transpose(Eight& r0, Eight& r1, Eight& r2, Eight& r3) {
  const Eight t0 = __builtin_shufflevector(r0, r1, 0, 8, 2, 10, 4, 12, 6, 14);
  const Eight t1 = __builtin_shufflevector(r0, r1, 1, 9, 3, 11, 5, 13, 7, 15);
  const Eight t2 = __builtin_shufflevector(r2, r3, 0, 8, 2, 10, 4, 12, 6, 14);
  const Eight t3 = __builtin_shufflevector(r2, r3, 1, 9, 3, 11, 5, 13, 7, 15);
  r0 = __builtin_shufflevector(t0, t2, 0, 1, 8, 9, 4, 5, 12, 13);
  r1 = __builtin_shufflevector(t1, t3, 0, 1, 8, 9, 4, 5, 12, 13);
  r2 = __builtin_shufflevector(t0, t2, 2, 3, 10, 11, 6, 7, 14, 15);
  r3 = __builtin_shufflevector(t1, t3, 2, 3, 10, 11, 6, 7, 14, 15);
}

inline void gather4(const double* rows, unsigned stride, const std::uint32_t* row, unsigned at, Eight* out) {
  for (unsigned k = 0; k < 4; ++k) {
    const Four low = load<Four>(rows + row[k] * stride + at), high = load<Four>(rows + row[k + 4] * stride + at);
    out[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  transpose(out[0], out[1], out[2], out[3]);
}

inline void scatter4(double* rows, unsigned stride, const Eight* v) {
  Eight r[4] = {v[0], v[1], v[2], v[3]};
  transpose(r[0], r[1], r[2], r[3]);
  for (unsigned k = 0; k < 4; ++k) {
    store(rows + k * stride, __builtin_shufflevector(r[k], r[k], 0, 1, 2, 3));
    store(rows + (k + 4) * stride, __builtin_shufflevector(r[k], r[k], 4, 5, 6, 7));
  }
}

#endif  // __AVX512F__

}  // namespace
}  // namespace tumble::sim
