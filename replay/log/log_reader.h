#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "tumble/replay/body_table.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/chunk.h"
#include "tumble/replay/log_condition.h"
#include "tumble/replay/prelude.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Reads a log: any step, in any order. A step costs the decoding of its chunk, and the reader keeps the chunk that it
/// decoded last. Use one reader per thread.
class LogReader {
 public:
  /// Opens a log whose header is intact. Damage behind the header does not fail here: condition() reports it, and every
  /// intact chunk can be read.
  ///
  /// Errors. kBadInput: no such file, a folder, not a log, a format that needs a newer program. kDamaged: an empty
  /// file, a header that is cut off or has changed bytes.
  static Result<LogReader> open(const std::string& path);
  static Result<LogReader> open(std::unique_ptr<ByteSource> source);
  LogReader(LogReader&&) noexcept;
  LogReader& operator=(LogReader&&) noexcept;
  ~LogReader();

  [[nodiscard]] const LogHeader& header() const;
  [[nodiscard]] std::string name() const;  ///< the path
  [[nodiscard]] std::uint64_t file_bytes() const;

  /// Whether the log was finished, where it was cut off, and the damage that opening found. verify() checks every byte.
  [[nodiscard]] const LogCondition& condition() const;

  /// The number of the state that the log begins with: 0, or the step at which the log continues another one.
  [[nodiscard]] std::uint64_t first_state() const;

  /// The last step that the log holds; first_state() for a log without steps.
  [[nodiscard]] std::uint64_t last_step() const;

  [[nodiscard]] std::uint64_t step_count() const { return last_step() - first_state(); }

  /// The missing steps of a recovered log that step k belongs to; null for every other step.
  [[nodiscard]] const MissingSteps* lost_at(std::uint64_t k) const;

  /// Whether step k can be read: it is in an intact chunk, or is first_state().
  [[nodiscard]] bool holds(std::uint64_t k) const;

  /// The intact chunks, by ascending step. A lost record leaves steps missing between two of them.
  [[nodiscard]] const std::vector<ChunkPlace>& chunks() const;

  /// Step k of first_state() … last_step(). record->has_states says whether the log holds the states of that step.
  /// Step first_state() stands for the state that the log begins with: always with states, without inputs.
  ///
  /// The pointer is valid until the next call of a non-const member. Errors. kBadInput: the log does not hold the step.
  /// kDamaged: the step cannot be read; the message names path, record, byte, found and wanted.
  Result<const StepRecord*> read_step(std::uint64_t k);

  /// Step k with inputs, hashes and counters only, at a fraction of the cost of read_step(). `states` is unspecified.
  Result<const StepRecord*> read_hashes(std::uint64_t k);

  /// The latest complete state at or before state k: its state.step <= k. To reach state k, pass
  /// Keyframe::state to World::restore(), then take each of the steps state.step + 1 … k after applying its inputs.
  ///
  /// The pointer is valid until the next call of a non-const member. Errors: as read_step().
  Result<const Keyframe*> keyframe_at_or_before(std::uint64_t k);

  /// The chain after step k of first_state() … last_step(); see chain_next(). Errors: as read_step().
  Result<Hash128> chain_at(std::uint64_t k);

  /// Names and shapes of all bodies of the log, also of those that appear later: reads every intact chunk once where
  /// the log has declarations, and keeps the result. A body that is not in it has no name and is a box. Chunks that
  /// cannot be read are passed over.
  const BodyTable& bodies();

  /// Decodes the next chunk on a second thread while one chunk is in use. Costs the memory of one more chunk. Pays off
  /// where all steps are read in ascending order.
  void read_ahead(bool on);

  /// The number of chunks decoded so far: a measure of the work done.
  [[nodiscard]] std::uint64_t chunks_opened() const;

  // For verify().
  [[nodiscard]] const ByteSource& source() const;
  [[nodiscard]] const Prelude& header_prelude() const;

 private:
  struct State;
  explicit LogReader(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace tumble::replay
