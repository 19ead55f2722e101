#include "src/layered/find/fast_pairs.h"

#include <algorithm>

#include "src/kernels/contacts/contact_batch.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/layered/find/pair_tests.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kFastPairsAPart = 32;  // that pay for one more worker

bool holds_one(const Scratch& scratch, BodyIndex lo, BodyIndex hi) {
  return scratch.held[lo] != 0 || (hi != kGround && scratch.held[hi] != 0);
}
// Bodies in contact fly on no free path, so their points are kept by tangents as far as that may be.
bool holds_both(const Scratch& scratch, BodyIndex lo, BodyIndex hi) {
  return scratch.held[lo] != 0 && (hi == kGround || scratch.held[hi] != 0);
}

double slack(const Scratch& scratch, BodyIndex lo, BodyIndex hi) {
  const BoxFrame& a = scratch.frames[lo];
  return slack_of(hi == kGround ? a.half_extent.minCoeff() : smallest_half_extent(a, scratch.frames[hi]));
}

// Whether a sphere around a body can reach the ground, or that around another body, within the slack.
bool near(const WorldState& state, const Scratch& scratch, BodyIndex lo, BodyIndex hi, double time_s) {
  const Bodies& bodies = state.bodies;
  const BoxFrame& a = scratch.frames[lo];
  const double around = length(a.half_extent) + (kContactSlack + falling_reach(state.def, time_s));
  if (hi == kGround) return a.position.z() + std::min(0.0, bodies.velocity.z[lo]) * time_s <= around;
  const BoxFrame& b = scratch.frames[hi];
  const Vec3 offset = b.position - a.position, velocity = bodies.velocity[hi] - bodies.velocity[lo];
  const double reach = (around + length(b.half_extent)) + length(velocity) * time_s;
  return dot(offset, offset) <= reach * reach;
}

// FreePaths::bend(), which takes the ground first.
double bend_of(const FreePaths& paths, BodyIndex lo, BodyIndex hi) {
  return hi == kGround ? paths.bend(kGround, lo) : paths.bend(lo, hi);
}

// Whether corners leave their tangents by more than contacts allow within a substep.
bool bends(const Scratch& scratch, const FreePaths& paths, BodyIndex lo, BodyIndex hi) {
  const double bend = bend_of(paths, lo, hi);
  return bend > kSlop && (bend > slack(scratch, lo, hi) || !holds_both(scratch, lo, hi));
}

}  // namespace

bool must_be_followed(const Scratch& scratch, const FreePaths& paths, BodyIndex lo, BodyIndex hi) {
  const double bend = bend_of(paths, lo, hi);
  if (bend <= kSlop) return false;
  if (bend > slack(scratch, lo, hi) || !holds_one(scratch, lo, hi)) return true;
  return !holds_both(scratch, lo, hi) && paths.follow(lo, hi, 0).kind == Approach::Kind::kPassing;
}

bool may_bounce(const WorldState& state, const Scratch& scratch, BodyIndex lo, BodyIndex hi, double dt_s) {
  const Bodies& bodies = state.bodies;
  const bool ground = hi == kGround;
  const double e =
      std::max(bodies.restitution[lo], ground ? state.def.ground_material.restitution : bodies.restitution[hi]);
  if (e == 0 || holds_one(scratch, lo, hi)) return false;
  const Vec3 velocity = ground ? Vec3(bodies.velocity[lo]) : Vec3(bodies.velocity[hi] - bodies.velocity[lo]);
  const double turning = scratch.turning[lo] + (ground ? 0 : scratch.turning[hi]);
  return length(velocity) * dt_s + turning > kFastBounceMin * dt_s;
}

void find_approaches(const WorldState& state, const Scratch& scratch, double substep_s, std::vector<Approach>& out) {
  const FreePaths paths(state, scratch, substep_s);
  const double fall = falling_reach(state.def, substep_s);
  out.resize(scratch.fast.pairs.size());
  const auto find = [&](const ContactPair& pair) -> Approach {
    const auto [lo, hi] = pair;
    if (!near(state, scratch, lo, hi, substep_s)) return {};
    const double margin = holds_both(scratch, lo, hi) ? slack(scratch, lo, hi) + fall : 0;
    Approach approach = hi == kGround ? paths.follow(kGround, lo, margin) : paths.follow(lo, hi, margin);
    // Where tangents are good enough, points near the path are kept, so that resting bodies do not rock.
    if (approach.kind == Approach::Kind::kPassing && !bends(scratch, paths, lo, hi))
      approach.kind = Approach::Kind::kNear;
    return approach;
  };
  for_ranges(scratch.workers, out.size(), kFastPairsAPart, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) out[k] = find(scratch.fast.pairs[k]);
  });
}

}  // namespace tumble::sim
