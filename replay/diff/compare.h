#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/diff/divergence.h"
#include "replay/format/progress.h"
#include "replay/log/log_reader.h"
#include "src/base/result.h"

namespace tumble::replay {

/// How far two values may lie apart and still be called the same, each component by itself. 0 is exact, to the bit.
struct Tolerances {
  double position = 0;     ///< m
  double orientation = 0;  ///< of a quaternion's components; q and −q are the same turn but not the same here
  double velocity = 0;     ///< m/s
  double spin = 0;         ///< rad/s
  [[nodiscard]] bool exact() const { return position == 0 && orientation == 0 && velocity == 0 && spin == 0; }
};

/// Sets one by its field's name. Errors (kBadInput): an unknown field, a value that is negative or no number.
Status set_tolerance(Tolerances& tolerances, const std::string& field, double value);

struct DiffReport {
  std::uint64_t from = 0;            ///< the first state that both logs have
  std::uint64_t steps = 0;           ///< after it, that both logs have; or that their chains say are the same
  std::optional<Divergence> first;   ///< none: the same in all those steps
  std::vector<std::string> headers;  ///< what differs in the headers, a line each; no verdict by itself
  std::uint64_t last_a = 0;          ///< last step
  std::uint64_t last_b = 0;
  /// No difference in any step, and the same last step.
  [[nodiscard]] bool identical() const { return !first.has_value() && last_a == last_b; }
};

/// Compares two logs: state 0, then every step; where one goes on from a later state, from that on. Exact comparison
/// goes by the chains of whole chunks and opens only the chunk with the first difference. With tolerances, steps whose
/// hashes differ are compared by their states, fields without a tolerance exactly. Logs of two engines are compared by
/// dt and states alone; where both compute in binary32, ULPs are counted in it. Errors: a log that cannot be read;
/// no step in common to compare (kDamaged); tolerances where a log has no states for a step that differs (kBadInput).
Result<DiffReport> diff_logs(LogReader& a, LogReader& b, const Tolerances& tolerances = {},
                             const Progress& progress = {});

}  // namespace tumble::replay
