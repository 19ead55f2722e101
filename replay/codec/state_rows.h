#pragma once

#include <vector>

#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// The bodies of a chunk at each step and their last stored states: the rows of the keyframe, changed by throws and
/// removes. The encoder and the decoder of states each keep one, so that ids need not be stored.
class StateRows {
 public:
  explicit StateRows(const sim::WorldState& keyframe);

  /// Applies an input before the next step: inserts or removes a row, changes gravity or a velocity. Errors (kDamaged):
  /// the id of a throw is taken, or another id does not exist.
  Status apply(const sim::Command& command);

  /// The last stored state, with the current rows. A thrown body has its values from the throw.
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
  std::uint64_t moved_rows_ = 0;  // by insertions and removals; limited by kRowMovesMax
};

}  // namespace tumble::replay
