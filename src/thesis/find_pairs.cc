#include "src/thesis/find_pairs.h"

#include "src/collide/sweep.h"
#include "src/kernels/kernels_by_width.h"
#include "src/world/body_columns.h"

namespace tumble::sim {
namespace {

// Writes the boxes of the bodies, except of those that could not move since their boxes were written in this step.
// Returns whether all AABBs lie in their fat AABBs, so that the list of neighbours still holds.
bool update_boxes(WorldState& state, Scratch& scratch) {
  const std::size_t n = state.bodies.size();
  BoxColumns boxes = box_columns_of(scratch, n);
  if (scratch.framed.size() == n) boxes.framed = scratch.framed.data();
  boxes.fat = scratch.sweep.fat_low.size() == n;
  put_pointers(scratch.sweep.fat_low, boxes.fat_low);
  put_pointers(scratch.sweep.fat_high, boxes.fat_high);
  return kernels(scratch.lanes).bodies.put_boxes(columns_of(state.bodies), {0, n}, boxes);
}

}  // namespace

Status find_pairs(WorldState& state, Scratch& scratch, double dt_s) {
  if (!update_boxes(state, scratch)) renew_neighbours(state.bodies.velocity, dt_s, scratch);
  find_overlaps(scratch, state.pairs);
  scratch.old_planes = state.pairs.planes;
  return check_crowd(scratch);
}

// When trial phases are hashed, find_planes has already replaced the planes of the pairs; hence old_planes.
void hash_find_pairs(const WorldState& state, const Scratch& scratch, Hasher& hasher) {
  const PairTable& pairs = state.pairs;
  hasher.add(std::span<const BodyIndex>(pairs.a));
  hasher.add(std::span<const BodyIndex>(pairs.b));
  hasher.add(std::span<const std::uint16_t>(scratch.old_planes));
  hasher.add(std::span<const double>(scratch.aabb_low.z));
  hash_frames(scratch, hasher);
}

}  // namespace tumble::sim
