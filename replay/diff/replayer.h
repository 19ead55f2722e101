#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "replay/diff/divergence.h"
#include "replay/log/log_reader.h"
#include "replay/session/recorder.h"
#include "src/base/result.h"
#include "src/step/step.h"
#include "src/world/world.h"

namespace tumble::replay {

/// Errors (kBadInput): the log is another engine's, whose steps nobody here can compute.
Status must_be_ours(const LogReader& log);

/// Feeds a log's inputs to this build's stepper, from a keyframe on.
class Player {
 public:
  /// A world in state k of the log, first_state() … last_step(): the keyframe at or before it, and the steps between
  /// simulated again. `log` must outlive the player. Errors: the log's, must_be_ours(), World::restore's, a step that
  /// fails.
  static Result<Player> at(LogReader& log, std::uint64_t k);

  /// Takes the next step of the log: its inputs, then the step. The record is what this build makes of it, with states.
  /// `also` watches it too. Errors: no further step (kBadInput); an input that is refused or a step that fails
  /// (kCannotFinish).
  Result<const StepRecord*> step(sim::Observer* also = nullptr);

  /// The same without states, which add_states() adds to the record: for most steps the hashes are enough.
  Result<const StepRecord*> step_hashes(sim::Observer* also = nullptr);
  const StepRecord& add_states();

  /// Threads to step with; see World::use.
  void use(Workers* workers) { world_.use(workers); }

  [[nodiscard]] const sim::World& world() const { return world_; }

 private:
  Player(LogReader& log, sim::World world) : log_(&log), world_(std::move(world)) {}

  LogReader* log_;
  sim::World world_;
  std::unique_ptr<sim::PhaseHashes> hashes_ = std::make_unique<sim::PhaseHashes>();  // which cannot be moved
  StepRecord record_;
};

struct ReplayOptions {
  /// Compare from the state after this step on; the log's first state or less replays all. The keyframe at or before it
  /// is trusted.
  std::uint64_t from_step = 0;
  Workers* workers = nullptr;  ///< threads to step with; see World::use
};

struct ReplayReport {
  std::uint64_t steps = 0;          ///< compared
  std::optional<Divergence> first;  ///< none: identical to the bit, the last step included
  Hash128 final_hash;               ///< state hash of the last state this build computed
  std::vector<std::string> notes;   ///< for people: another method version, phases that cannot be compared, a torn end
  [[nodiscard]] bool identical() const { return !first.has_value(); }
};

/// Replays a log and compares every step with it, the last included: dt and inputs, phase words, state hash, counters;
/// where they differ, the states say body and field. (That a log's states are those its state hashes tell of is
/// verify()'s matter.) Where a chunk ends, the hidden state is compared too, by the next keyframe's continuation hash,
/// if this build has the log's method version. From state 0 on, that comes first: the scene must still resolve to it.
/// A session that goes on from another one's state is replayed from its keyframe. Stops at the first difference.
/// Errors: must_be_ours(); a log that cannot be read on (kDamaged, naming the steps compared before), nothing to
/// compare (kDamaged). A step that this build cannot take is a Divergence with the field "error".
Result<ReplayReport> replay_log(LogReader& log, const ReplayOptions& options = {}, const Progress& progress = {});

}  // namespace tumble::replay
