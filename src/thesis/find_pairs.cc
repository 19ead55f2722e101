#include "src/thesis/find_pairs.h"

#include "src/collide/sweep.h"
#include "src/kernels/kernels_by_width.h"
#include "src/world/body_columns.h"

namespace tumble::sim {
namespace {

// Puts the boxes where their bodies are now, but for those that could not move since they were put there in this step.
// Tells whether all are still in the room in which they keep their neighbours.
bool update_boxes(World& world) {
  const std::size_t n = world.bodies().size();
  Scratch& scratch = world.mutable_scratch();
  BoxColumns boxes = box_columns_of(scratch, n);
  if (scratch.framed.size() == n) boxes.framed = scratch.framed.data();
  boxes.rooms = scratch.sweep.low.size() == n;
  put_pointers(scratch.sweep.low, boxes.room_low);
  put_pointers(scratch.sweep.high, boxes.room_high);
  return kernels(scratch.lanes).bodies.put_boxes(columns_of(world.mutable_state().bodies), {0, n}, boxes);
}

}  // namespace

Status find_pairs(World& world, double dt_s) {
  Scratch& scratch = world.mutable_scratch();
  if (!update_boxes(world)) renew_neighbours(world.bodies().velocity, dt_s, scratch);
  find_overlaps(scratch, world.mutable_state().pairs);
  scratch.old_planes = world.state().pairs.planes;
  return check_crowd(scratch);
}

// The pairs' own planes are find_planes's by the time that trial phases are hashed.
void hash_find_pairs(const World& world, Hasher& hasher) {
  const Scratch& scratch = world.scratch();
  const PairTable& pairs = world.state().pairs;
  hasher.add(std::span<const BodyIndex>(pairs.a));
  hasher.add(std::span<const BodyIndex>(pairs.b));
  hasher.add(std::span<const std::uint16_t>(scratch.old_planes));
  hasher.add(std::span<const double>(scratch.aabb_low.z));
  hash_frames(scratch, hasher);
}

}  // namespace tumble::sim
