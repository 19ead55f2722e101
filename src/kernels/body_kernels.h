#pragma once

#include <cstddef>
#include <cstdint>

namespace tumble::sim {

/// Pointers to the columns of Bodies.
struct BodyColumns {
  const std::uint8_t *frozen = nullptr, *is_static = nullptr;
  double *position[3] = {}, *orientation[4] = {}, *velocity[3] = {}, *spin[3] = {};
  const double *inertia[3] = {}, *half_extent[3] = {};
};

/// Rows [begin, end).
struct Rows {
  std::size_t begin = 0, end = 0;
};

/// Gravity and air drag in a free flight, one value for all bodies.
struct Air {
  double dt_s = 0;
  double gain[3] = {};  ///< m/s, on the velocity grid
  bool drags = false;
  double slower = 1;  ///< divisor of velocities where the air drags
};

/// Where put_boxes() writes the boxes of bodies. Without `framed` it writes all boxes; without fat AABBs every box
/// counts as outside.
struct BoxColumns {
  double* frames = nullptr;                          ///< rows of BoxFrame
  double *low[3] = {}, *high[3] = {};                ///< of the AABBs
  std::uint8_t* framed = nullptr;                    ///< Scratch::framed
  bool fat = false;                                  ///< whether fat_low and fat_high hold anything
  const double *fat_low[3] = {}, *fat_high[3] = {};  ///< SweepScratch::fat_low and fat_high
};

/// AABBs that expand_aabbs() widens to hold the boxes throughout a step.
struct ReachColumns {
  double around = 0;  ///< m, margin of every AABB beyond the motion of its box
  double dt_s = 0;
  double* turning = nullptr;           ///< written: m, the way of corners by turning, at most
  double *low[3] = {}, *high[3] = {};  ///< read and written
};

/// Functions that treat each body by itself.
struct BodyKernels {
  /// Moves the bodies in free flight that are neither frozen, static nor `in_contact` (null: none is) and have equal
  /// moments of inertia. Returns whether bodies with different moments are left to move.
  bool (*integrate_free)(const BodyColumns& bodies, Rows rows, const std::uint8_t* in_contact, const Air& air);
  /// Writes boxes and AABBs at the places of the bodies, except the framed ones. Returns whether every AABB written
  /// lies in its fat AABB.
  bool (*put_boxes)(const BodyColumns& bodies, Rows rows, const BoxColumns& boxes);
  /// Widens the AABBs by the motion of a step and by the margin.
  void (*expand_aabbs)(const BodyColumns& bodies, Rows rows, const ReachColumns& reach);
  /// Whether every body is finite and within limits; false where check_body would refuse one.
  bool (*check)(const BodyColumns& bodies, Rows rows);
};

}  // namespace tumble::sim
