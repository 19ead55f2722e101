#pragma once

#include <cstdint>
#include <memory>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/session.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

namespace tumble::replay {

/// Success for a log that this project wrote. Errors (kBadInput): another engine wrote the log, so this build cannot
/// compute the steps.
Status must_be_ours(const LogReader& log);

/// The latest keyframe at or before state k that can be read: that of the chunk of step k where the chunk that begins
/// behind it is damaged. Errors: LogReader::keyframe_at_or_before's.
Result<const Keyframe*> intact_keyframe(LogReader& log, std::uint64_t k);

/// Steps this build's physics with the inputs of a log, from one of its keyframes on.
class Player {
 public:
  /// A world in state k of the log, first_state() … last_step(). Starts at the last keyframe up to k and simulates the
  /// steps in between. `log` must outlive the player. Errors: the log's, must_be_ours(), World::restore's, a step that
  /// fails.
  static Result<Player> at(LogReader& log, std::uint64_t k);

  /// Takes the next step of the log: applies its inputs, then steps. Returns this build's record of the step, with
  /// states, and phase words if the log has them; it lasts until the next step. `also`, if given, observes it too.
  /// Errors: the log has no further step (kBadInput); an input is refused or the step fails (kCannotFinish).
  Result<const StepRecord*> step(sim::Observer* also = nullptr);

  /// step() without the states. For most steps the hashes are enough; add_states() adds the states to the record.
  Result<const StepRecord*> step_hashes(sim::Observer* also = nullptr);
  /// Requires a step taken by this player.
  const StepRecord& add_states();

  /// Takes the steps up to step k, which must lie ahead, and compares the state after it with the log's. Errors:
  /// step()'s; kCannotFinish where this build computes another state, so that nothing it finds there is of the session.
  /// After an error the player cannot step on.
  Status step_to(std::uint64_t k);

  /// Sets the threads to step with; see World::use.
  void use(Workers* workers) { session_.use(workers); }

  [[nodiscard]] const sim::World& world() const { return session_.world(); }

 private:
  Player(LogReader& log, Session session);

  LogReader* log_;
  Session session_;
  std::unique_ptr<sim::PhaseHashes> hashes_;  // on the heap, because it cannot be moved
  StepRecord record_;
};

}  // namespace tumble::replay
