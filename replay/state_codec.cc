#include "replay/state_codec.h"

#include <cstring>
#include <string>

#include "replay/blob.h"
#include "replay/limits.h"
#include "replay/state_keys.h"

namespace tumble::replay {
namespace {

constexpr std::uint8_t kFrozenFlag = 1;
constexpr std::uint8_t kChangedFlag = 2;

bool same_row(const ConstColumns& a, const ConstColumns& b, std::size_t i) {
  std::uint64_t difference = 0;
  for (std::size_t c = 0; c < kColumnCount; ++c) difference |= bits_of((*a[c])[i]) ^ bits_of((*b[c])[i]);
  return difference == 0;
}

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
  const ConstColumns after = columns_of(states);
  const ConstColumns before = columns_of(rows.before());
  bool complete = states.id == rows.before().id && states.frozen.size() == states.size();
  for (const auto* column : after) complete = complete && column->size() == states.size();
  if (!complete) {
    return cannot_finish("step " + std::to_string(record.step) + ": found the states of " +
                         std::to_string(states.size()) + " bodies, wanted the " + std::to_string(rows.before().size()) +
                         " that the start and the logged inputs leave");
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states.frozen[i] > 1) return cannot_finish("step " + std::to_string(record.step) + ": frozen is not 0 or 1");
    const bool frozen = states.frozen[i] != 0;
    const bool changed = !same_row(after, before, i);
    flags_.push_back(static_cast<std::uint8_t>((frozen ? kFrozenFlag : 0) | (changed ? kChangedFlag : 0)));
    if (changed) encode_body(rows, after, i, frozen, dt);
  }
  return {};
}

void StateEncoder::encode_body(const StateRows& rows, const ConstColumns& after, std::size_t i, bool frozen,
                               double dt) {
  const auto predicted = codec1::predict_row(rows, i, frozen, dt);
  for (std::size_t c = 0; c < kColumnCount; ++c) {
    const double steps = codec1::steps_per_unit(c);
    const std::uint64_t found = codec1::key_of((*after[c])[i], steps, on_grid_[c]);
    residuals_[c].push_back(codec1::zigzag(found - codec1::predicted_key(predicted[c], steps, on_grid_[c])));
  }
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
  std::size_t changed = 0;
  for (const std::uint8_t flag : flags_) changed += (flag & kChangedFlag) != 0 ? 1 : 0;
  const auto columns = in.getColumns();
  column_count_ = columns.size();
  for (unsigned c = 0; c < kColumnCount && c < columns.size(); ++c) {
    on_grid_[c] = columns[c].getOnGrid() && codec1::steps_per_unit(c) != 0;
    const capnp::Data::Reader residuals = columns[c].getResiduals();
    sizes_agree_ = sizes_agree_ && get_planes("states", residuals, changed, residuals_[c]).ok();
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
  const Columns columns = columns_of(before);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const std::uint8_t flag = flags_[next_flag_++];
    const bool frozen = (flag & kFrozenFlag) != 0;
    if ((flag & kChangedFlag) != 0) decode_body(columns, i, frozen);
    before.frozen[i] = frozen ? 1 : 0;
  }
  record.states = before;
  dt_ = 0;
  return {};
}

void StateDecoder::decode_body(const Columns& columns, std::size_t i, bool frozen) {
  const auto predicted = codec1::predict_row(rows_, i, frozen, dt_);
  for (std::size_t c = 0; c < kColumnCount; ++c) {
    const double steps = codec1::steps_per_unit(c);
    const std::uint64_t key =
        codec1::predicted_key(predicted[c], steps, on_grid_[c]) + codec1::unzigzag(residuals_[c][next_residual_]);
    (*columns[c])[i] = codec1::value_of(key, steps, on_grid_[c]);
  }
  ++next_residual_;
}

}  // namespace tumble::replay
