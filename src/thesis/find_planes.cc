#include "src/thesis/find_planes.h"

#include <algorithm>

#include "src/collide/box_pair.h"
#include "src/kernels/box_tests.h"
#include "src/kernels/kernels_by_width.h"

namespace tumble::sim {
namespace {

// The first box's faces are preferred to the other box's, and faces to edges, unless the latter overlap less by this
// part of the smallest half extent: nearly equal axes would otherwise alternate from step to step.
constexpr double kPreference = 0.01;
// A collision keeps its old plane until the overlap is deeper than this part of the smallest half extent; the boxes
// have then turned past the plane.
constexpr double kOldPlaneDepth = 0.5;

// Tied planes are kept as sets (AxisSet) through the whole narrow phase. Two axes with bit-equal separations are
// common: stacked boxes are symmetric. Taking one of them would break the tie by loop order, so a scene with two bodies
// renamed or an axis mirrored would take the other plane and go another way. A set has no order; find_contacts takes
// the mean over the set, which respects every symmetry of the pair.

// The faces to test first: those of the larger box (thesis Fig. 5), then of the lower one along gravity, and of both on
// an exact tie and without gravity.
AxisSet first_faces(const BoxFrame& frame_a, const BoxFrame& frame_b, const Vec3& gravity) {
  const double a = volume_measure(frame_a), b = volume_measure(frame_b);
  if (a != b) return a > b ? kFacesOfA : kFacesOfB;
  const double down = dot(gravity, Vec3(frame_b.position - frame_a.position));
  if (down != 0) return down < 0 ? kFacesOfA : kFacesOfB;
  return kFaces;
}

// The best axes of a pair: among the faces to test first, among the other faces, and among the edges.
struct BestOfKinds {
  BestAxes first, others, edges;
};

BestAxes better_of(const BestAxes& x, const BestAxes& y) {
  if (x.axes == 0 || y.axes == 0) return x.axes == 0 ? y : x;
  if (x.separation == y.separation) return {static_cast<AxisSet>(x.axes | y.axes), x.separation};
  return x.separation > y.separation ? x : y;
}

BestOfKinds best_of_kinds(const BoxTests& tests, std::size_t k, AxisSet first) {
  const BestAxes of_a = best_of(tests.faces_of_a, k), of_b = best_of(tests.faces_of_b, k);
  const BestAxes edges = best_of(tests.edges, k);
  if (first == kFaces) return {better_of(of_a, of_b), {}, edges};
  return first == kFacesOfA ? BestOfKinds{of_a, of_b, edges} : BestOfKinds{of_b, of_a, edges};
}

AxisSet separating_axes(const BestAxes& best) {
  return best.axes != 0 && best.separation >= 0 ? best.axes : AxisSet{0};
}

// The planes that separate a pair whose old planes no longer do.
AxisSet find_separating(const BestOfKinds& best, AxisSet old) {
  const AxisSet first = separating_axes(best.first), edges = separating_axes(best.edges);
  const AxisSet faces = first != 0 ? first : separating_axes(best.others);
  if ((old & kFaces) != 0) return edges != 0 ? edges : faces;
  return faces != 0 ? faces : edges;
}

AxisSet least_overlap(const BestOfKinds& best, double smallest) {
  const double margin = kPreference * smallest;
  BestAxes chosen = best.first;
  for (const BestAxes& other : {best.others, best.edges}) {
    if (other.axes != 0 && (chosen.axes == 0 || other.separation > chosen.separation + margin)) chosen = other;
  }
  return chosen.axes;
}

AxisSet collision_planes(const BoxFrame& a, const BoxFrame& b, AxisSet old, const BestOfKinds& best) {
  const double smallest = smallest_half_extent(a, b);
  if (old != 0) {
    const BestAxes cached = BoxPair(a, b).best(old);
    if (cached.axes != 0 && -cached.separation <= kOldPlaneDepth * smallest) return cached.axes;
  }
  return least_overlap(best, smallest);
}

void add_collision(Contacts& contacts, BodyIndex a, BodyIndex b, AxisSet planes) {
  contacts.a.push_back(a);
  contacts.b.push_back(b);
  contacts.planes.push_back(planes);
}

// Adds the bodies in the ground, which is its own separating plane.
void find_grounded(const WorldState& state, const Scratch& scratch, Contacts& contacts) {
  const Bodies& bodies = state.bodies;
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (scratch.aabb_low.z[i] >= 0 || !bodies.moves(i)) continue;
    if (reaches_ground(scratch.frames[i])) add_collision(contacts, i, kGround, 0);
  }
}

// Pairs that no old plane separates, tested in lanes.
class PlaneSearch {
 public:
  PlaneSearch(WorldState& state, Scratch& scratch)
      : state_(state), scratch_(scratch), kernels_(kernels(scratch.lanes).box_tests) {
    tests_.frames = scratch.frames.data();
  }

  void add(std::size_t pair) {
    const BodyIndex a = state_.pairs.a[pair], b = state_.pairs.b[pair];
    const Vec3 offset = scratch_.frames[b].position - scratch_.frames[a].position;
    const std::size_t k = tests_.count++;
    pair_[k] = pair;
    tests_.a[k] = a;
    tests_.b[k] = b;
    for (int axis = 0; axis < 3; ++axis) tests_.offset[axis][k] = offset[axis];
    if (tests_.count == BoxTests::kMost) finish();
  }

  // Finds the planes of the pairs added, and the collisions among them.
  void finish() {
    kernels_.find_all(tests_);
    for (std::size_t k = 0; k < tests_.count; ++k) find(k);
    tests_.count = 0;
  }

 private:
  void find(std::size_t k) {
    const BodyIndex a = tests_.a[k], b = tests_.b[k];
    const BoxFrame &frame_a = scratch_.frames[a], &frame_b = scratch_.frames[b];
    AxisSet& planes = state_.pairs.planes[pair_[k]];
    const AxisSet old = planes;
    const BestOfKinds best = best_of_kinds(tests_, k, first_faces(frame_a, frame_b, state_.def.gravity));
    planes = find_separating(best, old);
    if (planes != 0 || tests_.apart_along_facelike[k] != 0) return;
    add_collision(scratch_.contacts, a, b, collision_planes(frame_a, frame_b, old, best));
  }

  WorldState& state_;
  Scratch& scratch_;
  const BoxTestKernels& kernels_;
  BoxTests tests_;
  std::size_t pair_[BoxTests::kMost];
};

}  // namespace

Status find_planes(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  PairTable& pairs = state.pairs;
  Contacts& contacts = scratch.contacts;
  contacts.a.clear();
  contacts.b.clear();
  contacts.planes.clear();
  PlaneSearch search(state, scratch);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const BodyIndex a = pairs.a[k], b = pairs.b[k];
    if (!state.bodies.moves(a) && !state.bodies.moves(b)) continue;
    const AxisSet apart = separating(scratch.frames[a], scratch.frames[b], pairs.planes[k]);
    if (apart == 0) {
      search.add(k);
    } else {
      pairs.planes[k] = apart;
    }
  }
  search.finish();
  if (state.def.ground) find_grounded(state, scratch, contacts);
  return {};
}

void hash_find_planes(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  hasher.add(std::span<const std::uint16_t>(state.pairs.planes));
  const Contacts& contacts = scratch.contacts;
  hasher.add(std::span<const BodyIndex>(contacts.a));
  hasher.add(std::span<const BodyIndex>(contacts.b));
  hasher.add(std::span<const std::uint16_t>(contacts.planes));
}

}  // namespace tumble::sim
