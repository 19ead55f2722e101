#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "replay/diff/separation.h"
#include "tools/output/text.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/comparison_scope.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {

/// {"identical":…, "steps":…, "first":null|{…}}: the common part of `replay --json` and `diff --json`.
Json comparison_json(bool identical, std::uint64_t steps, const std::optional<replay::Divergence>& first);

/// An answer about states needs states that are those of the log's own hash. Errors (kDamaged): they are not.
Status check_states(const replay::LogReader& log, const replay::StepRecord& record);

/// The bits of a double or of a word, as 0x and 16 hexadecimal digits.
std::string hex_text(double value);
std::string hex_text(std::uint64_t word);

Json value_json(const replay::FieldValue& value);
/// The members of "first" in that JSON.
Json divergence_json(const replay::Divergence& first);

/// What columns and values of two sessions are labelled by.
struct Sides {
  std::string expected = "expected";
  std::string actual = "actual";
  /// Of bodies whose ids are made of their names.
  std::map<sim::BodyId, std::string> names = {};

  /// "body 7"; "body wheel_fl" of a body in `names`.
  [[nodiscard]] std::string body(sim::BodyId id) const;
  /// A text with the name wherever it has the id of a body in `names`, which is no other number: "body wheel_fl".
  [[nodiscard]] std::string named(std::string text) const;
};

/// The names of two files; their paths where the names are the same.
Sides sides_of(const std::string& a, const std::string& b);
/// Likewise of two logs, with the names of their bodies.
Sides sides_of(replay::LogReader& a, replay::LogReader& b);

/// Adds the names of body and pair; a body that the first log does not name may have one in the second.
void name_bodies(replay::LogReader& a, replay::LogReader& b, replay::Divergence& found);

/// Prints the first difference for people, in a few aligned lines.
void print_divergence(const replay::Divergence& first, const Sides& sides);

/// A difference of a state in one line: "step 45, from phase solve on, body 7, velocity.x, 3e-12 m/s apart". A phase
/// hash tells where in the step the two part, and not which phase changed the field; nothing may tell it.
std::string effect_text(const replay::Divergence& effect, const Sides& sides);

/// How far the clocks of two sessions with steps of other lengths are apart. None: null.
std::string clocks_text(const replay::ClockSeparation& clocks);
Json clocks_json(const std::optional<replay::ClockSeparation>& clocks);

/// The bytes that a comparison of two logs from end to end has read.
std::string read_of(const replay::LogReader& a, const replay::LogReader& b);
/// Prints what an answer speaks of and what it does not.
void print_scope(const replay::ComparisonScope& scope);
/// {"a": […], "b": […]}: data that one of two logs alone has.
Json only_in_json(const replay::OnlyInOne& only_in);
/// Adds "compared" and "not_compared", lists of texts.
void add_scope(const replay::ComparisonScope& scope, Json& json);

}  // namespace tumble::tools
