#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "golden/hunt/judge/trace.h"

namespace tumble::hunt {

enum class Outcome : std::uint8_t { kHeld, kBroken, kNotApplicable };

/// The judgement of one relation or law on one scene.
struct Judgement {
  Outcome outcome = Outcome::kHeld;
  std::uint64_t step = 0;  ///< the first in which it is broken
  std::string phase;       ///< that parts first; empty: none can be named
  sim::BodyId body = 0;    ///< the first of them; 0: no single one
  std::string what;        ///< a sentence: what was found, or why it does not apply
  double value = 0;        ///< found; of a broken one
  double bound = 0;        ///< allowed; 0: nothing is
  std::string unit;        ///< of both
};

/// A claim about every session: a relation between two ways of computing it, or a law of physics.
struct Relation {
  const char* name;
  const char* claim;  ///< one sentence, for reports and docs/hunting.md
  bool is_law;
  Judgement (*judge)(const Trace& trace);
};

/// All of them, in the order in which they are judged; a session that fails is judged by `finishes` alone.
std::span<const Relation> relations();

/// Null: none of that name.
const Relation* find_relation(std::string_view name);

/// "step 12, phase push_contacts, body 3: momentum changed: 0.02 kg m/s, allowed 1e-9"
std::string describe(const Judgement& judgement);

inline Judgement held() { return {}; }
inline Judgement not_applicable(std::string why) {
  Judgement out;
  out.outcome = Outcome::kNotApplicable;
  out.what = std::move(why);
  return out;
}

/// A value that is beyond a bound, in the step that leads to state `step`.
inline Judgement broken(std::uint64_t step, sim::BodyId body, std::string what, double value = 0, double bound = 0,
                        std::string unit = {}) {
  return {Outcome::kBroken, step, {}, body, std::move(what), value, bound, std::move(unit)};
}

}  // namespace tumble::hunt
