#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/comparison_scope.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/header_difference.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/replay/tolerance.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

class CheckedLogs;  // replay/log/checked_log.h

/// The part of two logs that a comparison reads.
enum class Reading : std::uint8_t {
  kAll,     ///< every byte of both
  kHashes,  ///< the chains of hashes, and the chunks where they part: damage of other chunks is not seen
};

/// A comparison that ends before the logs do.
inline constexpr std::uint64_t kNoLimit = ~std::uint64_t{0};

struct DiffReport {
  std::uint64_t from = 0;                 ///< the first state that both logs have
  std::uint64_t steps = 0;                ///< after it, that both logs hold; compared, or equal by their chains
  std::optional<Divergence> first;        ///< none: all those steps are equal
  std::optional<Divergence> built;        ///< of worlds that differ although the scenes do not: the first property
  OnlyInOne only_in;                      ///< compared by nothing; the two are not identical
  std::vector<HeaderDifference> headers;  ///< differences of the headers; they decide nothing
  std::uint64_t states_read = 0;          ///< steps whose states were read because their hashes differ
  std::uint64_t zeros = 0;  ///< of states of another engine, whose sign alone differs; they count as equal
  ComparisonScope scope;
  std::vector<std::string> notes;  ///< for people: a log that is not whole, bodies whose values are no numbers
  std::uint64_t last_a = 0;        ///< last step
  std::uint64_t last_b = 0;
  std::uint64_t until = kNoLimit;  ///< the last step to compare, where a log goes on behind it
  /// "all behind step 40, as asked", where steps were left out; else empty.
  [[nodiscard]] std::string behind() const;
  /// A sentence on equal steps of logs whose headers differ in values that a step depends on; empty without such.
  [[nodiscard]] std::string though() const;
  /// No difference in any step, the same last step, and no data that one log lacks.
  [[nodiscard]] bool identical() const { return !first.has_value() && last_a == last_b && only_in.empty(); }
  /// Whether the second, a session computed again, has all that the first one holds; it may hold more channels, but no
  /// input that the first had not.
  [[nodiscard]] bool computed_again() const {
    return !first.has_value() && last_a == last_b && only_in.a.empty() && !only_in.adds_input();
  }
  /// Where steps are equal, though the sessions are not: "another number of steps, 40 and 30", "only the first has
  /// channel knee". Otherwise empty.
  [[nodiscard]] std::string unequal(const std::string& name_a, const std::string& name_b) const;
};

/// Compares two logs: the first state that both have, then every step, then the hidden parts of the keyframes that both
/// have where the scenes are equal. Exact comparison finds the place by the chains of whole chunks and decodes only the
/// chunk with the first difference; before, it reads both logs from end to end and compares their states with their
/// hashes, unless only hashes are to be read. With tolerances, steps whose hashes differ are compared by their states,
/// and fields without a tolerance exactly. Logs of two engines are compared by dt and states alone; ULPs are counted in
/// binary32 where both engines compute in it. In another engine's log, −0.0 and 0.0 are one number: a change of axes
/// turns one into the other. Steps behind `until` are not compared, and the scope says so. Errors: a log that cannot be
/// read; damage (kDamaged), before any other answer; no step in common (kBadInput); tolerances where a log has no
/// states for a step that differs (kBadInput); kCannotFinish where `progress` stops.
Result<DiffReport> diff_logs(LogReader& a, LogReader& b, const Tolerances& tolerances = {},
                             const Progress& progress = {}, Reading reading = Reading::kAll,
                             std::uint64_t until = kNoLimit);

/// diff_logs() of one exact comparison among many: a log that `checked` knows is not read from end to end again.
Result<DiffReport> diff_logs(CheckedLogs& checked, LogReader& a, LogReader& b, const Progress& progress = {});

}  // namespace tumble::replay
