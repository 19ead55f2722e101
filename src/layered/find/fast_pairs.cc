#include "src/layered/find/fast_pairs.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

#include "src/collide/box_pair.h"
#include "src/kernels/contacts/contact_batch.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/layered/find/pair_tests.h"
#include "src/layered/find/velocity_ranges.h"

namespace tumble::sim {
namespace {

constexpr std::size_t kFastPairsAPart = 32;  // that pay for one more worker

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
  const double way = std::max(length(velocity) * time_s, way_most_if_hit(scratch, lo, hi, time_s));
  const double reach = (around + length(b.half_extent)) + way;
  return dot(offset, offset) <= reach * reach;
}

// FreePaths::bend(), which takes the ground first.
double bend_of(const FreePaths& paths, BodyIndex lo, BodyIndex hi) {
  return hi == kGround ? paths.bend(kGround, lo) : paths.bend(lo, hi);
}

// Whether bodies that are apart, or touch, close faster along what separates them than by `most`, m in dt_s. Bodies
// that begin a session in one another, or slide on one another, meet nothing.
bool close_by_more(const Scratch& scratch, BodyIndex lo, BodyIndex hi, const Vec3& velocity, double most, double dt_s) {
  const BoxFrame& a = scratch.frames[lo];
  if (hi == kGround) {
    return -velocity.z() * dt_s > most && a.position.z() - reach_along(a, 2) >= -kSlop;
  }
  const BoxPair boxes(a, scratch.frames[hi]);
  const BestAxes apart = boxes.best(kFaces | kEdges);
  if (apart.separation < -kSlop) return false;
  for (unsigned rest = apart.axes; rest != 0; rest &= rest - 1) {
    if (-dot(velocity, boxes.normal(std::countr_zero(rest))) * dt_s > most) return true;
  }
  return false;
}

// Whether corners leave their tangents by more than contacts allow within a substep.
bool bends(const Scratch& scratch, const FreePaths& paths, BodyIndex lo, BodyIndex hi) {
  const double bend = bend_of(paths, lo, hi);
  return bend > kSlop && (bend > slack(scratch, lo, hi) || !holds_both(scratch, lo, hi));
}

}  // namespace

bool holds_one(const Scratch& scratch, BodyIndex lo, BodyIndex hi) {
  return scratch.held[lo] != 0 || (hi != kGround && scratch.held[hi] != 0);
}

bool must_be_followed(const Scratch& scratch, const FreePaths& paths, BodyIndex lo, BodyIndex hi) {
  const double bend = bend_of(paths, lo, hi);
  if (bend <= kSlop) return false;
  if (bend > slack(scratch, lo, hi) || !holds_one(scratch, lo, hi)) return true;
  return passes(scratch, paths, lo, hi);
}

bool passes(const Scratch& scratch, const FreePaths& paths, BodyIndex lo, BodyIndex hi) {
  return !holds_both(scratch, lo, hi) && paths.follow(lo, hi, 0).kind == Approach::Kind::kPassing;
}

bool meets_fast(const WorldState& state, const Scratch& scratch, BodyIndex lo, BodyIndex hi, double dt_s) {
  const Bodies& bodies = state.bodies;
  const bool ground = hi == kGround;
  const double e =
      std::max(bodies.restitution[lo], ground ? state.def.ground_material.restitution : bodies.restitution[hi]);
  if (holds_one(scratch, lo, hi)) return false;
  const Vec3 velocity = ground ? Vec3(bodies.velocity[lo]) : Vec3(bodies.velocity[hi] - bodies.velocity[lo]);
  const double turning = scratch.turning[lo] + (ground ? 0 : scratch.turning[hi]);
  const double most = kFastBounceMin * dt_s;
  return length(velocity) * dt_s + turning > most &&
         (e > 0 || close_by_more(scratch, lo, hi, velocity, most - turning, dt_s));
}

bool may_meet_if_hit(const Scratch& scratch, BodyIndex lo, BodyIndex hi, double fall, double dt_s) {
  const BoxFrame &a = scratch.frames[lo], &b = scratch.frames[hi];
  const double most = way_most_if_hit(scratch, lo, hi, dt_s);
  if (most == 0 && fall <= smallest_half_extent(a, b)) return false;
  const BoxPair boxes(a, b);
  const BestAxes apart = boxes.best(kFaces | kEdges);
  const double around = (scratch.turning[lo] + scratch.turning[hi]) + fall;
  bool meets = apart.axes != 0;
  for (unsigned rest = apart.axes; rest != 0; rest &= rest - 1) {
    const double way = way_if_hit(scratch, lo, hi, boxes.normal(std::countr_zero(rest)), dt_s);
    meets &= apart.separation <= way + around;
  }
  return meets;
}

void find_approaches(const WorldState& state, Scratch& scratch, double substep_s, std::vector<Approach>& out) {
  constexpr std::size_t kAtOnce = kFastPairsAPart;  // lanes are full, and others may take over the next ones
  const FreePaths paths(state, scratch, substep_s);
  const double fall = falling_reach(state.def, substep_s);
  const std::vector<ContactPair>& pairs = scratch.fast.pairs;
  out.resize(pairs.size());
  // Where tangents are good enough, points near the path are kept, so that resting bodies do not rock.
  const auto keep_near = [&](BodyIndex lo, BodyIndex hi, Approach& approach) {
    if (approach.kind == Approach::Kind::kPassing && !bends(scratch, paths, lo, hi))
      approach.kind = Approach::Kind::kNear;
  };
  const auto find = [&](std::size_t begin, std::size_t end) {
    std::array<FreePaths::Query, kAtOnce> queries;
    std::size_t count = 0;
    for (std::size_t k = begin; k < end; ++k) {
      const auto [lo, hi] = pairs[k];
      out[k] = {};
      if (!near(state, scratch, lo, hi, substep_s)) continue;
      double margin = holds_both(scratch, lo, hi) ? slack(scratch, lo, hi) + fall : 0;
      if (hi != kGround) margin += way_most_if_hit(scratch, lo, hi, substep_s);
      if (hi == kGround) {
        out[k] = paths.follow(kGround, lo, margin);
        keep_near(lo, hi, out[k]);
      } else {
        queries[count++] = {lo, hi, margin, &out[k]};
      }
    }
    paths.follow_all(std::span(queries).first(count));
    for (const FreePaths::Query& of : std::span(queries).first(count)) keep_near(of.a, of.b, *of.approach);
  };
  for_shared_blocks(scratch.workers, scratch.blocks_left, out.size(), kFastPairsAPart, kAtOnce, find);
}

}  // namespace tumble::sim
