#include "replay/codec/state_rows.h"

#include <algorithm>
#include <string>

#include "replay/format/limits.h"
#include "src/model/mass.h"

namespace tumble::replay {

StateRows::StateRows(const sim::WorldState& keyframe)
    : inertia_(keyframe.bodies.inertia), gravity_(keyframe.def.gravity), air_drag_(keyframe.def.air_drag) {
  copy_visible(keyframe.bodies, before_);
}

Status StateRows::apply(const sim::Command& command) {
  if (const auto* c = std::get_if<sim::Throw>(&command)) return insert(c->box);
  if (const auto* c = std::get_if<sim::Remove>(&command)) return remove(c->id);
  if (const auto* c = std::get_if<sim::SetVelocity>(&command)) return set_velocity(*c);
  if (const auto* c = std::get_if<sim::SetGravity>(&command)) gravity_ = c->gravity;
  return {};  // other inputs make the next prediction less exact, which only costs space
}

std::size_t StateRows::row_of(sim::BodyId id) const {
  return static_cast<std::size_t>(std::lower_bound(before_.id.begin(), before_.id.end(), id) - before_.id.begin());
}

Status StateRows::count_move(std::size_t rows) {
  moved_rows_ += rows;
  if (moved_rows_ <= kRowMovesMax) return {};
  return damaged("throws and removes of one chunk move more than " + std::to_string(kRowMovesMax) + " rows");
}

// A throw in the middle of the columns moves all rows behind it, so a file with many throws could cost quadratic time.
// count_move() ends such a chunk with an error.
Status StateRows::insert(const sim::BoxDef& box) {
  const std::size_t row = row_of(box.id);
  if (box.id == 0 || box.id > sim::kBodyIdMax || (row < before_.size() && before_.id[row] == box.id)) {
    return damaged("an input throws body " + std::to_string(box.id) + ", which is there already or is no id");
  }
  if (Status ok = count_move(before_.size() - row); !ok.ok()) return ok;
  before_.id.insert(before_.id.begin() + static_cast<std::ptrdiff_t>(row), box.id);
  before_.position.insert(row, box.position);
  before_.orientation.insert(row, box.orientation);
  before_.velocity.insert(row, box.velocity);
  before_.spin.insert(row, box.spin);
  before_.frozen.insert(before_.frozen.begin() + static_cast<std::ptrdiff_t>(row), box.frozen ? 1 : 0);
  inertia_.insert(row, box.is_static ? sim::Vec3(0, 0, 0) : sim::box_inertia(box.mass, box.size));
  return {};
}

Status StateRows::remove(sim::BodyId id) {
  const std::size_t row = row_of(id);
  if (row == before_.size() || before_.id[row] != id) {
    return damaged("an input removes body " + std::to_string(id) + ", which is not there");
  }
  if (Status ok = count_move(before_.size() - row); !ok.ok()) return ok;
  before_.id.erase(before_.id.begin() + static_cast<std::ptrdiff_t>(row));
  before_.position.erase(row);
  before_.orientation.erase(row);
  before_.velocity.erase(row);
  before_.spin.erase(row);
  before_.frozen.erase(before_.frozen.begin() + static_cast<std::ptrdiff_t>(row));
  inertia_.erase(row);
  return {};
}

Status StateRows::set_velocity(const sim::SetVelocity& command) {
  const std::size_t row = row_of(command.id);
  if (row == before_.size() || before_.id[row] != command.id) {
    return damaged("an input sets the velocity of body " + std::to_string(command.id) + ", which is not there");
  }
  before_.velocity.set(row, command.velocity);
  before_.spin.set(row, command.spin);
  return {};
}

}  // namespace tumble::replay
