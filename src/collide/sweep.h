#pragma once

#include "src/kernels/body_kernels.h"
#include "src/world/scratch.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Writes the box and the AABB of every body at its present place. The extents are rounded outwards to the position
/// grid, so that a shifted scene has the same overlaps. With a hasher, adds the frames as hash_frames() does.
void update_frames(Bodies& bodies, Scratch& scratch, Hasher* hasher = nullptr);

/// Pointers to frames and AABBs of n bodies; makes the columns that long.
BoxColumns box_columns_of(Scratch& scratch, std::size_t n);

/// Adds all frames to the hash.
void hash_frames(const Scratch& scratch, Hasher& hasher);

/// The limit of near pairs. n bodies in one place make n² / 2 pairs, and a small log could fill the memory.
constexpr std::size_t near_pairs_max(std::size_t bodies) { return (std::size_t{1} << 20) + 128 * bodies; }

/// Errors: kCannotFinish when the last sweep found more pairs than that; the sweep then stopped early.
Status check_crowd(const Scratch& scratch);

/// What each of several workers does, who has found sweep.found_by: sorts the pairs of all by (a, b), by a counting
/// sort for a, then a direct sort of the few b of each a. When the workers have met, the partners of a are
/// sweep.partner[k] for sweep.start[a] <= k < sweep.start[a + 1].
void sort_pairs(Scratch& scratch, std::size_t bodies, const Worker& worker);

/// The column of an axis (0, 1, 2).
inline const std::vector<double>& column_of(const Vec3Column& columns, int axis) {
  return axis == 0 ? columns.x : axis == 1 ? columns.y : columns.z;
}

/// Widens each AABB to a fat AABB and finds the neighbours: the pairs whose fat AABBs overlap on all three axes,
/// ascending by (a, b). While every AABB lies in its fat AABB, no other pairs can overlap (Verlet 1967). Sweep and
/// prune along the axis that meets the fewest. The choice of the axis, the margin and the age of the list change
/// nothing but time.
void renew_neighbours(const Vec3Column& velocity, double dt_s, Scratch& scratch);

/// Replaces the pair list by those neighbours whose AABBs overlap on all three axes (touching counts). A pair that was
/// in the list keeps its planes. Precondition: every AABB lies in its fat AABB.
void find_overlaps(Scratch& scratch, PairTable& pairs);

}  // namespace tumble::sim
