#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "replay/codec/chunk_codec.h"
#include "replay/codec/zstd_frame.h"
#include "replay/format/chunk.h"
#include "replay/format/prelude.h"
#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"

namespace tumble::replay {

/// Puts a log's records one after the other into a sink: compression, preludes, the chain, index and footer. Knows no
/// threads; LogWriter has one call it. After an error every further call returns that error, and the sink has been cut
/// back to the last complete record.
class RecordWriter {
 public:
  explicit RecordWriter(std::unique_ptr<ByteSink> sink) : sink_(std::move(sink)) {}

  /// initial: state 0, or what the session goes on from.
  Status write_header(const LogHeader& header, const sim::WorldState& initial);

  /// Fills in each step's state_hash and has_states, and the keyframe's hash; then writes. Every step must have states.
  Status write_chunk(Keyframe& keyframe, std::span<StepRecord> steps);

  /// The same with records of another log, byte for byte but for their number and tag; a chunk that packed so well
  /// that it would be refused at its new place is packed anew. `before` is the other header's
  /// prelude; `final_hash` the state hash after the chunk's last step. A chunk need not begin where the last ended.
  Status copy_header(const Prelude& before, std::span<const std::byte> stored);
  Status copy_chunk(const Prelude& before, std::span<const std::byte> stored, const Hash128& final_hash);

  /// Index and footer; the log is complete then. What precedes the footer is on the disk before it is written.
  Status finish();

  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  [[nodiscard]] std::uint64_t steps() const {
    return chunks_.empty() ? 0 : chunks_.back().end_step() - 1 - first_state_;
  }
  [[nodiscard]] std::size_t chunks() const { return chunks_.size(); }
  [[nodiscard]] const Hash128& final_hash() const { return final_hash_; }
  [[nodiscard]] const Hash128& chain() const { return chain_; }

 private:
  Status write_record(Prelude& prelude, const MessageBytes& message);
  /// Into stored_, for a message that readers would refuse for packing too well.
  Status pack_worse(Prelude& prelude, std::span<const std::byte> message);
  Status write_stored(Prelude& prelude, std::span<const std::byte> stored);
  Status write_all(std::span<const std::byte> bytes);
  Status fail(const std::string& doing, const std::string& why);

  std::unique_ptr<ByteSink> sink_;
  Compressor compressor_;
  ChunkEncoder encoder_;
  std::vector<std::byte> stored_;  // kept for its memory
  std::vector<ChunkPlace> chunks_;
  StatesMode mode_;
  std::uint64_t first_state_ = 0;  // what the log begins with
  std::uint64_t bytes_ = 0;        // of complete records
  std::uint64_t sequence_ = 0;
  std::uint64_t log_tag_ = 0;
  Hash128 chain_;
  Hash128 final_hash_;
  Status status_;
};

}  // namespace tumble::replay
