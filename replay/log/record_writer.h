#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "replay/codec/chunk_codec.h"
#include "replay/codec/zstd_frame.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/chunk.h"
#include "tumble/replay/prelude.h"
#include "tumble/replay/step_record.h"

namespace tumble::replay {

/// Writes the records of a log, one after the other, into a sink: the inverse of RecordReader. Computes preludes,
/// chain, index and footer. LogWriter calls it from its writing thread.
///
/// Errors (kCannotFinish): writing fails. The sink is then cut back to the last complete record, and every further call
/// returns the same error.
class RecordWriter {
 public:
  explicit RecordWriter(std::unique_ptr<ByteSink> sink) : sink_(std::move(sink)) {}

  /// Writes the header record. initial: state 0, or the state that a continued session starts from.
  Status write_header(const LogHeader& header, const sim::WorldState& initial);

  /// Begins a chunk. The first step follows the last step of the chunk before. Fills in the hash of the keyframe, which
  /// must stay until end_chunk().
  Status begin_chunk(Keyframe& keyframe);
  /// Adds the next steps of the chunk: hashes and encodes their states. Every step must have states. What the records
  /// hold is then of no use, but for their memory.
  Status add_steps(std::span<StepRecord> steps);
  /// Writes the chunk.
  Status end_chunk();

  /// Copies a record of another log: keeps the stored bytes, and changes number and tag. Compresses a chunk again where
  /// its message would exceed message_bytes_max() at the new place. before: the prelude of the
  /// record in the other log. final_hash: state hash after the last step of the chunk. Steps may be missing before a
  /// chunk.
  Status copy_header(const Prelude& before, std::span<const std::byte> stored);
  Status copy_chunk(const Prelude& before, std::span<const std::byte> stored, const Hash128& final_hash);

  /// Writes index and footer, which completes the log. All other bytes are on the disk before the footer is written.
  Status finish();

  [[nodiscard]] std::string name() const { return sink_->name(); }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  [[nodiscard]] std::uint64_t steps() const { return end_step() - 1 - first_state_; }
  [[nodiscard]] std::size_t chunks() const { return chunks_.size(); }
  [[nodiscard]] const Hash128& final_hash() const { return final_hash_; }
  [[nodiscard]] const Hash128& chain() const { return chain_; }

 private:
  /// The step that comes after those written so far.
  [[nodiscard]] std::uint64_t end_step() const {
    return chunks_.empty() ? first_state_ + 1 : chunks_.back().end_step();
  }
  Status write_record(Prelude& prelude, const MessageBytes& message);
  /// Compresses into stored_ with a small window, for a message that the default compresses to fewer bytes than readers
  /// accept (message_bytes_max()).
  Status pack_worse(Prelude& prelude, std::span<const std::byte> message);
  Status write_stored(Prelude& prelude, std::span<const std::byte> stored);
  Status write_all(std::span<const std::byte> bytes);
  Status fail(const std::string& doing, const std::string& why);

  std::unique_ptr<ByteSink> sink_;
  Compressor compressor_;
  ChunkEncoder encoder_;
  std::vector<std::byte> stored_;  // its memory is used again
  std::vector<ChunkPlace> chunks_;
  Keyframe* keyframe_ = nullptr;   // of the open chunk
  std::vector<StepRecord> steps_;  // of the open chunk, without states; of which `used_` are filled
  std::size_t used_ = 0;
  Hash128 chain_before_;  // of the open chunk
  StatesMode mode_;
  std::vector<ChannelType> channel_types_;
  HashesMode hashes_mode_;
  std::uint64_t first_state_ = 0;  // the state that the log begins with
  std::uint64_t bytes_ = 0;        // of complete records
  std::uint64_t sequence_ = 0;
  std::uint64_t log_tag_ = 0;
  Hash128 chain_;
  Hash128 final_hash_;
  Status status_;
};

}  // namespace tumble::replay
