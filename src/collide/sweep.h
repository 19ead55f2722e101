#pragma once

#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/world/scratch.h"
#include "src/world/world_state.h"

namespace tumble::sim {

/// Puts every body's box and its AABB where the body is now. The extents are rounded outwards to the position grid, so
/// that a shifted scene has the same overlaps.
void update_frames(const Bodies& bodies, Scratch& scratch);

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

/// Replaces the pair list by the pairs whose AABBs overlap on all three axes (touching counts), ascending by (a, b). A
/// pair that was in the list keeps its planes. Sweep and prune along the axis that meets the fewest; the list is a set,
/// so that choice shows in nothing but time.
void find_overlaps(Scratch& scratch, PairTable& pairs);

}  // namespace tumble::sim
