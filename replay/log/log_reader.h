#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "replay/codec/chunk_codec.h"
#include "replay/codec/index_codec.h"
#include "replay/format/chunk.h"
#include "replay/format/prelude.h"
#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"
#include "replay/log/scan.h"
#include "src/base/result.h"

namespace tumble::replay {

class ChunkAhead;

/// Reads a log: any step, in any order, at the price of one chunk. Not for two threads at once; open the file twice.
class LogReader {
 public:
  /// Errors. kBadInput: no such file, a folder, not a log, a format that needs a newer program. kDamaged: an empty
  /// file, a header that is torn or not what was written. Everything behind the header may be damaged and the log still
  /// opens; condition() says so, and what is whole can be read.
  static Result<LogReader> open(const std::string& path);
  static Result<LogReader> open(std::unique_ptr<ByteSource> source);

  [[nodiscard]] const LogHeader& header() const { return header_; }
  [[nodiscard]] std::string name() const { return source_->name(); }  ///< the path
  [[nodiscard]] std::uint64_t file_bytes() const { return source_->size(); }

  /// Whether the log was finished, where it is torn, what was found damaged on opening. verify() looks at every byte.
  [[nodiscard]] const LogCondition& condition() const { return condition_; }

  /// The state that the log begins with: 0, or the step after which the session goes on from another one.
  [[nodiscard]] std::uint64_t first_state() const { return header_prelude_.first_step; }

  /// The last step that the log holds; first_state() if it holds that state alone or nothing.
  [[nodiscard]] std::uint64_t last_step() const {
    return chunks_.empty() ? first_state() : chunks_.back().end_step() - 1;
  }

  [[nodiscard]] std::uint64_t step_count() const { return last_step() - first_state(); }

  /// The gap of a recovered log in which step k lies, if it does.
  [[nodiscard]] const Gap* lost_at(std::uint64_t k) const;

  /// The chunks that are there, ascending. Between two of them steps are missing if a record was lost.
  [[nodiscard]] const std::vector<ChunkPlace>& chunks() const { return chunks_; }

  /// Step k of first_state() … last_step(), with its states where the log has them (record->has_states); the first is
  /// the state that the log begins with, always with states and without inputs. The pointer is good until the next call
  /// of a member that is not const. Errors: kBadInput for a step that the log does not hold, kDamaged (path, record,
  /// byte, found and wanted) for one that cannot be read.
  Result<const StepRecord*> read_step(std::uint64_t k);

  /// The same without states, which makes it cheap: inputs, hashes and counters only. states stays empty or not.
  Result<const StepRecord*> read_hashes(std::uint64_t k);

  /// The latest complete state from which state k can be reached: its state.step <= k. World::restore() takes it; then
  /// apply the inputs of steps state.step + 1 … k and step. Good until the next call of a member that is not const.
  Result<const Keyframe*> keyframe_at_or_before(std::uint64_t k);

  /// The chain after step k of first_state() … last_step(); see chain_next(). Errors: as read_step().
  Result<Hash128> chain_at(std::uint64_t k);

  /// Whether a second thread decodes the next chunk while one is in use: for who reads all steps in turn. It takes the
  /// memory of a chunk more.
  void read_ahead(bool on);

  /// How many chunks were read and decompressed so far: what finding something has cost.
  [[nodiscard]] std::uint64_t chunks_opened() const { return chunks_opened_; }

  // For verify().
  [[nodiscard]] const ByteSource& source() const { return *source_; }
  [[nodiscard]] const Prelude& header_prelude() const { return header_prelude_; }

 private:
  LogReader(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {}
  Status read_header();
  void find_chunks();
  [[nodiscard]] Error no_such(const char* what, std::uint64_t k) const;
  [[nodiscard]] Result<std::size_t> chunk_of(std::uint64_t k) const;
  Result<ChunkDecoder*> load(std::size_t chunk);
  Result<const StepRecord*> read(std::uint64_t k, bool with_states);

  std::unique_ptr<ByteSource> source_;
  Prelude header_prelude_;
  LogHeader header_;
  LogCondition condition_;
  std::vector<ChunkPlace> chunks_;
  std::optional<std::size_t> loaded_;  // which chunk decoder_ holds
  std::optional<ChunkDecoder> decoder_;
  std::uint64_t chunks_opened_ = 0;
  StepRecord start_;
  std::shared_ptr<ChunkAhead> ahead_;
};

/// Reads, checks and decompresses the record at a place. Errors carry path, record and byte.
Result<MessageBytes> read_payload(const ByteSource& source, std::uint64_t offset, const Prelude& prelude);

/// Reads the chunk at a place and checks it against its prelude: the stored hash, the counts, the chain over its steps.
Result<ChunkDecoder> read_chunk(const ByteSource& source, const ChunkPlace& place, const Prelude& header,
                                const LogHeader& log);

}  // namespace tumble::replay
