#include "src/thesis/find_planes.h"

#include <algorithm>

#include "src/kernels/box_pair.h"

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
AxisSet first_faces(const BoxPair& pair, const Vec3& gravity) {
  const double a = volume_measure(pair.a()), b = volume_measure(pair.b());
  if (a != b) return a > b ? kFacesOfA : kFacesOfB;
  const double down = dot(gravity, pair.offset());
  if (down != 0) return down < 0 ? kFacesOfA : kFacesOfB;
  return kFaces;
}

double smallest_half_extent(const BoxPair& pair) {
  return std::min(pair.a().half_extent.minCoeff(), pair.b().half_extent.minCoeff());
}

AxisSet best_separating(const BoxPair& pair, AxisSet candidates) {
  const BestAxes best = pair.best(candidates);
  return best.axes != 0 && best.separation >= 0 ? best.axes : AxisSet{0};
}

AxisSet separating_faces(const BoxPair& pair, AxisSet first) {
  const AxisSet found = best_separating(pair, first);
  return found != 0 ? found : best_separating(pair, static_cast<AxisSet>(kFaces & ~first));
}

// The planes that separate a pair whose old planes no longer do.
AxisSet find_separating(const BoxPair& pair, AxisSet old, AxisSet first) {
  if ((old & kFaces) != 0) {
    const AxisSet edges = best_separating(pair, kEdges);
    return edges != 0 ? edges : separating_faces(pair, first);
  }
  const AxisSet faces = separating_faces(pair, first);
  return faces != 0 ? faces : best_separating(pair, kEdges);
}

AxisSet least_overlap(const BoxPair& pair, AxisSet first) {
  const double margin = kPreference * smallest_half_extent(pair);
  BestAxes chosen = pair.best(first);
  for (const AxisSet others : {static_cast<AxisSet>(kFaces & ~first), kEdges}) {
    const BestAxes other = pair.best(others);
    if (other.axes != 0 && (chosen.axes == 0 || other.separation > chosen.separation + margin)) chosen = other;
  }
  return chosen.axes;
}

AxisSet collision_planes(const BoxPair& pair, AxisSet old, AxisSet first) {
  const BestAxes cached = pair.best(old);
  const bool believed = cached.axes != 0 && -cached.separation <= kOldPlaneDepth * smallest_half_extent(pair);
  return believed ? cached.axes : least_overlap(pair, first);
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

}  // namespace

Status find_planes(WorldState& state, Scratch& scratch, double /*dt_s*/) {
  PairTable& pairs = state.pairs;
  Contacts& contacts = scratch.contacts;
  contacts.a.clear();
  contacts.b.clear();
  contacts.planes.clear();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const BodyIndex a = pairs.a[k], b = pairs.b[k];
    if (!state.bodies.moves(a) && !state.bodies.moves(b)) continue;
    const AxisSet old = pairs.planes[k];
    pairs.planes[k] = separating(scratch.frames[a], scratch.frames[b], old);
    if (pairs.planes[k] != 0) continue;
    const BoxPair pair(scratch.frames[a], scratch.frames[b]);
    const AxisSet first = first_faces(pair, state.def.gravity);
    pairs.planes[k] = find_separating(pair, old, first);
    if (pairs.planes[k] != 0 || pair.apart_along_facelike_edges()) continue;
    add_collision(contacts, a, b, collision_planes(pair, old, first));
  }
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
