#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/kernels/body_kernels.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Puts every body's box and its AABB where the body is now. The extents are rounded outwards to the position grid, so
/// that a shifted scene has the same overlaps.
void update_frames(Bodies& bodies, Scratch& scratch);

/// Where the boxes of n bodies are written, with room for them.
BoxColumns box_columns_of(Scratch& scratch, std::size_t n);

/// Where they are and how they are turned.
void hash_frames(const Scratch& scratch, Hasher& hasher);

/// So many pairs may be near one another. n bodies in one place have n² / 2, and a small log could fill the memory.
constexpr std::size_t near_pairs_max(std::size_t bodies) { return (std::size_t{1} << 20) + 128 * bodies; }

/// Errors (kCannotFinish) where a sweep has found more; it stopped soon after.
Status check_crowd(const Scratch& scratch);

/// Sorts the pairs in sweep.found by (a, b), a < n: by counting for a, directly for the few b of one a. The partners of
/// a are then sweep.partner[sweep.start[a]] up to sweep.start[a + 1].
void sort_pairs(Scratch& scratch);

/// The column of an axis (0, 1, 2).
inline const std::vector<double>& column_of(const Vec3Column& columns, int axis) {
  return axis == 0 ? columns.x : axis == 1 ? columns.y : columns.z;
}

/// Gives each box room around it, in sweep.low and high, and finds its neighbours: the pairs whose rooms overlap on all
/// three axes, ascending by (a, b). While every box is in its room, no others can overlap (Verlet 1967). Sweep and
/// prune along the axis that meets the fewest; that choice, the room and how long it lasts show in nothing but time.
void renew_neighbours(const Vec3Column& velocity, double dt_s, Scratch& scratch);

/// Replaces the pair list by those neighbours whose AABBs overlap on all three axes (touching counts). A pair that was
/// in the list keeps its planes. Precondition: every box is in its room.
void find_overlaps(Scratch& scratch, PairTable& pairs);

}  // namespace tumble::sim
