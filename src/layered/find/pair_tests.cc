#include "src/layered/find/pair_tests.h"

#include <type_traits>

#include "src/base/check.h"
#include "src/kernels/kernels_by_width.h"
#include "src/layered/find/meeting_time.h"
#include "src/layered/find/velocity_ranges.h"

namespace tumble::sim {
namespace {

// The kernels read a frame as 15 doubles in this order.
static_assert(std::is_standard_layout_v<BoxFrame> && sizeof(BoxFrame) == 15 * sizeof(double) &&
              offsetof(BoxFrame, axes) == 3 * sizeof(double) && offsetof(BoxFrame, half_extent) == 12 * sizeof(double));

constexpr double kFarPart = 0.02;  // of the smallest half extent; above both preferences and the tolerance of points
static_assert(kFarPart > kEdgePreference + kFacePreference);

// The largest separation along faces of both boxes.
double face_separation(const BoxTests& tests, std::size_t k) {
  return larger_separation(best_of(tests.faces_of_a, k), best_of(tests.faces_of_b, k));
}

void copy(BoxTests::Best& best, std::size_t from, std::size_t to) {
  best.axes[to] = best.axes[from];
  best.separation[to] = best.separation[from];
}

}  // namespace

PairTests::PairTests(const WorldState& state, const Scratch& scratch, double dt_s, std::size_t first, std::size_t last)
    : state_(state),
      scratch_(scratch),
      kernels_(kernels(scratch.lanes).box_tests),
      dt_(dt_s),
      fall_(falling_reach(state.def, dt_s)),
      pair_(first),
      last_(last) {
  tests_.frames = scratch.frames.data();
}

const TestedPair* PairTests::next() {
  if (asked_ == added_) refill();
  SIM_DCHECK(asked_ < added_, pair_, last_);
  if (!near_[asked_++]) return nullptr;
  const std::size_t k = taken_++;
  tested_.face_a = best_of(tests_.faces_of_a, k);
  tested_.face_b = best_of(tests_.faces_of_b, k);
  tested_.edge = best_of(tests_.edges, k);
  tested_.second_a = tests_.second_of_a[k];
  tested_.second_b = tests_.second_of_b[k];
  tested_.offset = {tests_.offset[0][k], tests_.offset[1][k], tests_.offset[2][k]};
  tested_.later = later_[k];
  tested_.in_reach = face_separation(tests_, k) <= reach_[k];
  return &tested_;
}

void PairTests::refill() {
  const PairTable& pairs = state_.pairs;
  const Bodies& bodies = state_.bodies;
  tests_.count = asked_ = taken_ = 0;
  for (; pair_ < last_ && tests_.count < BoxTests::kMost; ++pair_) {
    const BodyIndex a = pairs.a[pair_], b = pairs.b[pair_];
    if (bodies.moves(a) || bodies.moves(b)) add(a, b);
  }
  added_ = tests_.count;
  kernels_.find_faces(tests_);
  keep_near();
  kernels_.find_edges(tests_);
}

void PairTests::add(BodyIndex a, BodyIndex b) {
  const Scratch& scratch = scratch_;
  const Bodies& bodies = state_.bodies;
  const BoxFrame& frame_a = scratch.frames[a];
  const BoxFrame& frame_b = scratch.frames[b];
  const Vec3 approach = bodies.velocity[b] - bodies.velocity[a];
  const double smallest = smallest_half_extent(frame_a, frame_b);
  const double turn = scratch.turning[a] + scratch.turning[b];
  const double later = meeting(a, b, approach, smallest);
  const Vec3 offset = (later == 0 ? frame_b : moved_on(frame_b, approach, later)).position - frame_a.position;
  const std::size_t k = tests_.count++;
  tests_.a[k] = a;
  tests_.b[k] = b;
  for (int axis = 0; axis < 3; ++axis) tests_.offset[axis][k] = offset[axis];
  later_[k] = later;
  const double around = (turn + fall_) + slack_of(smallest) + kFarPart * smallest;
  reach_[k] = length(approach) * dt_ + around;
  stopped_[k] = std::max(reach_[k], way_most_if_hit(scratch_, a, b, dt_) + around);
}

// The time until the meeting, or 0. Two bodies that move by more than the thinner one's half thickness in a step may
// face each other differently when they meet than they do now, so such a pair is tested at the meeting.
double PairTests::meeting(BodyIndex a, BodyIndex b, const Vec3& approach, double thinnest) const {
  if (dot(approach, approach) * (dt_ * dt_) <= thinnest * thinnest) return 0;
  const Scratch& scratch = scratch_;
  const double time = meeting_time(scratch.frames[a], scratch.frames[b], approach, dt_);
  return time < dt_ ? time : 0;
}

// Keeps the pairs that are near along their faces, and removes the others before the test of edges.
void PairTests::keep_near() {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < added_; ++k) {
    near_[k] = face_separation(tests_, k) <= stopped_[k];
    if (!near_[k]) continue;
    tests_.a[kept] = tests_.a[k];
    tests_.b[kept] = tests_.b[k];
    for (double(&offset)[BoxTests::kMost] : tests_.offset) offset[kept] = offset[k];
    copy(tests_.faces_of_a, k, kept);
    copy(tests_.faces_of_b, k, kept);
    tests_.second_of_a[kept] = tests_.second_of_a[k];
    tests_.second_of_b[kept] = tests_.second_of_b[k];
    later_[kept] = later_[k];
    reach_[kept] = reach_[k];
    ++kept;
  }
  tests_.count = kept;
}

FastPairTests::FastPairTests(const Scratch& scratch, std::span<const ContactPair> pairs,
                             std::span<const Approach> approaches)
    : scratch_(scratch), pairs_(pairs), approaches_(approaches) {
  tests_.frames = scratch.frames.data();
}

const TestedPair& FastPairTests::next() {
  if (taken_ == tests_.count) refill();
  SIM_DCHECK(taken_ < tests_.count, pair_);
  const std::size_t k = taken_++;
  const Vec3 offset(tests_.offset[0][k], tests_.offset[1][k], tests_.offset[2][k]);
  tested_ = {best_of(tests_.faces_of_a, k),
             best_of(tests_.faces_of_b, k),
             best_of(tests_.edges, k),
             tests_.second_of_a[k],
             tests_.second_of_b[k],
             offset,
             0,
             true};
  return tested_;
}

void FastPairTests::refill() {
  tests_.count = taken_ = 0;
  for (; pair_ < pairs_.size() && tests_.count < BoxTests::kMost; ++pair_) {
    const auto [a, b] = pairs_[pair_];
    if (b == kGround || approaches_[pair_].kind == Approach::Kind::kPassing) continue;
    const Vec3 offset = scratch_.frames[b].position - scratch_.frames[a].position;
    const std::size_t k = tests_.count++;
    tests_.a[k] = a;
    tests_.b[k] = b;
    for (int axis = 0; axis < 3; ++axis) tests_.offset[axis][k] = offset[axis];
  }
  kernels(scratch_.lanes).box_tests.find_all(tests_);
}

}  // namespace tumble::sim
