#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tumble/replay/body_table.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// What another engine's session was told beside its states: gravity, ground, masses, materials, names, precision,
/// phases; dt and inputs of its steps. A golden of an engine's case keeps it, so that a difference is named as `diff`
/// names it. A session of Tumble has its scene.toml instead.
namespace tumble::golden {

/// What was done before one step, where that says more than the step before: another dt, or an input.
struct StepSetup {
  std::uint64_t step = 0;
  double dt = 0;  ///< s; holds for the steps that follow too
  std::vector<sim::Command> inputs;
  friend bool operator==(const StepSetup&, const StepSetup&) = default;
};

struct ExpectedSetup {
  /// As header_of_setup() gives it.
  replay::LogHeader header;
  std::vector<StepSetup> steps;   ///< ascending
  std::uint64_t steps_until = 0;  ///< up to this step all of them are kept; beyond it there were too many
  friend bool operator==(const ExpectedSetup& a, const ExpectedSetup& b) {
    return a.steps == b.steps && a.steps_until == b.steps_until && a.header.scene == b.header.scene &&
           a.header.phases == b.header.phases && a.header.engine == b.header.engine &&
           a.header.declared == b.header.declared;
  }
};

/// The part of an engine's log header that a golden keeps: without the motions of the bodies, which state 0 has, and
/// without what only a person reads.
replay::LogHeader header_of_setup(const replay::LogHeader& header);

/// Collects it from a session: state 0, then every step in order.
class SetupKeeper {
 public:
  explicit SetupKeeper(const replay::LogHeader& header);
  void add(const replay::StepRecord& record);
  /// None for a session of Tumble.
  std::optional<ExpectedSetup> finish();

 private:
  std::optional<ExpectedSetup> setup_;
  std::size_t inputs_ = 0;
  double dt_ = 0;
};

/// In what the start of a session was told otherwise than its golden, a sentence each: "body 4 friction: 0.5 → 0.9",
/// "phase hashes: solve, advance → none". At most twelve, and one that counts the rest.
std::vector<std::string> setup_differences(const replay::LogHeader& expected, const replay::LogHeader& actual);

/// Of the names of the phases alone: one sentence, or none.
std::vector<std::string> phase_differences(const std::vector<std::string>& expected,
                                           const std::vector<std::string>& actual);

/// "before step 7, dt: 0.0166 → 0.02", "before step 7, push.impulse.x of body 2 (hip): 1 → 2"; empty where the golden
/// keeps nothing of that step or both are equal.
std::string step_difference(const ExpectedSetup& expected, const replay::StepRecord& record,
                            const replay::BodyTable& names);

}  // namespace tumble::golden
