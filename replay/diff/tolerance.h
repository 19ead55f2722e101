#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "tumble/replay/body_states.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The largest differences at which two values count as equal. 0 is exact.
struct Tolerances {
  double position = 0;     ///< m, of each component
  double orientation = 0;  ///< rad: the angle of the turn from one to the other, and the difference of lengths;
                           ///< q and −q are one
  double velocity = 0;     ///< m/s, of each component
  double spin = 0;         ///< rad/s, angular velocity, of each component
  /// Of inputs and parameters, by name: "dt", "throw.velocity", "throw.velocity.y", "world.gravity.z".
  std::map<std::string, double> fields;
  [[nodiscard]] bool exact() const {
    return position == 0 && orientation == 0 && velocity == 0 && spin == 0 && fields.empty();
  }
  /// Whether a difference of an input's or a parameter's field is within its tolerance.
  [[nodiscard]] bool excuses(const std::string& field, double expected, double actual) const;
};

/// Sets the tolerance of a field by its name. channels: those of the logs; a name that no field has, or "channel." and
/// a name, means a channel. Errors (kBadInput): an unknown field; a channel of bytes or text; a value that is negative
/// or NaN.
Status set_tolerance(Tolerances& tolerances, const std::string& field, double value,
                     const std::vector<Channel>& channels = {});

/// The angle in rad, 0 … π, of the turn from one orientation to the other; NaN where one has no direction.
double angle_between(const sim::Quat& a, const sim::Quat& b);

/// Whether every component of one is the other's, or its negative: the same turn, written with other signs or not.
bool same_rotation(const sim::Quat& a, const sim::Quat& b);

/// Copies into `actual` every value of `expected` within tolerance, so that an exact comparison finds it equal. With
/// tolerances, an orientation of the opposite sign is equal too.
void forgive_states(const BodyStates& expected, BodyStates& actual, const Tolerances& tolerances);

/// Likewise for dt and for the fields of inputs of equal kinds.
void forgive_inputs(const StepRecord& expected, StepRecord& actual, const Tolerances& tolerances);

/// The phases whose words are compared between two sessions.
struct PhaseMatch {
  std::vector<std::string> names;       ///< in the order of the first session; empty: no words can be compared
  std::vector<std::size_t> in_a, in_b;  ///< the place of each in a row of words
  bool equal = false;                   ///< same_phase_words(): rows are compared as they are
  bool in_order = true;                 ///< both sessions run them in one order
  bool all = true;                      ///< neither session has another phase
};

/// Phases of one engine match by their names, whatever their order; phases of ours only where all are the same, because
/// they change with the version of their hashes.
PhaseMatch match_phases(const LogHeader& a, const LogHeader& b);

/// Prepares a comparison of one step: leave_out_phase_words(), or where sessions have some phases in common, leaves the
/// words of these in both records, in the order of the first. Call it once for a pair of records.
void match_phase_words(const PhaseMatch& match, const LogHeader& a, const LogHeader& b, StepRecord& in_a,
                       StepRecord& in_b);

/// Whether both sessions are of engines that compute in binary32.
bool in_binary32(const LogHeader& a, const LogHeader& b);

/// Numbers of a state that an import computed from others; exact comparisons leave them out.
struct DerivedValues {
  bool velocity = false;
  bool spin = false;
};
/// Those of either log.
DerivedValues derived_values(const LogHeader& a, const LogHeader& b);
/// Copies them, those of thrown bodies too, and the energies that follow from them.
void forgive_derived(const DerivedValues& derived, const StepRecord& expected, StepRecord& actual);

/// Copies zeros whose sign alone differs. Returns their number.
std::uint64_t forgive_zeros(const BodyStates& expected, BodyStates& actual);

/// Likewise of the states and energies of a step. Returns the number of zeros of the states. For steps of other
/// engines: a change of axes turns 0.0 into −0.0, which is the same number there.
std::uint64_t forgive_zeros(const StepRecord& expected, StepRecord& actual);

}  // namespace tumble::replay
