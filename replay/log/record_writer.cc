#include "replay/log/record_writer.h"

#include <utility>

#include "replay/codec/header_codec.h"
#include "replay/codec/index_codec.h"
#include "replay/format/chain.h"
#include "replay/format/limits.h"
#include "src/base/check.h"

namespace tumble::replay {
namespace {

std::string saved_text(const ByteSink& sink, std::uint64_t first, std::uint64_t steps) {
  if (sink.whole_or_nothing()) return "no log was written";
  if (steps == 0) return "no step was saved";
  return "steps " + std::to_string(first) + " to " + std::to_string(first + steps - 1) + " are saved and can be read";
}

bool reads_back(const Prelude& prelude) {
  const Result<Prelude> read = decode_prelude(encode(prelude));
  return read.ok() && *read == prelude;
}

}  // namespace

Status RecordWriter::fail(const std::string& doing, const std::string& why) {
  sink_->truncate(bytes_);  // a log that ends with a complete record
  status_ =
      cannot_finish(sink_->name() + ": cannot write " + doing + " at byte " + std::to_string(bytes_) + ": " + why +
                    "; " + saved_text(*sink_, first_state_ + 1, steps()) + "; free some space and try again");
  return status_;
}

Status RecordWriter::write_all(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    Result<std::size_t> written = sink_->write_some(bytes);
    if (!written.ok()) return written.error();
    SIM_CHECK(*written >= 1 && *written <= bytes.size(), *written, bytes.size());
    bytes = bytes.subspan(*written);
  }
  return {};
}

Status RecordWriter::write_record(Prelude& prelude, const MessageBytes& message) {
  const std::string doing = std::string(name_of(prelude.kind)) + " " + std::to_string(sequence_);
  if (Status ok = compressor_.compress(message.bytes(), stored_); !ok.ok()) return fail(doing, ok.error().message);
  prelude.raw_bytes = message.bytes().size();
  prelude.stored_bytes = stored_.size();
  if (prelude.raw_bytes > raw_bytes_max(prelude, bytes_)) {
    if (Status ok = pack_worse(prelude, message.bytes()); !ok.ok()) return ok;
  }
  return write_stored(prelude, stored_);
}

// A message of many equal rows can compress so well that it looks like a decompression bomb, and readers would refuse
// it (message_bytes_max() in limits.h). With a window of 1 KiB, zstd needs at least 4 bytes per KiB, so the result is
// always within the limit of 256. Other messages are not compressed twice.
Status RecordWriter::pack_worse(Prelude& prelude, std::span<const std::byte> message) {
  const std::string doing = std::string(name_of(prelude.kind)) + " " + std::to_string(sequence_);
  Compressor narrow(1, kNarrowWindowLog);
  if (Status ok = narrow.compress(message, stored_); !ok.ok()) return fail(doing, ok.error().message);
  prelude.stored_bytes = stored_.size();
  if (prelude.raw_bytes <= raw_bytes_max(prelude, bytes_)) return {};
  return fail(doing, "its " + std::to_string(prelude.raw_bytes) + " bytes pack to " +
                         std::to_string(prelude.stored_bytes) + ", so few that no program would read it again");
}

// Each record is written completely or cut off again. The next record needs no repair, and a reader never sees half a
// record in front of a whole one.
Status RecordWriter::write_stored(Prelude& prelude, std::span<const std::byte> stored) {
  const std::string doing = std::string(name_of(prelude.kind)) + " " + std::to_string(sequence_);
  prelude.sequence = sequence_;
  prelude.stored_bytes = stored.size();
  prelude.stored_hash = hash_bytes(stored);
  if (prelude.kind == RecordKind::kHeader) log_tag_ = prelude.stored_hash.low;
  prelude.log_tag = log_tag_;
  SIM_CHECK(prelude.raw_bytes <= raw_bytes_max(prelude, bytes_), prelude.raw_bytes, stored.size(), bytes_);
  SIM_CHECK(reads_back(prelude), static_cast<unsigned>(prelude.kind), sequence_);
  if (Status ok = write_all(encode(prelude)); !ok.ok()) return fail(doing, ok.error().message);
  if (Status ok = write_all(stored); !ok.ok()) return fail(doing, ok.error().message);
  bytes_ += kPreludeBytes + stored.size();
  ++sequence_;
  return {};
}

Status RecordWriter::write_header(const LogHeader& header, const sim::WorldState& initial) {
  SIM_CHECK(sequence_ == 0, sequence_);
  const std::vector<sim::BoxDef>& boxes = header.scene.boxes;
  for (std::size_t i = 1; i < boxes.size(); ++i) SIM_CHECK(boxes[i - 1].id < boxes[i].id, i, boxes[i].id);
  mode_ = header.states;
  hashes_mode_ = header.hashes;
  final_hash_ = sim::state_hash(initial.bodies);
  first_state_ = initial.step;
  chain_ = header.goes_on ? header.goes_on->chain : chain_start(final_hash_, header.declared.start);
  for (const Channel& channel : header.declared.channels) channel_types_.push_back(channel.type);
  Result<MessageBytes> message = encode_header(header);
  if (!message.ok()) return fail("header", message.error().message);
  Prelude prelude;
  prelude.kind = RecordKind::kHeader;
  if (!header.declared.empty()) prelude.set_extras();
  prelude.first_step = first_state_;
  prelude.chain_before = prelude.chain_after = chain_;
  return write_record(prelude, *message);
}

Status RecordWriter::begin_chunk(Keyframe& keyframe) {
  if (!status_.ok()) return status_;
  SIM_CHECK(keyframe.state.step + 1 == end_step(), keyframe.state.step, end_step());
  keyframe.continuation_hash = sim::continuation_hash(keyframe.state);
  keyframe_ = &keyframe;
  used_ = 0;
  chain_before_ = chain_;
  encoder_.begin(keyframe.state);
  return {};
}

Status RecordWriter::add_steps(std::span<StepRecord> steps) {
  if (!status_.ok()) return status_;
  SIM_CHECK(keyframe_ != nullptr, steps.size());
  SIM_CHECK(used_ + steps.size() <= kStepsPerChunkRead, used_, steps.size());
  for (StepRecord& step : steps) {
    SIM_CHECK(step.step == end_step() + used_, step.step, end_step(), used_);
    SIM_CHECK(step.phase_words.size() <= kPhaseWordsMax, step.step, step.phase_words.size());
    SIM_CHECK(step.phase_words.empty() || hashes_mode_.holds(step.step), step.step, hashes_mode_.every);
    final_hash_ = step.state_hash = state_hash(step.states);
    step.has_states = mode_.holds(step.step);
    chain_ = chain_next(chain_, step);
    if (Status ok = encoder_.take_states(step, std::span(steps_).first(used_)); !ok.ok()) {
      return fail("chunk " + std::to_string(sequence_), ok.error().message);
    }
    if (used_ == steps_.size()) steps_.emplace_back();
    std::swap(step.states, steps_[used_].states);  // so that they stay with the caller's record
    std::swap(step, steps_[used_++]);
  }
  return {};
}

Status RecordWriter::end_chunk() {
  if (!status_.ok()) return status_;
  SIM_CHECK(keyframe_ != nullptr, used_);
  const Keyframe& keyframe = *std::exchange(keyframe_, nullptr);
  const std::span<const StepRecord> steps = std::span(steps_).first(used_);
  Prelude prelude;
  prelude.kind = RecordKind::kChunk;
  prelude.first_step = keyframe.state.step + 1;
  prelude.step_count = steps.size();
  prelude.chain_before = chain_before_;
  prelude.chain_after = chain_;
  if (has_extras(steps)) prelude.set_extras();
  Result<MessageBytes> message = encoder_.finish(keyframe, steps, channel_types_);
  if (!message.ok()) return fail("chunk " + std::to_string(sequence_), message.error().message);
  const std::uint64_t offset = bytes_;
  if (Status ok = write_record(prelude, *message); !ok.ok()) return ok;
  encoder_.take_back(*std::move(message));
  chunks_.push_back({offset, bytes_ - offset, prelude.first_step, prelude.step_count, chain_, prelude.stored_hash});
  return {};
}

Status RecordWriter::copy_header(const Prelude& before, std::span<const std::byte> stored) {
  SIM_CHECK(sequence_ == 0 && before.kind == RecordKind::kHeader, sequence_);
  first_state_ = before.first_step;
  chain_ = before.chain_after;
  Prelude prelude = before;
  return write_stored(prelude, stored);
}

Status RecordWriter::copy_chunk(const Prelude& before, std::span<const std::byte> stored, const Hash128& final_hash) {
  if (!status_.ok()) return status_;
  SIM_CHECK(before.kind == RecordKind::kChunk && before.stored_bytes == stored.size(), stored.size());
  SIM_CHECK(before.first_step >= end_step(), before.first_step, end_step());
  Prelude prelude = before;
  const std::uint64_t offset = bytes_;
  if (prelude.raw_bytes > raw_bytes_max(prelude, offset)) {  // the bytes before it in the file are fewer now
    const Result<MessageBytes> message = decompress(stored, prelude.raw_bytes, kChunkBytesMax);
    if (!message.ok()) return fail("chunk " + std::to_string(sequence_), message.error().message);
    if (Status ok = pack_worse(prelude, message->bytes()); !ok.ok()) return ok;
    stored = stored_;
  }
  if (Status ok = write_stored(prelude, stored); !ok.ok()) return ok;
  final_hash_ = final_hash;
  chain_ = prelude.chain_after;
  chunks_.push_back({offset, bytes_ - offset, prelude.first_step, prelude.step_count, chain_, prelude.stored_hash});
  return {};
}

// The footer promises that all bytes before it are on the disk, so the first sync() comes before the footer. The second
// makes the footer itself survive a loss of power.
Status RecordWriter::finish() {
  if (!status_.ok()) return status_;
  for (std::size_t i = 1; i < chunks_.size(); ++i) {
    SIM_CHECK(chunks_[i].offset == chunks_[i - 1].offset + chunks_[i - 1].length, i, chunks_[i].offset);
  }
  Result<MessageBytes> message = encode_index(chunks_);
  if (!message.ok()) return fail("index", message.error().message);
  Footer footer;
  footer.index_offset = bytes_;
  Prelude index;
  index.kind = RecordKind::kIndex;
  index.first_step = first_state_ + 1;
  index.step_count = steps();
  index.chain_before = index.chain_after = chain_;
  if (Status ok = write_record(index, *message); !ok.ok()) return ok;
  if (Status ok = sink_->sync(); !ok.ok()) return fail("footer", ok.error().message);
  footer.prelude = index;
  footer.prelude.kind = RecordKind::kFooter;
  footer.prelude.sequence = sequence_;
  footer.prelude.stored_bytes = footer.prelude.raw_bytes = 0;
  footer.prelude.stored_hash = {};
  footer.file_bytes = bytes_ + kFooterBytes;
  footer.final_state_hash = final_hash_;
  if (Status ok = write_all(encode(footer)); !ok.ok()) return fail("footer", ok.error().message);
  bytes_ += kFooterBytes;
  SIM_CHECK(bytes_ == footer.file_bytes, bytes_, footer.file_bytes);
  if (Status ok = sink_->sync(); !ok.ok()) return fail("footer", ok.error().message);
  return {};
}

}  // namespace tumble::replay
