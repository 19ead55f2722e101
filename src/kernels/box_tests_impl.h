#pragma once

// The test of BoxPair for any number of lanes: its operations in its order. lane_vector.h says who may include this.

#include "src/kernels/box_tests.h"
#include "src/kernels/lanes/lane_rows.h"
#include "src/kernels/lanes/lane_vector.h"

namespace tumble::sim {
namespace {

constexpr unsigned kFrameAxes = 3;
constexpr double kNoDirection = -__builtin_inf();  // the separation along an axis that is skipped

template <class V>
struct LaneBoxes {
  Space<V> axes[3];
  V half[3];

  LaneBoxes(const double* frames, const std::uint32_t* row) {
    V c[12];
    for (unsigned at = 0; at < 12; at += 4) gather4(frames, kFrameDoubles, row, kFrameAxes + at, c + at);
    for (int k = 0; k < 3; ++k) {
      axes[k] = {c[3 * k], c[3 * k + 1], c[3 * k + 2]};
      half[k] = c[9 + k];
    }
  }
};

template <class V>
struct LanePairs {
  LaneBoxes<V> a, b;
  Space<V> offset;
  V product[3][3];  // |a's axis i · b's axis j|

  LanePairs(const BoxTests& tests, std::size_t at)
      : a(reinterpret_cast<const double*>(tests.frames), tests.a + at),
        b(reinterpret_cast<const double*>(tests.frames), tests.b + at),
        offset{load<V>(tests.offset[0] + at), load<V>(tests.offset[1] + at), load<V>(tests.offset[2] + at)} {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) product[i][j] = absolute(dot(a.axes[i], b.axes[j]));
    }
  }
};

// Stores the largest separation and the axes that have it; `bit` stands for the first axis.
template <class V, std::size_t kCount>
void store_best(const V (&separation)[kCount], double bit, BoxTests::Best& best, std::size_t at) {
  V most = separation[0];
  for (std::size_t k = 1; k < kCount; ++k) most = larger(most, separation[k]);
  const V zero = V{} + 0.0;
  V axes = zero;
  for (std::size_t k = 0; k < kCount; ++k, bit *= 2) axes = axes + (separation[k] == most ? V{} + bit : zero);
  store(best.axes + at, most == kNoDirection ? zero : axes);
  store(best.separation + at, most == kNoDirection ? zero : most);
}

// The second largest of three.
template <class V>
V second_of(const V (&separation)[3]) {
  const V low = smaller(separation[0], separation[1]), high = larger(separation[0], separation[1]);
  return larger(low, smaller(high, separation[2]));
}

template <class V>
V along_face(const Space<V>& offset, const Space<V>& normal, V half, const V (&other_half)[3], V p0, V p1, V p2) {
  const V distance = dot(offset, normal);
  const V reach = half + ((other_half[0] * p0 + other_half[1] * p1) + other_half[2] * p2);
  return distance == 0.0 ? V{} + kNoDirection : absolute(distance) - reach;
}

template <class V>
void separate_faces(const LanePairs<V>& pairs, V* of_a, V* of_b) {
  const auto& p = pairs.product;
  for (int k = 0; k < 3; ++k) {
    of_a[k] = along_face(pairs.offset, pairs.a.axes[k], pairs.a.half[k], pairs.b.half, p[k][0], p[k][1], p[k][2]);
    of_b[k] = along_face(pairs.offset, pairs.b.axes[k], pairs.b.half[k], pairs.a.half, p[0][k], p[1][k], p[2][k]);
  }
}

template <class V>
void find_faces_of(const LanePairs<V>& pairs, BoxTests& tests, std::size_t at) {
  V of_a[3], of_b[3];
  separate_faces(pairs, of_a, of_b);
  store_best(of_a, 1, tests.faces_of_a, at);
  store_best(of_b, 8, tests.faces_of_b, at);
  store(tests.second_of_a + at, second_of(of_a));
  store(tests.second_of_b + at, second_of(of_b));
}

// Along a's edge i crossed with b's edge j, whether or not that axis repeats a face. Writes the length of the product.
template <int i, int j, class V>
V along_edges(const LanePairs<V>& pairs, double least_squared, V& length) {
  constexpr int ia = (i + 1) % 3, ib = (i + 2) % 3, ja = (j + 1) % 3, jb = (j + 2) % 3;
  const auto& p = pairs.product;
  const Space<V> axis = cross(pairs.a.axes[i], pairs.b.axes[j]);
  const V squared = dot(axis, axis);
  length = square_root(squared);
  const V scale = 1.0 / length, offset = dot(pairs.offset, axis);
  const V reach = (pairs.a.half[ia] * (p[ib][j] * scale) + pairs.a.half[ib] * (p[ia][j] * scale)) +
                  (pairs.b.half[ja] * (p[i][jb] * scale) + pairs.b.half[jb] * (p[i][ja] * scale));
  const auto undirected = (squared < least_squared) | (offset == 0.0);
  return undirected ? V{} + kNoDirection : absolute(offset) * scale - reach;
}

// Likewise, without axes that repeat a face. Raises `apart` to 1 where such an axis separates the boxes.
template <int i, int j, class V>
V along_true_edges(const LanePairs<V>& pairs, V& apart) {
  constexpr int ia = (i + 1) % 3, ib = (i + 2) % 3, ja = (j + 1) % 3, jb = (j + 2) % 3;
  const auto& p = pairs.product;
  V length;
  const V separation = along_edges<i, j>(pairs, kParallelSquared, length);
  const V most_along_face = larger(larger(p[ia][j], p[ib][j]), larger(p[i][ja], p[i][jb]));
  const auto facelike = most_along_face > kFaceLike * length;
  const V parted = separation >= 0.0 ? V{} + 1.0 : V{} + 0.0;
  apart = facelike ? larger(apart, parted) : apart;
  return facelike ? V{} + kNoDirection : separation;
}

template <class V>
void find_edges_of(const LanePairs<V>& pairs, BoxTests& tests, std::size_t at, V& apart) {
  const V separation[9] = {
      along_true_edges<0, 0>(pairs, apart), along_true_edges<0, 1>(pairs, apart), along_true_edges<0, 2>(pairs, apart),
      along_true_edges<1, 0>(pairs, apart), along_true_edges<1, 1>(pairs, apart), along_true_edges<1, 2>(pairs, apart),
      along_true_edges<2, 0>(pairs, apart), along_true_edges<2, 1>(pairs, apart), along_true_edges<2, 2>(pairs, apart)};
  store_best(separation, 64, tests.edges, at);
}

template <int kWidth>
void find_faces(BoxTests& tests) {
  using V = typename VectorOf<kWidth>::Type;
  for (std::size_t at = 0; at < tests.count; at += kWidth) find_faces_of(LanePairs<V>(tests, at), tests, at);
}

template <int kWidth>
void find_edges(BoxTests& tests) {
  using V = typename VectorOf<kWidth>::Type;
  V unused = V{} + 0.0;
  for (std::size_t at = 0; at < tests.count; at += kWidth) find_edges_of(LanePairs<V>(tests, at), tests, at, unused);
}

template <int kWidth>
void find_all(BoxTests& tests) {
  using V = typename VectorOf<kWidth>::Type;
  for (std::size_t at = 0; at < tests.count; at += kWidth) {
    const LanePairs<V> pairs(tests, at);
    V apart = V{} + 0.0;
    find_faces_of(pairs, tests, at);
    find_edges_of(pairs, tests, at, apart);
    store(tests.apart_along_facelike + at, apart);
  }
}

template <int kAxis, class V>
void separate_edges(const LanePairs<V>& pairs, V* separation) {
  if constexpr (kAxis < 9) {
    V unused;
    separation[kAxis] = along_edges<kAxis / 3, kAxis % 3>(pairs, kHardlyParallelSquared, unused);
    separate_edges<kAxis + 1>(pairs, separation);
  }
}

template <int kWidth>
[[gnu::flatten]] void find_best(BoxTests& tests) {
  using V = typename VectorOf<kWidth>::Type;
  for (std::size_t at = 0; at < tests.count; at += kWidth) {
    const LanePairs<V> pairs(tests, at);
    V separation[15];
    separate_faces(pairs, separation, separation + 3);
    separate_edges<0>(pairs, separation + 6);
    store_best(separation, 1, tests.all, at);
  }
}

template <int kWidth>
constexpr BoxTestKernels box_test_kernels_of() {
  if constexpr (kWidth == 1) return {find_faces_singly, find_edges_singly, find_all_singly, find_best_singly};
  return {find_faces<kWidth>, find_edges<kWidth>, find_all<kWidth>, find_best<kWidth>};
}

}  // namespace
}  // namespace tumble::sim
