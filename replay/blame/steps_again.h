#pragma once

#include <cstdint>
#include <functional>
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

/// An input that changed a value of a body.
struct InputChange {
  sim::Command input;
  std::optional<double> before;  ///< none: there was no such body
  std::optional<double> after;
};

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

  /// The inputs before step k that changed a value of the body, in their order, from the last one on that sets it
  /// whatever it was: a throw, a set_velocity. Errors: account()'s.
  Result<std::vector<InputChange>> input_changes(std::uint64_t k, sim::BodyId body, std::size_t field);

  /// The inputs before step k that can have changed what contacts carry: another gravity, another dt, a removal.
  Result<std::vector<sim::Command>> load_changes(std::uint64_t k);

  /// Success where the log holds step k, from which state k follows. Errors: the log lacks it (kDamaged), or the log's.
  Status has_step(std::uint64_t k);

  [[nodiscard]] LogReader& log() { return *log_; }

 private:
  Status stand_before(std::uint64_t k);
  /// Called after each input, with the world that it made.
  using AfterInput = std::function<void(const sim::Command&, const sim::World&)>;
  Status apply_inputs(sim::World& world, const AfterInput& after_input = {});
  Status apply_again(std::uint64_t k, const std::function<void(const sim::World&)>& before, const AfterInput& after);
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
