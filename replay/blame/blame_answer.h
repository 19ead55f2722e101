#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/field_value.h"
#include "tumble/sim/ids.h"

/// A question about a value of a body, and the answers to it, as plain data.
namespace tumble::replay {

struct BlameQuestion {
  sim::BodyId body = 0;
  /// "velocity.x" or another of blame_fields() (body_motion.h). Empty: the component of position that changed most.
  std::string field;
  std::uint64_t step = 0;     ///< the value after this step
  std::uint32_t answers = 1;  ///< at most; each explains what the one before it came from
};

/// One part of a change.
struct BlameShare {
  std::string kind;  ///< "contact", "gravity", "velocity", "spin", "drag", "lift" (paid for by motion), "rest"
  std::optional<sim::BodyId> other;  ///< of a contact: the other body; none: the ground
  double amount = 0;                 ///< in the unit of the value
};

/// What last changed one value.
struct BlameAnswer {
  std::uint64_t step = 0;
  std::optional<std::uint32_t> substep;  ///< 0-based; none for phases that run once a step, inputs and the start
  /// The phase; "inputs" for what preceded the phases of the step; "start" for the first state of the log.
  std::string phase;
  std::optional<sim::BodyId> body;   ///< whose value; of a contact: the body that the chain came from
  bool contact = false;              ///< the value is one of the contact of `body` with `other`
  std::optional<sim::BodyId> other;  ///< of a contact; none: the ground
  std::string value;                 ///< "velocity.x"; of a contact: "load", "separation", "approach", "sweeps", …
  std::string unit;                  ///< "m/s"; empty without
  std::optional<FieldValue> before;  ///< none: there was no such value
  FieldValue after;
  std::vector<BlameShare> shares;  ///< largest first; empty where the phase has one cause
  bool exact = false;              ///< before and the shares add up to after, to the bit
  std::string origin;              ///< of an input or the start: "crash.toml:12", "input 2 of the scene"
  std::string text;                ///< the answer as a sentence, for people
};

struct Blame {
  BlameQuestion question;
  FieldValue value;  ///< asked about
  std::string unit;
  std::vector<BlameAnswer> answers;  ///< at least one
  bool complete = false;             ///< the last answer is where it began
  std::string ends;                  ///< the reason why the chain stops there
  bool damaged = false;              ///< which is that the step before cannot be read
  std::vector<std::string> notes;    ///< for people: what this account rests on, where the log is not whole
};

}  // namespace tumble::replay
