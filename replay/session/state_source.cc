#include "replay/session/state_source.h"

#include <string>
#include <utility>

namespace tumble::replay {

Result<const StepRecord*> StateSource::read(std::uint64_t k) {
  if (player_ && record_.has_states && record_.step == k) return &record_;
  Result<const StepRecord*> stored = log_->read_step(k);
  if (!stored.ok() || (*stored)->has_states) return stored;
  record_ = **stored;
  if (Status ok = simulate(k); !ok.ok()) return ok.error();
  copy_visible(player_->world().bodies(), record_.states);
  const Hash128 computed = state_hash(record_.states);
  if (computed != record_.state_hash) {
    return cannot_finish(log_->name() + ": step " + std::to_string(k) +
                         ": the log holds no states there, and this build computes others (state hash " +
                         to_string(computed) + ", in the log " + to_string(record_.state_hash) +
                         "); use the build that wrote it, or record with --states all");
  }
  record_.has_states = true;
  return &record_;
}

// Keeps the player between calls: the next state in order costs one step. Any other costs the steps since the keyframe
// before it.
Status StateSource::simulate(std::uint64_t k) {
  if (player_ && player_->world().state().step + 1 == k) {
    Result<const StepRecord*> played = player_->step_hashes();
    if (!played.ok()) player_.reset();  // it may stand within the step
    return played.ok() ? Status() : played.error();
  }
  Result<Player> player = Player::at(*log_, k);
  if (!player.ok()) return player.error();
  player_.emplace(*std::move(player));
  return {};
}

}  // namespace tumble::replay
