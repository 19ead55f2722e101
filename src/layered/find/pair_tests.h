#pragma once

#include <cstddef>
#include <span>

#include "src/collide/box_pair.h"
#include "src/kernels/box_tests.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/layered/find/point_reach.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Parts of the smallest half extent by which an axis must be better than a face to replace the face.
inline constexpr double kEdgePreference = 0.01;   ///< for an edge pair
inline constexpr double kFacePreference = 0.001;  ///< for a face of the other box

/// The result of the box test for a pair that may touch within the step; a is the lower row.
struct TestedPair {
  BestAxes face_a, face_b, edge;
  double second_a, second_b;  ///< m, the second largest separation along the faces of a and of b (BoxPair::second)
  Vec3 offset;                ///< x_b − x_a, m, at the meeting
  double later;               ///< s until the meeting; 0 unless the boxes are fast for their thickness
  bool in_reach;              ///< whether they may touch unless a third body stops one of them
  [[nodiscard]] bool any_axis() const { return (face_a.axes | face_b.axes | edge.axes) != 0; }
};

/// Runs the box test over the pairs of a step in ascending order, many at a time in lanes (src/kernels/box_tests.h).
/// State and scratch must outlive the object and must not change.
class PairTests {
 public:
  /// Tests the pairs [first, last) of the state.
  PairTests(const WorldState& state, const Scratch& scratch, double dt_s, std::size_t first, std::size_t last);

  /// The result for the next pair with a body that moves; valid until the next call. Null where the boxes are so far
  /// apart along a face normal that no axis would keep a contact point. Precondition: a pair with a body that moves is
  /// left.
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
  double reach_[BoxTests::kMost];    // m, largest separation along a face at which points may be kept
  double stopped_[BoxTests::kMost];  // m, at which the boxes may touch if a third body stops one of them; no less
  double later_[BoxTests::kMost];
  bool near_[BoxTests::kMost];         // by pair, in the order added
  std::size_t asked_ = 0, added_ = 0;  // pairs
  std::size_t taken_ = 0;              // near pairs
};

/// Runs the box test over the fast pairs of two bodies that come together in a substep, many at a time in lanes. The
/// arguments must outlive the object and must not change.
class FastPairTests {
 public:
  FastPairTests(const Scratch& scratch, std::span<const ContactPair> pairs, std::span<const Approach> approaches);

  /// The result for the next such pair; valid until the next call. Precondition: one is left.
  const TestedPair& next();

 private:
  void refill();

  const Scratch& scratch_;
  std::span<const ContactPair> pairs_;
  std::span<const Approach> approaches_;
  std::size_t pair_ = 0;
  BoxTests tests_;
  std::size_t taken_ = 0;
  TestedPair tested_{};
};

}  // namespace tumble::sim
