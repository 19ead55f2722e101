#pragma once

#include <cstddef>
#include <cstdint>

namespace tumble::sim {

/// Where the columns of Bodies lie.
struct BodyColumns {
  const std::uint8_t *frozen = nullptr, *is_static = nullptr;
  double *position[3] = {}, *orientation[4] = {}, *velocity[3] = {}, *spin[3] = {};
  const double *inertia[3] = {}, *half_extent[3] = {};
};

/// Rows [begin, end).
struct Rows {
  std::size_t begin = 0, end = 0;
};

/// What gravity and the air do in a flight, to all bodies alike.
struct Air {
  double dt_s = 0;
  double gain[3] = {};  ///< m/s, on the velocity grid
  bool drags = false;
  double slower = 1;  ///< what velocities are divided by where it drags
};

/// Where the boxes of bodies are written. Without `framed` all are; without rooms all are taken to have left them.
struct BoxColumns {
  double* frames = nullptr;            ///< rows of BoxFrame
  double *low[3] = {}, *high[3] = {};  ///< of the AABBs
  std::uint8_t* framed = nullptr;      ///< Scratch::framed
  bool rooms = false;
  const double *room_low[3] = {}, *room_high[3] = {};  ///< SweepScratch::low and high
};

/// AABBs that are to be widened to where the boxes may come within a step.
struct ReachColumns {
  double around = 0;  ///< m, what all of them reach beyond their motion
  double dt_s = 0;
  double* turning = nullptr;           ///< written: m, how far corners may come by turning
  double *low[3] = {}, *high[3] = {};  ///< read and written
};

/// What is done to each body by itself, compiled once for each lane width.
struct BodyKernels {
  /// Free flight of every body that moves, is not `in_contact` (null: none is) and whose moments of inertia are equal.
  /// Tells whether others are left that should fly.
  bool (*integrate_free)(const BodyColumns& bodies, Rows rows, const std::uint8_t* in_contact, const Air& air);
  /// Puts boxes and AABBs where the bodies are, but for the framed ones; tells whether all are in their rooms.
  bool (*put_boxes)(const BodyColumns& bodies, Rows rows, const BoxColumns& boxes);
  void (*expand_aabbs)(const BodyColumns& bodies, Rows rows, const ReachColumns& reach);
  /// Whether all are finite and within limits: false where check_body would object to one.
  bool (*check)(const BodyColumns& bodies, Rows rows);
};

}  // namespace tumble::sim
