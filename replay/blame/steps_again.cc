#include "replay/blame/steps_again.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "replay/format/chain.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/player.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

/// Passes each call on to the phase hashes and to another observer.
class Hashing : public sim::Observer {
 public:
  explicit Hashing(sim::Observer* also) : also_(also) {}
  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override {
    hashes.phase_done(substep, phase, world);
    if (also_ != nullptr) also_->phase_done(substep, phase, world);
  }
  sim::PhaseHashes hashes;

 private:
  sim::Observer* also_;
};

std::string builds_text(const LogHeader& header) {
  const LogHeader own = header_for(header.scene);
  if (header.method_version == own.method_version) return "";
  return ": the log has version " + std::to_string(header.method_version) + " of method " + header.method +
         ", this build version " + std::to_string(own.method_version);
}

std::optional<BodyMotion> motion_in(const BodyStates& states, sim::BodyId body) {
  const auto at = std::ranges::lower_bound(states.id, body);
  if (at == states.id.end() || *at != body) return std::nullopt;
  return motion_of(states, static_cast<std::size_t>(at - states.id.begin()));
}

bool same_or_none(const std::optional<double>& a, const std::optional<double>& b) {
  return a.has_value() == b.has_value() && (!a || same_value(*a, *b));
}

// Whether an input that changed the value of a body left nothing of what was there before.
bool sets_value(const sim::Command& input, std::size_t field) {
  const bool of_velocity = quantity_of(field) == kVelocity || quantity_of(field) == kSpin;
  return std::holds_alternative<sim::Throw>(input) || field == kFrozenField ||
         (of_velocity && std::holds_alternative<sim::SetVelocity>(input));
}

Error other_step(const LogReader& log, std::uint64_t k, const Divergence& first) {
  const std::string step = std::to_string(k), before = std::to_string(k - 1);
  const bool any_before = k - 1 > log.first_state();
  return cannot_finish(
      log.name() + ": this build takes step " + step + " otherwise than the log" + builds_text(log.header()) +
      "; first difference: " + describe(first) + ". Its account of step " + step +
      " and later ones would be of another session. " +
      (any_before ? "Values up to --step " + before + " can be asked about; for later ones use" : std::string("Use")) +
      " the build that wrote the log (" + log.header().tool_version + ", " + log.header().tool_build +
      "), or record the scene with this build and ask that log; 'tumble replay' shows what differs");
}

}  // namespace

StepsAgain::StepsAgain(LogReader& log, const Progress& progress) : log_(&log), states_(log), progress_(progress) {}

Status StepsAgain::apply_inputs(sim::World& world, const AfterInput& after_input) {
  const std::uint64_t k = world.state().step + 1;
  const Result<const StepRecord*> logged = log_->read_hashes(k);
  if (!logged.ok()) return logged.error();
  record_ = {};
  record_.step = k;
  record_.inputs = (*logged)->inputs;
  for (const sim::Command& command : record_.inputs) {
    if (Status ok = sim::apply(world, command); !ok.ok()) {
      return cannot_finish(log_->name() + ": this build refuses the input \"" + sim::name_of(command) +
                           "\" before step " + std::to_string(k) + ": " + ok.error().message);
    }
    if (after_input) after_input(command, world);
  }
  record_.dt = world.state().def.dt;
  return {};
}

// Two records are compared by chain links from one common start: equal links mean equal records.
Status StepsAgain::step_and_compare(sim::World& world, sim::Observer* also) {
  const std::uint64_t k = record_.step;
  Hashing hashing(also);
  const Result<sim::StepCounters> counters = sim::step(world, &hashing);
  if (!counters.ok()) {
    return cannot_finish(log_->name() + ": this build cannot take step " + std::to_string(k) + ": " +
                         counters.error().message);
  }
  record_.phase_words = hashing.hashes.words();
  record_.counters = *counters;
  record_.state_hash = sim::state_hash(world.bodies());
  const Result<const StepRecord*> logged = log_->read_hashes(k);
  if (!logged.ok()) return logged.error();
  const LogHeader own = header_for(log_->header().scene);
  const bool words = same_phase_words(log_->header(), own, k);
  leave_out_phase_words(log_->header(), own, **logged, record_);
  if (chain_next({}, **logged) == chain_next({}, record_)) return {};
  StepRecord expected = **logged;
  expected.has_states = false;
  const std::optional<Divergence> first =
      first_difference(expected, record_, words ? own.phases : std::vector<std::string>());
  return other_step(*log_, k,
                    first.value_or(make_divergence(k, "step", "state_hash", to_string(expected.state_hash),
                                                   to_string(record_.state_hash))));
}

// From the state kept, if that lies between the keyframe and the step; else from the keyframe.
Status StepsAgain::stand_before(std::uint64_t k) {
  if (before_ && before_->state().step == k - 1) return {};
  if (const MissingSteps* lost = log_->lost_at(k); lost != nullptr) {
    return bad_input(log_->name() + ": found no step " + std::to_string(k) + ": " + to_string(*lost) +
                     " were lost before the log was recovered");
  }
  Result<const Keyframe*> keyframe = log_->keyframe_at_or_before(k - 1);
  if (!keyframe.ok()) return keyframe.error();
  const bool goes_on = before_ && before_->state().step < k && before_->state().step > (*keyframe)->state.step;
  Result<sim::World> world =
      goes_on ? Result<sim::World>(*std::move(before_)) : sim::World::restore((*keyframe)->state);
  before_.reset();
  if (!world.ok()) return Error{world.error().kind, log_->name() + ": " + world.error().message};
  while (world->state().step + 1 < k) {
    const std::uint64_t done = world->state().step;
    if (progress_ && !progress_(done, k)) return cannot_finish("interrupted");
    if (Status ok = apply_inputs(*world); !ok.ok()) return ok;
    if (Status ok = step_and_compare(*world, nullptr); !ok.ok()) return ok;
  }
  before_ = *std::move(world);
  return {};
}

Result<sim::World> StepsAgain::world_before(std::uint64_t k) {
  if (Status ok = must_be_ours(*log_); !ok.ok()) return ok.error();
  if (k <= log_->first_state() || k > log_->last_step()) {
    return bad_input(log_->name() + ": found no step " + std::to_string(k) + " to take again, wanted " +
                     std::to_string(log_->first_state() + 1) + " to " + std::to_string(log_->last_step()));
  }
  if (Status ok = stand_before(k); !ok.ok()) return ok.error();
  sim::World world = *before_;
  if (Status ok = apply_inputs(world); !ok.ok()) return ok.error();
  return world;
}

Status StepsAgain::take(sim::World& world, sim::Observer& observer) { return step_and_compare(world, &observer); }

Result<BodyAccount> StepsAgain::account(std::uint64_t k, sim::BodyId body) {
  Result<sim::World> world = world_before(k);
  if (!world.ok()) return world.error();
  if (!world->bodies().find(body)) {
    return bad_input(log_->name() + ": found no body " + std::to_string(body) + " in step " + std::to_string(k));
  }
  AccountObserver observer(*world, body);
  world->mutable_scratch().layers = &observer;
  if (Status ok = take(*world, observer); !ok.ok()) return ok.error();
  return observer.take();
}

Result<std::optional<BodyMotion>> StepsAgain::after(std::uint64_t k, sim::BodyId body) {
  const bool in_block = body == block_body_ && k >= block_from_ && k - block_from_ < block_.size();
  if (!in_block) {
    const Result<const Keyframe*> keyframe = intact_keyframe(*log_, k);
    if (!keyframe.ok()) return keyframe.error();
    block_body_ = body;
    block_from_ = (*keyframe)->state.step;
    // From the keyframe itself: the record of the step that ended there may be lost.
    BodyStates first;
    copy_visible((*keyframe)->state.bodies, first);
    block_ = {motion_in(first, body)};
    if (progress_ && !progress_(0, 1)) return cannot_finish("interrupted");
    for (std::uint64_t j = block_from_ + 1; j <= k; ++j) {
      const Result<const StepRecord*> record = states_.read(j);
      if (!record.ok()) {
        block_.clear();
        return record.error();
      }
      block_.push_back(motion_in((*record)->states, body));
    }
  }
  return block_[k - block_from_];
}

Result<std::vector<sim::Command>> StepsAgain::inputs(std::uint64_t k) {
  const Result<const StepRecord*> logged = log_->read_hashes(k);
  if (!logged.ok()) return logged.error();
  return (*logged)->inputs;
}

Status StepsAgain::apply_again(std::uint64_t k, const std::function<void(const sim::World&)>& before,
                               const AfterInput& after) {
  if (Status ok = stand_before(k); !ok.ok()) return ok;
  sim::World world = *before_;
  before(world);
  return apply_inputs(world, after);
}

Result<std::vector<InputChange>> StepsAgain::input_changes(std::uint64_t k, sim::BodyId body, std::size_t field) {
  std::vector<InputChange> changes;
  std::optional<double> value;
  const auto value_in = [&](const sim::World& world) -> std::optional<double> {
    const auto row = world.bodies().find(body);
    return row ? std::optional(motion_of(world.bodies(), *row).of(field)) : std::nullopt;
  };
  const Status ok = apply_again(
      k, [&](const sim::World& world) { value = value_in(world); },
      [&](const sim::Command& input, const sim::World& world) {
        const std::optional<double> now = value_in(world);
        if (same_or_none(value, now)) return;
        if (sets_value(input, field)) changes.clear();
        changes.push_back({input, std::exchange(value, now), now});
      });
  if (!ok.ok()) return ok.error();
  return changes;
}

Result<std::vector<sim::Command>> StepsAgain::load_changes(std::uint64_t k) {
  std::vector<sim::Command> changes;
  sim::Vec3 gravity;
  double dt = 0;
  const auto keep = [&](const sim::World& world) {
    gravity = world.state().def.gravity;
    dt = world.state().def.dt;
  };
  const Status ok = apply_again(k, keep, [&](const sim::Command& input, const sim::World& world) {
    const bool other = !(gravity == world.state().def.gravity) || dt != world.state().def.dt;
    if (other || std::holds_alternative<sim::Remove>(input)) changes.push_back(input);
    keep(world);
  });
  if (!ok.ok()) return ok.error();
  return changes;
}

Status StepsAgain::has_step(std::uint64_t k) {
  if (k == log_->first_state()) return {};
  if (const MissingSteps* lost = log_->lost_at(k); lost != nullptr) {
    return damaged(log_->name() + ": found no step " + std::to_string(k) + ": " + to_string(*lost) +
                   " were lost before the log was recovered");
  }
  const Result<const StepRecord*> logged = log_->read_hashes(k);
  return logged.ok() ? Status() : logged.error();
}

}  // namespace tumble::replay
