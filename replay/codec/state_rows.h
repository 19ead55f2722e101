#pragma once

#include <vector>

#include "replay/format/step_record.h"
#include "src/base/result.h"
#include "src/world/world_state.h"

namespace tumble::replay {

/// Who is in a chunk's states at each step, and what they were last: the keyframe, changed by throws and removes. The
/// encoder and the decoder of states each keep one, and so agree without storing ids.
class StateRows {
 public:
  explicit StateRows(const sim::WorldState& keyframe);

  /// Applies an input that precedes the next step: bodies come and go, gravity and velocities change. Errors
  /// (kDamaged): an id that is taken or does not exist.
  Status apply(const sim::Command& command);

  /// The state stored last, with rows as they are now; a thrown body stands where it was thrown.
  [[nodiscard]] const BodyStates& before() const { return before_; }
  BodyStates& mutable_before() { return before_; }

  [[nodiscard]] const sim::Vec3Column& inertia() const { return inertia_; }  ///< kg·m²; zero for statics
  [[nodiscard]] const sim::Vec3& gravity() const { return gravity_; }
  [[nodiscard]] double air_drag() const { return air_drag_; }

 private:
  Status insert(const sim::BoxDef& box);
  Status remove(sim::BodyId id);
  Status set_velocity(const sim::SetVelocity& command);
  [[nodiscard]] std::size_t row_of(sim::BodyId id) const;  // or where it would be
  Status count_move(std::size_t rows);

  BodyStates before_;
  sim::Vec3Column inertia_;
  sim::Vec3 gravity_;
  double air_drag_;
  std::uint64_t moved_rows_ = 0;  // by insertions and removals, against limits.h
};

}  // namespace tumble::replay
