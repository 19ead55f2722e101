#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/blame/body_account.h"
#include "replay/blame/body_motion.h"
#include "replay/session/state_source.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world.h"

namespace tumble::replay {

/// Takes single steps of a log again, from the nearest keyframe before, and answers only of steps that this build takes
/// as the log says: each step from the keyframe on is compared with the log's record.
class StepsAgain {
 public:
  /// `log` must outlive this object; others may read from it between two calls.
  explicit StepsAgain(LogReader& log, const Progress& progress = {});

  /// What step k did to a body. Errors: k or the body does not exist (kBadInput); this build takes a step otherwise
  /// than the log, or the caller stops (kCannotFinish); the log's.
  Result<BodyAccount> account(std::uint64_t k, sim::BodyId body);

  /// The world before step k, its inputs applied, which take() then steps.
  Result<sim::World> world_before(std::uint64_t k);

  /// Takes the next step of world_before()'s world and compares it with the log's record. Errors: likewise.
  Status take(sim::World& world, sim::Observer& observer);

  /// The body after step k of first_state() … last_step(), as the log holds it; none where the body does not exist.
  /// Errors: the log's; kCannotFinish where the caller stops.
  Result<std::optional<BodyMotion>> after(std::uint64_t k, sim::BodyId body);

  /// The inputs that the log applied before step k.
  Result<std::vector<sim::Command>> inputs(std::uint64_t k);

  [[nodiscard]] LogReader& log() { return *log_; }

 private:
  Status stand_before(std::uint64_t k);
  Status apply_inputs(sim::World& world);
  Status step_and_compare(sim::World& world, sim::Observer* also);

  LogReader* log_;
  StateSource states_;
  Progress progress_;
  // The world that steps were taken from last. With its scratch: a build whose steps depend on it is a wrong one, and
  // must still be seen to repeat its own log.
  std::optional<sim::World> before_;
  StepRecord record_;  // of the step that is being taken, by this build
  // The states of one body from `block_from_` on.
  sim::BodyId block_body_ = 0;
  std::uint64_t block_from_ = 0;
  std::vector<std::optional<BodyMotion>> block_;
};

}  // namespace tumble::replay
