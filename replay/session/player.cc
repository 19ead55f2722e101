#include "tumble/replay/player.h"

#include <string>
#include <utility>

#include "src/base/check.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// Passes each call on to two observers.
class Both : public sim::Observer {
 public:
  Both(sim::Observer& first, sim::Observer& second) : first_(first), second_(second) {}

  Hasher* phase_begins() override { return first_.phase_begins(); }
  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override {
    first_.phase_done(substep, phase, world);
    second_.phase_done(substep, phase, world);
  }

 private:
  sim::Observer& first_;
  sim::Observer& second_;
};

}  // namespace

Status must_be_ours(const LogReader& log) {
  if (!log.header().engine) return {};
  return bad_input(log.name() + ": this log was written by " + printable(to_string(*log.header().engine)) +
                   "; it cannot be replayed, only compared (diff, measure, dump, render, check)");
}

Player::Player(LogReader& log, Session session)
    : log_(&log), session_(std::move(session)), hashes_(std::make_unique<sim::PhaseHashes>()) {}

Result<const Keyframe*> intact_keyframe(LogReader& log, std::uint64_t k) {
  Result<const Keyframe*> keyframe = log.keyframe_at_or_before(k);
  const bool earlier =
      !keyframe.ok() && keyframe.error().kind == ErrorKind::kDamaged && k > log.first_state() && log.holds(k);
  return earlier ? log.keyframe_at_or_before(k - 1) : keyframe;
}

Result<Player> Player::at(LogReader& log, std::uint64_t k) {
  if (Status ok = must_be_ours(log); !ok.ok()) return ok.error();
  Result<const Keyframe*> keyframe = intact_keyframe(log, k);
  if (!keyframe.ok()) return keyframe.error();
  Result<Session> session = Session::resume((*keyframe)->state);
  if (!session.ok()) return Error{session.error().kind, log.name() + ": " + session.error().message};
  Player player(log, *std::move(session));
  while (player.session_.steps_done() < k) {
    if (Result<const StepRecord*> step = player.step_hashes(); !step.ok()) return step.error();
  }
  return player;
}

Result<const StepRecord*> Player::step(sim::Observer* also) {
  Result<const StepRecord*> taken = step_hashes(also);
  if (taken.ok()) add_states();
  return taken;
}

const StepRecord& Player::add_states() {
  SIM_CHECK(record_.step == session_.steps_done(), record_.step, session_.steps_done());
  record_.has_states = true;
  copy_visible(world().bodies(), record_.states);
  return record_;
}

// The inputs come from the log and not from its scene: the log has all of them, also those that were made live. The log
// is read for nothing else, so the record is this build's own.
Result<const StepRecord*> Player::step_hashes(sim::Observer* also) {
  const std::uint64_t k = session_.steps_done() + 1;
  const Result<const StepRecord*> logged = log_->read_hashes(k);
  if (!logged.ok()) return logged.error();
  hashes_->clear();
  sim::Observer* observer = also;
  Both both(*hashes_, also != nullptr ? *also : *hashes_);
  if (log_->header().hashes.holds(k)) observer = also != nullptr ? static_cast<sim::Observer*>(&both) : hashes_.get();
  const Result<TakenStep> taken = session_.step((*logged)->inputs, observer);
  // The log's input was accepted once. That this build refuses it is no fault of the user's.
  if (!taken.ok()) return cannot_finish(taken.error().message);
  record_.step = k;
  record_.dt = taken->dt;
  record_.inputs.assign(taken->inputs.begin(), taken->inputs.end());
  record_.phase_words = hashes_->words();
  record_.counters = taken->counters;
  record_.state_hash = sim::state_hash(world().bodies());
  record_.has_states = false;
  return &record_;
}

Status Player::step_to(std::uint64_t k) {
  SIM_CHECK(session_.steps_done() < k, session_.steps_done(), k);
  while (session_.steps_done() < k) {
    if (Result<const StepRecord*> taken = step_hashes(); !taken.ok()) return taken.error();
  }
  const Result<const StepRecord*> logged = log_->read_hashes(k);
  if (!logged.ok()) return logged.error();
  if ((*logged)->state_hash == record_.state_hash) return {};
  return cannot_finish(
      log_->name() + ": this build computes another state of step " + std::to_string(k) +
      " than the log holds, so its contacts are not those of the session; use the build that wrote it");
}

}  // namespace tumble::replay
