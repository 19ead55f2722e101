#pragma once

#include <algorithm>
#include <cstddef>

#include "src/kernels/box_pair.h"
#include "src/kernels/box_tests.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

inline double smallest_half_extent(const BoxFrame& a, const BoxFrame& b) {
  return std::min(a.half_extent.minCoeff(), b.half_extent.minCoeff());
}
/// kContactSlack for boxes of this smallest half extent.
inline double slack_of(double smallest) { return std::min(kContactSlack, kContactSlackPart * smallest); }

/// Parts of the smallest half extent by which an axis must be better than a face to be taken instead.
inline constexpr double kEdgePreference = 0.01;   ///< an edge pair
inline constexpr double kFacePreference = 0.001;  ///< the other box's face

/// What the box test says of a pair that may touch within the step; a is the lower row.
struct TestedPair {
  BestAxes face_a, face_b, edge;
  Vec3 offset;   ///< x_b − x_a, m, where they meet
  double later;  ///< s from now, when that is: 0 unless they move on by more than the thinner one's half thickness
};

/// The box test over the pairs of a step in ascending order, many at a time in lanes; see box_tests.h. The world must
/// stay as it is meanwhile.
class PairTests {
 public:
  /// For the pairs [first, last).
  PairTests(const WorldState& state, const Scratch& scratch, double dt_s, std::size_t first, std::size_t last);

  /// Of the next pair of which a body moves, until the next call; null where the boxes are so far apart along a face
  /// that no point of whatever is chosen is kept.
  const TestedPair* next();

 private:
  void refill();
  void add(BodyIndex a, BodyIndex b);
  double meeting(BodyIndex a, BodyIndex b, const Vec3& approach, double thinnest) const;
  void keep_near();

  const WorldState& state_;
  const Scratch& scratch_;
  const BoxTestKernels& kernels_;
  double dt_, fall_;
  std::size_t pair_, last_;
  BoxTests tests_;
  TestedPair tested_{};
  double reach_[BoxTests::kMost];  // m, farther apart along a face is too far
  double later_[BoxTests::kMost];
  bool near_[BoxTests::kMost];         // of the pairs that were added, in their order
  std::size_t asked_ = 0, added_ = 0;  // of those
  std::size_t taken_ = 0;              // of the near ones
};

}  // namespace tumble::sim
