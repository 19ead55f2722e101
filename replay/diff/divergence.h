#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "replay/format/step_record.h"

namespace tumble::replay {

/// A value of a field: a double, an integer, or text (hashes, names).
using FieldValue = std::variant<double, std::uint64_t, std::string>;

/// The first difference between two sessions, as the JSON contract of `replay` and `diff` has it.
struct Divergence {
  std::uint64_t step = 0;
  std::optional<std::uint32_t> substep;  ///< 0-based row of phase words; the last row gathers all later sub-steps
  /// The first phase of the step that wrote something else; "inputs" for what preceded it, "start" for state 0, "step"
  /// where phases cannot be told apart.
  std::string phase;
  std::optional<sim::BodyId> body;  ///< the first one, by id, whose state differs
  std::optional<std::pair<sim::BodyId, sim::BodyId>> pair;
  /// "position.x", "orientation.w", "velocity.y", "spin.z", "frozen", "id"; "dt", "inputs" (other kinds of them),
  /// "throw.velocity.y" (what an input says; see input_difference.h), "phase_hash", "state_hash",
  /// "continuation_hash" (what is hidden in a state),
  /// "pairs", "contacts", "substeps", "kinetic", "potential", "input_energy", "removed_energy", "error".
  std::string field;
  FieldValue expected;  ///< in the log, or in the first of two
  FieldValue actual;
  std::optional<std::uint64_t> ulps;  ///< representable doubles between the two; none where one is NaN or no double
};

/// Steps from one double to the other through all doubles between; −0.0 and 0.0 are one apart. None for NaN.
std::optional<std::uint64_t> ulps_between(double a, double b);

/// The same between the nearest floats of the two. None for NaN and beyond what a float holds.
std::optional<std::uint64_t> ulps32_between(double a, double b);

/// Counts the ULPs of a difference in floats: for what was computed in them.
void count_in_binary32(Divergence& divergence);

/// One line: "step 12, phase integrate, body 7, position.x: expected …, actual … (3 ulps)".
std::string describe(const Divergence& divergence);
std::string to_string(const FieldValue& value);  ///< doubles with 17 digits

/// What two records of one step say, compared to the bit: what led into the step (dt, inputs), phase words, state hash,
/// states, counters. `phases` names the words; empty if the two have different phases, which leaves the words out.
/// States fill in body and field where both records have them.
std::optional<Divergence> first_difference(const StepRecord& expected, const StepRecord& actual,
                                           const std::vector<std::string>& phases);

/// The first body and field in which two states differ to the bit, ascending by id.
std::optional<Divergence> first_difference(const BodyStates& expected, const BodyStates& actual);

}  // namespace tumble::replay
