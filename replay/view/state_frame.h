#pragma once

#include <cstdint>
#include <string>

#include "replay/view/viewed_bodies.h"
#include "tumble/replay/body_states.h"

namespace tumble::replay {

/// How a body stands in a frame.
enum class BodyMark : std::uint8_t {
  kAbsent = 0,  ///< not yet thrown, or removed
  kAwake = 1,
  kFrozen = 2,
  kNotFinite = 3,  ///< a field of its state is infinite or no number, so it is not drawn
};

BodyMark mark_of(const BodyStates& states, std::size_t row);

/// Whether a frame shows a state.
enum class FrameStatus : std::uint32_t {
  kShown = 0,
  kNotHeld = 1,  ///< in no intact chunk
  kUnread = 2,   ///< the chunk cannot be decoded, or the state cannot be computed
};

/// Appends one state for a viewer, little-endian and rounded to be drawn:
///   u32 step, u32 FrameStatus, u32 rows, u32 version of the table
///   f32 x, y, z (m) and speed (m/s): rows of each in turn, then i16 w, x, y, z (32767 for 1), then u8 BodyMark, padded
///   to a multiple of 4 bytes
/// `states` may be null: no rows follow then.
void append_frame(std::uint64_t step, FrameStatus status, const BodyStates* states, ViewedBodies& table,
                  std::string& out);

}  // namespace tumble::replay
