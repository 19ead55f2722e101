#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "replay/view/viewed_bodies.h"
#include "tumble/replay/body_states.h"

namespace tumble::replay {

/// States of a session, rounded and packed for a page that travels: positions to kQuantum, orientations to 1/32767.
/// Compresses well: each number is kept as its distance from where the two frames before would lead.
class PackedStates {
 public:
  static constexpr double kQuantum = 1e-4;  ///< m

  /// Adds the state after a step; steps ascend.
  void add(std::uint64_t step, const BodyStates& states, ViewedBodies& table);

  [[nodiscard]] const std::vector<std::uint64_t>& steps() const { return steps_; }

  /// The frames with these indices, ascending. Bytes, for F frames and N bodies (rows of the table), all body by body,
  /// frame after frame: planes 0 … 3 (low byte first) of x, y, z residuals in zigzag (12 F N), planes 0 and 1 of w, x,
  /// y, z (8 F N), and the BodyMark (F N). A body that a frame does not draw keeps the numbers of the frame before.
  [[nodiscard]] std::string planes(const std::vector<std::size_t>& frames, std::size_t bodies) const;

 private:
  struct Frame {
    std::vector<std::int32_t> place;  // 3 a row
    std::vector<std::int16_t> turn;   // 4 a row
    std::vector<std::uint8_t> mark;
  };
  std::vector<std::uint64_t> steps_;
  std::vector<Frame> frames_;
};

}  // namespace tumble::replay
