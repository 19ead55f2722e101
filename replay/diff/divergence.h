#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tumble/replay/body_states.h"
#include "tumble/replay/field_value.h"
#include "tumble/replay/step_record.h"

namespace tumble::replay {

/// The first difference between two sessions. `replay --json` and `diff --json` print it field by field.
struct Divergence {
  std::uint64_t step = 0;
  std::optional<std::uint32_t> substep;  ///< 0-based row of phase words; the last row gathers all later substeps
  /// The first phase of the step that wrote another value; "inputs" for what preceded the phases, "start" for state 0,
  /// "step" where phases cannot be told apart.
  std::string phase;
  std::optional<sim::BodyId> body;  ///< the first one, by id, whose state differs
  std::optional<std::pair<sim::BodyId, sim::BodyId>> pair;
  /// "position.x", "orientation.w", "velocity.y", "spin.z", "frozen"; "body" (one session alone has it: its id, and
  /// nothing in the other); "dt", "inputs" (other kinds of them),
  /// "throw.velocity.y" (a field of an input, see input_difference.h), "phase_hash", "state_hash", "mass", "inertia.x",
  /// "world.gravity.z", "low_energy_time" (parts of a complete state, see world_difference.h), "continuation_hash"
  /// (such a part that cannot be named), "pairs", "contacts", "substeps", "kinetic", "potential", "input_energy",
  /// "removed_energy", "error".
  std::string field;
  FieldValue expected;  ///< in the log, or in the first of two
  FieldValue actual;
  std::optional<std::uint64_t> ulps;  ///< ulps_between() the two; none where one is NaN or no double
  std::string names;                  ///< of body or pair, where the log has them: "wheel", "wheel and chassis"
  /// For people: "same rotation, other sign" where an orientation is another's negative; the angle between two others;
  /// "zeros of other sign". May be empty.
  std::string note;
};

/// A difference with the ULPs between the two values.
Divergence make_divergence(std::uint64_t step, std::string phase, std::string field, FieldValue expected,
                           FieldValue actual);

/// Counts the ULPs of a difference in floats: for values that were computed in floats.
void count_in_binary32(Divergence& divergence);

/// The distance of the two values with its unit: "3e-12 m/s"; "infinite" where one is no finite number. Empty where
/// they are no numbers of a state, a contact or a channel (whose unit is in the note).
std::string magnitude(const Divergence& divergence);
/// ", 0.00155 m apart", ", infinitely far apart", ", one is not a number" for the end of a sentence; empty likewise.
std::string apart_words(const Divergence& divergence);

/// Whether the difference is one of a body's visible state.
bool is_in_state(const Divergence& divergence);

/// Whether one of the two sessions does not have the body at all.
bool is_body_missing(const Divergence& divergence);

/// "only in A" for a missing body: the name of the session that has it.
std::string only_in(const Divergence& missing_body, const std::string& expected, const std::string& actual);

/// One line: "step 12, phase integrate, body 7, position.x: expected …, actual … (3 ulps)".
std::string describe(const Divergence& divergence);

/// Compares two records of one step to the bit: dt and inputs, phase words, state hash, states, counters. `phases`
/// names the words; leave it empty if the two sessions have different phases, and the words are not compared. Body and
/// field are named where both records have states.
std::optional<Divergence> first_difference(const StepRecord& expected, const StepRecord& actual,
                                           const std::vector<std::string>& phases);

/// The first body and field in which two states differ to the bit, by ascending id.
std::optional<Divergence> first_difference(const BodyStates& expected, const BodyStates& actual);

/// The first place at which two lists of bodies differ: field "body". Both ascend, so the smaller of the two ids there
/// is the body that one side lacks.
std::optional<Divergence> different_ids(const std::vector<sim::BodyId>& expected,
                                        const std::vector<sim::BodyId>& actual);

/// Whether all columns of row i of `a` and row j of `b` are equal to the bit.
bool same_columns(const ConstColumns& a, std::size_t i, const ConstColumns& b, std::size_t j);

/// The bodies of both states whose rows differ in any bit, ascending. Both states are sorted by id.
std::vector<sim::BodyId> differing_bodies(const BodyStates& a, const BodyStates& b);

}  // namespace tumble::replay
