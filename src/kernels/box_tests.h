#pragma once

#include <cstddef>
#include <cstdint>

namespace tumble::sim {

struct BoxFrame;

inline constexpr double kParallelSquared = 1e-6;         ///< |edge × edge|² below this: the edges are parallel
inline constexpr double kHardlyParallelSquared = 1e-16;  ///< below this the product is mostly rounding
inline constexpr double kFaceLike = 0.999;               ///< |axis · face normal| above this: the axis repeats a face

/// Pairs of boxes that are tested in lanes, and the best axes of each pair (BestAxes), numbered and skipped as in
/// BoxPair. A set of axes is a sum of powers of two, so that a lane can hold the set as a double.
struct BoxTests {
  static constexpr std::size_t kMost = 64;  ///< a multiple of every width
  struct alignas(64) Best {
    double axes[kMost], separation[kMost];
  };

  const BoxFrame* frames = nullptr;
  std::size_t count = 0;  ///< pairs; kernels also read those up to the next multiple of the lane width
  std::uint32_t a[kMost] = {}, b[kMost] = {};  ///< rows of frames; all kMost must exist
  alignas(64) double offset[3][kMost] = {};    ///< x_b − x_a, m
  Best faces_of_a, faces_of_b, edges;
  Best all;                                                   ///< BoxPair::best_of_all
  alignas(64) double second_of_a[kMost], second_of_b[kMost];  ///< BoxPair::second of both boxes' faces
  alignas(64) double apart_along_facelike[kMost];             ///< BoxPair::apart_along_facelike_edges, 1 or 0
};

/// The box test for many pairs. One lane calls BoxPair.
struct BoxTestKernels {
  void (*find_faces)(BoxTests& tests);  ///< fills faces_of_a, faces_of_b, second_of_a, second_of_b
  void (*find_edges)(BoxTests& tests);  ///< fills edges
  void (*find_all)(BoxTests& tests);    ///< fills all results but `all`
  void (*find_best)(BoxTests& tests);   ///< fills `all`
};

// The kernels of one lane: BoxPair for one pair after the other.
void find_faces_singly(BoxTests& tests);
void find_edges_singly(BoxTests& tests);
void find_all_singly(BoxTests& tests);
void find_best_singly(BoxTests& tests);

}  // namespace tumble::sim
