#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"
#include "src/base/result.h"
#include "src/world/world_state.h"

namespace tumble::replay {

/// A finished log in numbers.
struct LogSummary {
  std::uint64_t steps = 0;
  std::uint64_t chunks = 0;
  std::uint64_t bytes = 0;
  Hash128 final_hash;  ///< state hash of the last step (of state 0 in a log without steps)
  Hash128 chain;       ///< after the last step: equal for equal sessions
};

/// What happened in a step, for append(). References last for the call.
struct StepInfo {
  double dt = 0;                               ///< s
  std::span<const sim::Command> inputs;        ///< applied before the step, in order
  std::span<const std::uint64_t> phase_words;  ///< sim::PhaseHashes::words(): rows × phases
  sim::StepCounters counters;
};

/// Writes a session to a log as it happens.
///
/// The calling thread only copies: append() puts the visible columns into memory that is used again, and a chunk that
/// is full goes to the writer's own thread, which hashes, encodes, compresses, writes. There are three such chunks; a
/// caller faster than the disk waits in append() for one to come back.
///
/// A chunk is closed after kChunkBusySteps steps of all bodies moving (quiet ones count less, up to kChunkStepsMax
/// steps), at kChunkStateBytes, and at the first append() a second or more after it was begun. A crash of the process
/// loses the open chunk and those on their way to the disk; a session that pauses calls flush().
///
/// Not to be called from two threads at once.
class LogWriter {
 public:
  /// Begins a log: writes the header. `initial` is state 0, or the state that LogHeader::goes_on tells of. header_for()
  /// makes the header. Errors: kBadInput from open_file_sink(), kCannotFinish from writing.
  static Result<std::unique_ptr<LogWriter>> create(const std::string& path, const LogHeader& header,
                                                   const sim::WorldState& initial);
  static Result<std::unique_ptr<LogWriter>> create(std::unique_ptr<ByteSink> sink, const LogHeader& header,
                                                   const sim::WorldState& initial);

  /// Without finish(): writes the steps so far, but neither index nor footer. Such a log reads as torn.
  ~LogWriter();

  /// Adds a step; `after` is the state that it led to (after.step is its number). Steps must follow each other without
  /// a gap. Errors (kCannotFinish): what the writing thread met earlier, with the file, the reason and the steps that
  /// are saved; nothing is written any more then.
  Status append(const StepInfo& info, const sim::WorldState& after);

  /// Closes the open chunk and returns when it is in the file. `now` is the state after the step appended last.
  Status flush(const sim::WorldState& now);

  /// Writes the rest, the index and the footer. Call once, last. Errors: as append().
  Result<LogSummary> finish();

 private:
  struct Shared;
  explicit LogWriter(std::unique_ptr<Shared> shared);

  std::unique_ptr<Shared> shared_;
};

}  // namespace tumble::replay
