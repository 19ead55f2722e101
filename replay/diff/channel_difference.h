#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/divergence.h"
#include "tumble/replay/header_difference.h"
#include "tumble/replay/step_record.h"
#include "tumble/replay/tolerance.h"

/// Values of channels, and contacts of another engine, compared between two logs.
namespace tumble::replay {

/// A channel that two logs have, of one scope. Kinds of numbers may differ: a table's whole numbers are integers,
/// though another table of the channel may have others. Such values are compared by their digits.
struct SharedChannel {
  std::string name;
  ChannelType type;                            ///< in the first log
  ChannelKind kind_b = ChannelKind::kFloat64;  ///< in the second: of numbers both, where the two differ
  std::string unit;
  std::size_t in_a = 0;  ///< index in the first log's Declared::channels
  std::size_t in_b = 0;
};

/// The channels of two logs, and how each is compared.
struct ChannelMatch {
  std::vector<SharedChannel> compared;
  std::vector<std::string> passed_over;  ///< for people: name and reason of each channel that is not compared
  bool contacts = true;                  ///< contacts are compared too
  std::string contacts_why = "contacts of the engines: the logs are of two engines";  ///< why they are not, for people
  /// Channels of one engine that hold values of other kinds in the two logs, as text and numbers: differences.
  std::vector<Divergence> other_kinds;
  bool equal = true;  ///< both logs declare the same channels and all is compared, so chains can be compared
};

/// Whether two logs are of two engines, or one of them of this program.
bool are_two_engines(const LogHeader& a, const LogHeader& b);

/// two_engines: only channels with a tolerance are compared, because equal names of two engines need not mean equal
/// numbers; contacts are not.
ChannelMatch match_channels(const LogHeader& a, const LogHeader& b, const Tolerances& tolerances, bool two_engines);

/// Of one engine: leaves contacts out where one log alone has any, and names them in `only_in`. Its recorder told none,
/// as it tells no channel that it lacks. Returns whether it did.
inline bool leave_out_contacts_of_one(bool in_a, bool in_b, ChannelMatch& match, OnlyInOne& only_in) {
  if (in_a == in_b || !match.contacts) return false;
  match.contacts = match.equal = false;
  match.contacts_why = std::string("contacts: only the ") + (in_a ? "first" : "second") + " log has any";
  (in_a ? only_in.a : only_in.b).emplace_back("contacts");
  return true;
}

/// The first contact in which two lists differ in any bit, by pair and number; no step.
std::optional<Divergence> contact_difference(const std::vector<EngineContact>& a, const std::vector<EngineContact>& b);

/// Of the channels that are compared, by natural_less().
std::vector<std::string> names_of(const ChannelMatch& match);

/// Makes every extra of `actual` equal to that of `expected` that `match` does not compare, so that a chain over both
/// records compares the rest.
void leave_out_channels(const ChannelMatch& match, const StepRecord& expected, StepRecord& actual);

/// Whether two records of a step have equal chains from one start, channels that are not compared left out.
bool same_step(const ChannelMatch& match, const StepRecord& expected, const StepRecord& actual);

/// The first value that differs: by channel in the order of names, then by body or pair; then the first contact.
/// Differences within their tolerance ("channel.NAME" in Tolerances::fields) count as equal. The field is
/// "channel.NAME", "contact.depth" or the like, or "contacts" (another number of them); the phase is "channels" or
/// "contacts".
std::optional<Divergence> first_extra_difference(const ChannelMatch& match, const StepRecord& expected,
                                                 const StepRecord& actual, const Tolerances& tolerances);

/// How far a channel is apart in one step: the largest distance of two numbers, infinite where a value is missing on
/// one side or is no number; of bytes and text, the number of values that differ. 0: equal to the bit.
double channel_distance(const SharedChannel& channel, const StepRecord& a, const StepRecord& b);

/// One channel, or the contacts, of a step side by side.
struct ExtraRow {
  std::string name;                 ///< "channel.NAME", "contacts"
  std::size_t in_a = 0, in_b = 0;   ///< values or contacts
  std::optional<Divergence> first;  ///< the first that differs; none: all are equal
};
/// By natural_less() of the names, contacts last.
std::vector<ExtraRow> extras_side_by_side(const ChannelMatch& match, const StepRecord& a, const StepRecord& b);

/// Adds first_extra_difference() to the first difference that was found in the rest of the step. A channel that differs
/// is nearer to the cause than an energy; where a state differs in the same step, the note names the channels that
/// differ too.
void add_extra_difference(const ChannelMatch& match, const StepRecord& expected, const StepRecord& actual,
                          const Tolerances& tolerances, std::optional<Divergence>& first);

/// For people: what a comparison leaves out of channels, contacts and derived values, each with its reason.
std::vector<std::string> left_out(const ChannelMatch& match, const DerivedValues& derived, bool imported,
                                  const Tolerances& tolerances);

}  // namespace tumble::replay
