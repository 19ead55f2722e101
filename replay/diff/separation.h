#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/diff/channel_difference.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/result.h"

/// The distance between two sessions after their first difference, step by step.
namespace tumble::replay {

/// Reads one of two sessions.
struct SessionSteps {
  std::string name;  ///< for messages: the path of a log, or "this build"
  /// The record of step k, with states. Called with ascending k; the record lasts until the next call.
  std::function<Result<const StepRecord*>(std::uint64_t k)> read;
};

/// Two sessions after one step.
struct SeparationRow {
  std::uint64_t step = 0;
  std::uint64_t bodies = 0;  ///< whose visible states differ in any bit, or that exist on one side only
  double separation = 0;     ///< m: largest distance of a body's centre in one from its centre in the other; infinite
                             ///< where a body that differs has a value that is no finite number
  std::optional<sim::BodyId> body;  ///< the body at that distance; none at 0
  std::uint64_t only_in_a = 0;      ///< bodies that are on one side only, which have no separation
  std::uint64_t only_in_b = 0;
};

/// Separations whose first step is reported, m.
inline constexpr std::array<double, 5> kSeparationMarks = {1e-12, 1e-9, 1e-6, 1e-3, 1e-2};

/// The first step after which the separation exceeded a mark.
struct SeparationMark {
  double above = 0;  ///< m
  std::uint64_t step = 0;
  sim::BodyId body = 0;
};

/// A body that differs and has a value that is infinite or not a number.
struct LostBody {
  std::uint64_t step = 0;
  sim::BodyId body = 0;
  std::string field;  ///< "velocity.x"
  bool in_a = false;  ///< the session that has the value; b otherwise
};

/// A channel that both sessions have and that differs in a step.
struct ChannelSeparation {
  std::string name;
  std::string unit;
  bool is_number = true;
  std::uint64_t from = 0;        ///< the first step in which it differs
  std::vector<double> distance;  ///< channel_distance() in each step of Separation::rows
  double largest = 0;
  std::uint64_t largest_step = 0;
};

/// The first contact of an engine that differs.
struct ContactSeparation {
  std::pair<sim::BodyId, sim::BodyId> pair;  ///< second 0: the ground
  std::string words;                         ///< "normal", "only the first log has this contact"
};

/// Steps are compared by their numbers. Where theirs differ in length, the states of one number are of other times.
struct ClockSeparation {
  std::uint64_t from = 0;  ///< the first step of another length
  double largest = 0;      ///< s between the ends of two steps of one number, since the first step compared
  std::uint64_t largest_step = 0;
};

struct Separation {
  std::vector<SeparationRow> rows;          ///< one a step, beginning with the first difference
  std::vector<SeparationMark> marks;        ///< those that were exceeded
  SeparationRow largest;                    ///< the row with the largest separation
  std::optional<LostBody> lost;             ///< the first one
  std::vector<ChannelSeparation> channels;  ///< those that differ in any step, by natural_less() of their names
  std::optional<ClockSeparation> clocks;    ///< none: all steps have equal lengths in both
  // What there was to compare in any step of either session.
  bool compares_contacts = true;   ///< else none, not even by number: two engines count them otherwise
  bool had_contacts = false;       ///< pairs or contacts
  bool contacts_by_value = false;  ///< contacts of an engine, compared in every bit; else by their number alone
  bool had_frozen = false;
  // The first step in which the sessions differ in kind; none: in no step.
  std::optional<std::uint64_t> contacts_from;      ///< in the number of pairs, contacts or substeps; contacts
                                                   ///< of an engine also in any value
  std::optional<ContactSeparation> first_contact;  ///< in step contacts_from; none: they differ in number alone
  std::optional<std::uint64_t> freezing_from;      ///< a body is frozen in one only
  std::optional<std::uint64_t> bodies_from;        ///< a body exists in one only
};

/// Compares the states of steps from … last, at least one. Errors: those of reading; kDamaged where the states of a log
/// do not match its state hash; kCannotFinish where `progress` stops. channels: of the two, which are compared; may be
/// null.
Result<Separation> measure_separation(const SessionSteps& a, const SessionSteps& b, std::uint64_t from,
                                      std::uint64_t last, const Progress& progress = {},
                                      const ChannelMatch* channels = nullptr);

}  // namespace tumble::replay
