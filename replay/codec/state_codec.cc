#include "replay/codec/state_codec.h"

#include <cstring>
#include <string>

#include "replay/codec/blob.h"
#include "replay/codec/state_keys.h"
#include "replay/format/limits.h"
#include "src/base/check.h"

namespace tumble::replay {
namespace {

constexpr std::uint8_t kFrozenFlag = 1;
constexpr std::uint8_t kMotionMask = 6;
constexpr std::uint8_t kUnchanged = 0;
constexpr std::uint8_t kFlown = 2;   // as free flight predicts, to the bit
constexpr std::uint8_t kStored = 4;  // differences are stored

/// How row i moved from `before` to `after`.
///
/// Free flight is compared in two stages because its second half, the rotation, is expensive. A body that touches
/// something nearly always shows a velocity other than that of free fall, so the cheap first stage decides most cases.
std::uint8_t motion_kind(const StateRows& rows, std::size_t i, const codec1::Motion& before, const codec1::Row& after,
                         double dt) {
  if (codec1::same_bits(codec1::row_of(before), after)) return kUnchanged;
  const sim::Vec3& g = rows.gravity();
  const codec1::V3 fallen = codec1::fall(before.velocity, {g.x(), g.y(), g.z()}, rows.air_drag(), dt);
  if (fallen.x != after[0] || fallen.y != after[1] || fallen.z != after[2]) return kStored;
  return codec1::same_bits(codec1::row_of(codec1::fly(rows, i, before, dt)), after) ? kFlown : kStored;
}

/// Whether all values of a column lie on its grid, over all stored steps of the chunk.
///
/// The stepper keeps velocities and positions on grids (src/math/grid.h), so their differences in grid steps are much
/// smaller than differences of bit patterns. One value off the grid, as another engine writes, sends the whole column
/// to bit patterns: one flag per column is cheaper than one per value, and columns are either all on the grid or hardly
/// at all.
bool column_on_grid(std::span<const StepRecord> records, std::size_t column) {
  const double steps = codec1::steps_per_unit(column);
  if (steps == 0) return false;
  for (const StepRecord& record : records) {
    if (!record.has_states) continue;
    for (const double value : *columns_of(record.states)[column]) {
      if (!codec1::is_on_grid(value, steps)) return false;
    }
  }
  return true;
}

}  // namespace

void StateEncoder::choose_grids(std::span<const StepRecord> records) {
  for (std::size_t c = 0; c < kColumnCount; ++c) on_grid_[c] = column_on_grid(records, c);
}

// `dt` is summed over steps whose states are not stored, so that the prediction covers the whole interval since the
// last stored state. The decoder does the same.
Status StateEncoder::encode(const sim::WorldState& keyframe, std::span<const StepRecord> records) {
  flags_.clear();
  for (auto& column : residuals_) column.clear();
  choose_grids(records);
  StateRows rows(keyframe);
  double dt = 0;
  for (const StepRecord& record : records) {
    for (const sim::Command& command : record.inputs) {
      if (Status ok = rows.apply(command); !ok.ok()) return cannot_finish(ok.error().message);
    }
    dt += record.dt;
    if (!record.has_states) continue;
    if (Status ok = encode_step(rows, record, dt); !ok.ok()) return ok;
    rows.mutable_before() = record.states;
    dt = 0;
  }
  return {};
}

Status StateEncoder::encode_step(const StateRows& rows, const StepRecord& record, double dt) {
  const BodyStates& states = record.states;
  bool complete = states.id == rows.before().id && states.frozen.size() == states.size();
  for (const auto* column : columns_of(states)) complete = complete && column->size() == states.size();
  if (!complete) {
    return cannot_finish("step " + std::to_string(record.step) + ": found the states of " +
                         std::to_string(states.size()) + " bodies, wanted the " + std::to_string(rows.before().size()) +
                         " that the start and the logged inputs leave");
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states.frozen[i] > 1) return cannot_finish("step " + std::to_string(record.step) + ": frozen is not 0 or 1");
    encode_body(rows, states, i, dt);
  }
  return {};
}

void StateEncoder::encode_body(const StateRows& rows, const BodyStates& states, std::size_t i, double dt) {
  const codec1::Motion before = codec1::motion_of(rows.before(), i);
  const codec1::Row after = codec1::row_of(codec1::motion_of(states, i));
  const std::uint8_t kind = motion_kind(rows, i, before, after, dt);
  const bool frozen = states.frozen[i] != 0;
  flags_.push_back(static_cast<std::uint8_t>(kind | (frozen ? kFrozenFlag : 0)));
  if (kind != kStored) return;
  codec1::code_row(before, frozen, dt, [&](std::size_t slot, std::size_t column, double predicted) {
    const double steps = codec1::steps_per_unit(column);
    const std::uint64_t key = codec1::key_of(after[column], steps, on_grid_[column]);
    residuals_[slot].push_back(codec1::zigzag(key - codec1::predicted_key(predicted, steps, on_grid_[column])));
    return after[column];
  });
}

void StateEncoder::copy_to(schema::States::Builder out) const {
  out.setCodec(kStateCodec);
  put_plain(std::span<const std::uint8_t>(flags_), out.initFlags(static_cast<unsigned>(flags_.size())));
  auto columns = out.initColumns(kColumnCount);
  for (unsigned c = 0; c < kColumnCount; ++c) {
    columns[c].setOnGrid(on_grid_[c]);
    put_planes(std::span<const std::uint64_t>(residuals_[c]),
               columns[c].initResiduals(static_cast<unsigned>(residuals_[c].size() * 8)));
  }
}

StateDecoder::StateDecoder(const sim::WorldState& keyframe, schema::States::Reader in)
    : rows_(keyframe), codec_(in.getCodec()) {
  const capnp::Data::Reader flags = in.getFlags();
  flags_.assign(flags.begin(), flags.end());
  std::size_t stored = 0;
  for (const std::uint8_t flag : flags_) stored += (flag & kMotionMask) == kStored ? 1 : 0;
  const auto columns = in.getColumns();
  column_count_ = columns.size();
  for (unsigned c = 0; c < kColumnCount && c < columns.size(); ++c) {
    on_grid_[c] = columns[c].getOnGrid() && codec1::steps_per_unit(c) != 0;
    const capnp::Data::Reader residuals = columns[c].getResiduals();
    sizes_agree_ = sizes_agree_ && get_planes("states", residuals, stored, residuals_[c]).ok();
  }
}

Status StateDecoder::check(std::size_t step_count) const {
  if (flags_.empty()) return {};  // no states
  if (codec_ != kStateCodec) {
    return bad_input("the states are stored with codec " + std::to_string(codec_) +
                     ", this program knows codec 1; use a newer one");
  }
  if (step_count > 1 && flags_.size() > kBodyStepsRead) {
    return damaged("found the states of " + std::to_string(flags_.size()) + " bodies and steps, wanted at most " +
                   std::to_string(kBodyStepsRead));
  }
  if (column_count_ == kColumnCount && sizes_agree_) return {};
  return damaged("the columns of states do not have the lengths that their flags ask for");
}

Status StateDecoder::decode(StepRecord& record) {
  for (const sim::Command& command : record.inputs) {
    if (Status ok = rows_.apply(command); !ok.ok()) return ok;
  }
  dt_ += record.dt;
  if (!record.has_states) return {};
  BodyStates& before = rows_.mutable_before();
  if (flags_.size() - next_flag_ < before.size()) {
    return damaged("states: found " + std::to_string(flags_.size()) + " flags, wanted more for step " +
                   std::to_string(record.step));
  }
  for (std::size_t i = 0; i < before.size(); ++i) decode_body(before, i, flags_[next_flag_++]);
  record.states = before;
  dt_ = 0;
  return {};
}

void StateDecoder::decode_body(BodyStates& states, std::size_t i, std::uint8_t flag) {
  const bool frozen = (flag & kFrozenFlag) != 0;
  states.frozen[i] = frozen ? 1 : 0;
  const std::uint8_t kind = flag & kMotionMask;
  if (kind == kUnchanged) return;
  const codec1::Motion before = codec1::motion_of(states, i);
  const codec1::Row row =
      kind == kStored ? decode_row(before, frozen) : codec1::row_of(codec1::fly(rows_, i, before, dt_));
  const Columns columns = columns_of(states);
  for (std::size_t c = 0; c < kColumnCount; ++c) (*columns[c])[i] = row[c];
}

codec1::Row StateDecoder::decode_row(const codec1::Motion& before, bool frozen) {
  const std::size_t at = next_residual_++;
  SIM_DCHECK(at < residuals_[0].size(), at, residuals_[0].size());
  return codec1::code_row(before, frozen, dt_, [&](std::size_t slot, std::size_t column, double predicted) {
    const double steps = codec1::steps_per_unit(column);
    const std::uint64_t expected = codec1::predicted_key(predicted, steps, on_grid_[column]);
    return codec1::value_of(expected + codec1::unzigzag(residuals_[slot][at]), steps, on_grid_[column]);
  });
}

}  // namespace tumble::replay
