#include "replay/codec/state_codec.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

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

/// Whether all values of a column lie on its grid. Nearly always all do and are small, which a few operations for each
/// value tell: rounding then changes no bit, not even the sign of a zero.
bool all_on_grid(const std::vector<double>& column, double steps_per_unit) {
  std::uint64_t changed = 0;
  bool small = true;
  for (const double value : column) {
    const double steps = value * steps_per_unit;
    changed |= bits_of((steps + codec1::kRounder) - codec1::kRounder) ^ bits_of(steps);
    small &= std::fabs(steps) < codec1::kKeyMax;
  }
  if (changed == 0 && small) return true;
  return std::ranges::all_of(column, [=](double value) { return codec1::is_on_grid(value, steps_per_unit); });
}

}  // namespace

void StateEncoder::begin(const sim::WorldState& keyframe) {
  keyframe_ = &keyframe;
  rows_.emplace(keyframe);
  dt_ = 0;
  out_.flags.clear();
  for (auto& column : out_.residuals) column.clear();
  for (std::size_t c = 0; c < kColumnCount; ++c) out_.on_grid[c] = codec1::steps_per_unit(c) != 0;
}

Status StateEncoder::add(const StepRecord& record, std::span<const StepRecord> earlier) {
  if (Status ok = encode(record, earlier); !ok.ok()) return ok;
  if (record.has_states) rows_->mutable_before() = record.states;
  return {};
}

Status StateEncoder::take(StepRecord& record, std::span<const StepRecord> earlier) {
  if (Status ok = encode(record, earlier); !ok.ok()) return ok;
  if (record.has_states) std::swap(rows_->mutable_before(), record.states);
  return {};
}

// The sum of dt over steps whose states are not stored lets the prediction cover the whole interval since the last
// stored state. The decoder does the same.
Status StateEncoder::encode(const StepRecord& record, std::span<const StepRecord> earlier) {
  if (Status ok = leave_grids(record, earlier); !ok.ok()) return ok;
  for (const sim::Command& command : record.inputs) {
    if (Status ok = rows_->apply(command); !ok.ok()) return cannot_finish(ok.error().message);
  }
  dt_ += record.dt;
  if (!record.has_states) return {};
  if (Status ok = encode_step(record); !ok.ok()) return ok;
  dt_ = 0;
  return {};
}

// The stepper keeps velocities and positions on grids (src/math/grid.h), so their differences in grid steps are much
// smaller than differences of bit patterns. One value off the grid, as another engine writes, sends the whole column of
// the chunk to bit patterns: one flag per column is cheaper than one per value, and columns are either all on the grid
// or hardly at all. What was encoded before the first such value is encoded again, which other engines need in a first
// step, where nothing is, and ours never.
Status StateEncoder::leave_grids(const StepRecord& record, std::span<const StepRecord> earlier) {
  if (!record.has_states) return {};
  std::array<bool, kColumnCount> on_grid = out_.on_grid;
  const ConstColumns columns = columns_of(record.states);
  for (std::size_t c = 0; c < kColumnCount; ++c) {
    if (on_grid[c]) on_grid[c] = all_on_grid(*columns[c], codec1::steps_per_unit(c));
  }
  if (on_grid == out_.on_grid) return {};
  const bool none_stored = out_.residuals[0].empty();
  if (!none_stored) {
    StateDecoder decoder(*keyframe_, std::exchange(out_, {}));
    begin(*keyframe_);
    out_.on_grid = on_grid;
    for (std::size_t i = 0; i < earlier.size(); ++i) {
      StepRecord step;
      step.step = earlier[i].step;
      step.dt = earlier[i].dt;
      step.inputs = earlier[i].inputs;
      step.has_states = earlier[i].has_states;
      if (Status ok = decoder.decode(step); !ok.ok()) return ok;
      if (Status ok = take(step, earlier.first(i)); !ok.ok()) return ok;
    }
  }
  out_.on_grid = on_grid;
  return {};
}

Status StateEncoder::encode_step(const StepRecord& record) {
  const BodyStates& states = record.states;
  const BodyStates& before = rows_->before();
  bool complete = states.id == before.id && states.frozen.size() == states.size();
  for (const auto* column : columns_of(states)) complete = complete && column->size() == states.size();
  if (!complete) {
    return cannot_finish("step " + std::to_string(record.step) + ": found the states of " +
                         std::to_string(states.size()) + " bodies, wanted the " + std::to_string(before.size()) +
                         " that the start and the logged inputs leave");
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states.frozen[i] > 1) return cannot_finish("step " + std::to_string(record.step) + ": frozen is not 0 or 1");
    encode_body(states, i);
  }
  return {};
}

void StateEncoder::encode_body(const BodyStates& states, std::size_t i) {
  const codec1::Motion before = codec1::motion_of(rows_->before(), i);
  const codec1::Row after = codec1::row_of(codec1::motion_of(states, i));
  const std::uint8_t kind = motion_kind(*rows_, i, before, after, dt_);
  const bool frozen = states.frozen[i] != 0;
  out_.flags.push_back(static_cast<std::uint8_t>(kind | (frozen ? kFrozenFlag : 0)));
  if (kind != kStored) return;
  codec1::code_row(before, frozen, dt_, [&](std::size_t slot, std::size_t column, double predicted) {
    const double steps = codec1::steps_per_unit(column);
    const bool on_grid = out_.on_grid[column];
    const std::uint64_t key = codec1::key_of(after[column], steps, on_grid);
    out_.residuals[slot].push_back(codec1::zigzag(key - codec1::predicted_key(predicted, steps, on_grid)));
    return after[column];
  });
}

void StateEncoder::copy_to(schema::States::Builder out) const {
  out.setCodec(kStateCodec);
  put_plain(std::span<const std::uint8_t>(out_.flags), out.initFlags(static_cast<unsigned>(out_.flags.size())));
  auto columns = out.initColumns(kColumnCount);
  for (unsigned c = 0; c < kColumnCount; ++c) {
    columns[c].setOnGrid(out_.on_grid[c]);
    put_planes(std::span<const std::uint64_t>(out_.residuals[c]),
               columns[c].initResiduals(static_cast<unsigned>(out_.residuals[c].size() * 8)));
  }
}

StateDecoder::StateDecoder(const sim::WorldState& keyframe, schema::States::Reader in)
    : rows_(keyframe), codec_(in.getCodec()) {
  const capnp::Data::Reader flags = in.getFlags();
  in_.flags.assign(flags.begin(), flags.end());
  std::size_t stored = 0;
  for (const std::uint8_t flag : in_.flags) stored += (flag & kMotionMask) == kStored ? 1 : 0;
  const auto columns = in.getColumns();
  column_count_ = columns.size();
  for (unsigned c = 0; c < kColumnCount && c < columns.size(); ++c) {
    in_.on_grid[c] = columns[c].getOnGrid() && codec1::steps_per_unit(c) != 0;
    const capnp::Data::Reader residuals = columns[c].getResiduals();
    sizes_agree_ = sizes_agree_ && get_planes("states", residuals, stored, in_.residuals[c]).ok();
  }
}

StateDecoder::StateDecoder(const sim::WorldState& keyframe, StateColumns columns)
    : rows_(keyframe), codec_(kStateCodec), column_count_(kColumnCount), in_(std::move(columns)) {}

Status StateDecoder::check(std::size_t step_count) const {
  if (in_.flags.empty()) return {};  // no states
  if (codec_ != kStateCodec) {
    return bad_input("the states are stored with codec " + std::to_string(codec_) +
                     ", this program knows codec 1; use a newer one");
  }
  if (step_count > 1 && in_.flags.size() > kBodyStepsRead) {
    return damaged("found the states of " + std::to_string(in_.flags.size()) + " bodies and steps, wanted at most " +
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
  if (in_.flags.size() - next_flag_ < before.size()) {
    return damaged("states: found " + std::to_string(in_.flags.size()) + " flags, wanted more for step " +
                   std::to_string(record.step));
  }
  for (std::size_t i = 0; i < before.size(); ++i) decode_body(before, i, in_.flags[next_flag_++]);
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
  SIM_DCHECK(at < in_.residuals[0].size(), at, in_.residuals[0].size());
  return codec1::code_row(before, frozen, dt_, [&](std::size_t slot, std::size_t column, double predicted) {
    const double steps = codec1::steps_per_unit(column);
    const std::uint64_t expected = codec1::predicted_key(predicted, steps, in_.on_grid[column]);
    return codec1::value_of(expected + codec1::unzigzag(in_.residuals[slot][at]), steps, in_.on_grid[column]);
  });
}

}  // namespace tumble::replay
