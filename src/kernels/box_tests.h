#pragma once

#include <cstddef>
#include <cstdint>

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

// One lane: BoxPair pair by pair.
void find_faces_singly(BoxTests& tests);
void find_edges_singly(BoxTests& tests);

}  // namespace tumble::sim
