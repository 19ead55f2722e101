#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/body_table.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/hash.h"

namespace tumble::replay {

/// Counts over all readable steps of a log.
struct LogFacts {
  std::uint64_t bodies_at_start = 0;
  std::uint64_t bodies_thrown = 0;  ///< of other ids than any before: one that comes back is the same body
  std::uint64_t steps_read = 0;
  double seconds = 0;                              ///< simulated
  std::optional<double> dt_min, dt_max;            ///< s, of the steps read; none without one
  std::map<std::string, std::uint64_t> inputs;     ///< by kind: "throw", "push", …
  std::optional<std::uint64_t> moving_body_steps;  ///< bodies neither frozen nor static, summed over the steps; none
                                                   ///< for a log that lacks the states of a step
  std::optional<Hash128> final_hash;               ///< state hash of the last readable step

  std::string told;  ///< that the scene does not hold what the engine told, for people; empty: it does

  /// Bytes of the whole file divided by moving_body_steps; none without a moving body or without that count.
  [[nodiscard]] std::optional<double> bytes_per_moving_body_step(std::uint64_t file_bytes) const;
};

/// Reads a log from end to end and leaves out the steps that cannot be read; verify() names the damage.
LogFacts collect_facts(LogReader& log, const Progress& progress = {});

/// Whether the readable steps of a log differ in length. Reads no more of it than it needs to say so.
bool dt_varies(LogReader& log);

/// Reads a state, without the inputs and phases that led there.
Status read_start(LogReader& log, std::uint64_t from, StepRecord& start);

/// Names and shapes of the bodies that the start and the steps up to step `last` tell of. Reads the chunks up to that
/// step, where LogReader::bodies() reads all. Chunks that cannot be read are passed over.
BodyTable bodies_until(const LogReader& log, std::uint64_t last);

/// False for another engine's log without a step: no engine told the length that its header has.
bool tells_dt(const LogReader& log);

/// Adds which values of each log's scene are not those that its engine told at the start: a header shows the scene's.
void add_notes_on_cuts(const LogReader& a, const LogReader& b, std::vector<std::string>& notes);

/// Whether any readable state or step of another engine's log, up to step `last`, has a contact. Reads no more of it
/// than it needs to say so.
bool tells_contacts(LogReader& log, std::uint64_t last);

/// Adds "its shape of body 7" for each body that appears after the start of both logs, up to step `last`, and is no box
/// in the one, and of another shape in the other. Reads both logs for them. Bodies that one log alone has are a
/// difference of states.
void add_later_shapes(LogReader& one, LogReader& other, std::uint64_t last, std::vector<std::string>& parts);

/// The last step up to which the chains of two logs agree, among the steps from..last at which log A ends a chunk; both
/// chains must cover the same. Errors: as LogReader::chain_at() of `from`.
Result<std::uint64_t> last_of_one_chain(LogReader& a, LogReader& b, std::uint64_t from, std::uint64_t last);

}  // namespace tumble::replay
