#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/output/text.h"

namespace tumble::replay {
struct ComparisonScope;
}

namespace tumble::tools::bisect {

/// A revision's answer to the question.
struct Answer {
  bool asked = false;                 ///< false: the revision does not build, or cannot read the log; it is skipped
  bool yes = false;                   ///< same bits, within the bound, passed
  std::string message = {};           ///< the reason, a line
  std::optional<double> metric = {};  ///< the value of the metric asked about
  std::string not_repeatable = {};    ///< "3 of 5 yes, 2 no": what it answered when asked again; empty: always the same
  std::string outcome = {};           ///< of a session unlike the log: how it differs, with its last hash; else empty
  std::string other = {};             ///< the message of another run with another outcome; empty: there was none
  /// The first difference of two sessions that the revision recorded: AskedSessions::difference().
  std::string sessions_differ = {};
};

/// Whether both are of sessions unlike the log, and unlike each other.
bool differ(const Answer& a, const Answer& b);

/// One answer of several to the same question: the most frequent one, and where they are not all alike not_repeatable,
/// or where they agree but their sessions do not, other.
/// Of equally many, that it cannot be asked. Precondition (SIM_CHECK): at least one.
Answer answer_of(const std::vector<Answer>& answers);

/// Of a revision that cannot be asked.
Answer skipped(const std::string& why);

/// "differs from step 12 on, phase integrate, body 7, position.x" of the key "first" of a report that another version
/// of this program may have written.
std::string differs_text(const Json& first);

/// Of a report of a replay that found no difference: hashes that it had none of are the part that matters.
std::string same_text(const Json& report);

/// "the same in every bit", or of what was compared, with what was passed over.
std::string same_text(const replay::ComparisonScope& scope);

}  // namespace tumble::tools::bisect
