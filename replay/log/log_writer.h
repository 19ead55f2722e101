#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "tumble/replay/byte_io.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// The numbers of a finished log.
struct LogSummary {
  std::uint64_t steps = 0;
  std::uint64_t chunks = 0;
  std::uint64_t bytes = 0;
  Hash128 final_hash;  ///< state hash of the last step (of state 0 in a log without steps)
  Hash128 chain;       ///< after the last step: equal for equal sessions
};

/// One step, for append(). The spans must be valid during the call.
struct StepInfo {
  double dt = 0;                               ///< s
  std::span<const sim::Command> inputs;        ///< applied before the step, in order
  std::span<const std::uint64_t> phase_words;  ///< sim::PhaseHashes::words(): rows × phases; none unless header.hashes
  sim::StepCounters counters;
  const Extras* extras = nullptr;  ///< of the step; null: none. Channels as LogHeader::declared has them
};

/// Writes a session to a log while the session runs.
///
/// The calling thread only copies. append() copies the visible columns into a buffer of about 1 MB. The writer's thread
/// hashes and encodes full buffers while their chunk still grows, then compresses and writes the chunk. There are
/// buffers for 128 steps or 64 MB of them, at least three (one for huge scenes); append() waits while all are full.
///
/// The writer closes a chunk
/// - after kChunkBusySteps steps in which all bodies move; resting bodies count nothing, up to kChunkStepsMax steps
/// - at kChunkStateBytes of states
/// - in the first append() that comes a second or more after the chunk was begun
///
/// A crash of the process loses the chunks that are not in the file yet. Call flush() before a pause.
///
/// Not for use by two threads at once.
class LogWriter {
 public:
  /// Creates the log and writes its header. header: made by header_for(). initial: state 0, or the state that
  /// LogHeader::goes_on names. Errors. kBadInput: open_file_sink() refuses the path. kCannotFinish: writing fails, or
  /// the system gives no thread.
  static Result<std::unique_ptr<LogWriter>> create(const std::string& path, const LogHeader& header,
                                                   const sim::WorldState& initial);
  static Result<std::unique_ptr<LogWriter>> create(std::unique_ptr<ByteSink> sink, const LogHeader& header,
                                                   const sim::WorldState& initial);

  /// Without finish(), writes the remaining steps but no index and no footer. Readers report such a log as torn.
  ~LogWriter();

  /// Adds a step. after: the state after the step; after.step is the number of the step, one more than the last.
  /// Errors (kCannotFinish): an earlier write failed. The message names the file, the reason and the saved steps, and
  /// the writer writes nothing more.
  Status append(const StepInfo& info, const sim::WorldState& after);

  /// Closes the open chunk and waits until the file holds it. now: the state after the last appended step.
  Status flush(const sim::WorldState& now);

  /// Writes the remaining steps, the index and the footer. Call once, as the last call. Errors: as append().
  Result<LogSummary> finish();

 private:
  struct Buffer;
  struct Shared;
  explicit LogWriter(std::unique_ptr<Shared> shared);

  std::unique_ptr<Shared> shared_;
};

}  // namespace tumble::replay
