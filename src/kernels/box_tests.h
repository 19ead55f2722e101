#pragma once

#include <cstddef>
#include <cstdint>

#include "src/kernels/lane_width.h"

namespace tumble::sim {

struct BoxFrame;

inline constexpr double kParallelSquared = 1e-6;  ///< |edge × edge|² below this: the edges are parallel
inline constexpr double kFaceLike = 0.999;        ///< |axis · face normal| above this: the axis repeats a face

/// Pairs of boxes that are tested side by side, and the best axes of each (BestAxes), numbered and skipped as by
/// BoxPair. A set of axes is a sum of powers of two, so that lanes can hold it.
struct BoxTests {
  static constexpr std::size_t kMost = 64;  ///< a multiple of every width
  struct alignas(64) Best {
    double axes[kMost], separation[kMost];
  };

  const BoxFrame* frames = nullptr;
  std::size_t count = 0;                       ///< the kernels may look at rows up to the next multiple of their width,
  std::uint32_t a[kMost] = {}, b[kMost] = {};  ///< so all of `a` and `b` must be rows of frames
  alignas(64) double offset[3][kMost] = {};    ///< x_b − x_a, m
  Best faces_of_a, faces_of_b, edges;
};

/// The box test over pairs, compiled once for each lane width; one lane is BoxPair itself.
struct BoxTestKernels {
  void (*find_faces)(BoxTests& tests);  ///< fills faces_of_a, faces_of_b
  void (*find_edges)(BoxTests& tests);  ///< fills edges
};

/// Null where this machine or this build does not run the width.
const BoxTestKernels* box_test_kernels(LaneWidth width);

// Each is defined where the compiler makes that width, and null elsewhere.
const BoxTestKernels* box_test_kernels_one();
const BoxTestKernels* box_test_kernels_two();
const BoxTestKernels* box_test_kernels_four();
const BoxTestKernels* box_test_kernels_eight();

}  // namespace tumble::sim
