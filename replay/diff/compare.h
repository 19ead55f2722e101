#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/divergence.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The largest differences at which two values count as equal, for each component by itself. 0 is exact, to the bit.
struct Tolerances {
  double position = 0;     ///< m
  double orientation = 0;  ///< of a quaternion's components; q and −q differ here, though they are one turn
  double velocity = 0;     ///< m/s
  double spin = 0;         ///< rad/s, angular velocity
  [[nodiscard]] bool exact() const { return position == 0 && orientation == 0 && velocity == 0 && spin == 0; }
};

/// Sets the tolerance of a field by its name. Errors (kBadInput): an unknown field; a value that is negative or NaN.
Status set_tolerance(Tolerances& tolerances, const std::string& field, double value);

struct DiffReport {
  std::uint64_t from = 0;            ///< the first state that both logs have
  std::uint64_t steps = 0;           ///< after it, that both logs have; compared, or equal by their chains
  std::optional<Divergence> first;   ///< none: all those steps are equal
  std::vector<std::string> headers;  ///< differences of the headers, a line each; they decide nothing
  std::uint64_t last_a = 0;          ///< last step
  std::uint64_t last_b = 0;
  /// No difference in any step, and the same last step.
  [[nodiscard]] bool identical() const { return !first.has_value() && last_a == last_b; }
};

/// Compares two logs: the first state that both have, then every step. Exact comparison uses the chains of whole chunks
/// and decodes only the chunk with the first difference. With tolerances, steps whose hashes differ are compared by
/// their states, and fields without a tolerance exactly. Logs of two engines are compared by dt and states alone; ULPs
/// are counted in binary32 where both engines compute in it. Errors: a log that cannot be read; no step in common
/// (kBadInput); tolerances where a log has no states for a step that differs (kBadInput).
Result<DiffReport> diff_logs(LogReader& a, LogReader& b, const Tolerances& tolerances = {},
                             const Progress& progress = {});

}  // namespace tumble::replay
