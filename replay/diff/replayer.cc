#include "replay/diff/replayer.h"

#include <algorithm>
#include <utility>

namespace tumble::replay {
namespace {

/// Two observers of one step.
class Both : public sim::Observer {
 public:
  Both(sim::Observer& first, sim::Observer& second) : first_(first), second_(second) {}
  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override {
    first_.phase_done(substep, phase, world);
    second_.phase_done(substep, phase, world);
  }

 private:
  sim::Observer& first_;
  sim::Observer& second_;
};

Divergence failed_at(std::uint64_t step, const char* phase, const Error& error) {
  Divergence divergence;
  divergence.step = step;
  divergence.phase = phase;
  divergence.field = "error";
  divergence.expected = std::string("none");
  divergence.actual = error.message;
  return divergence;
}

/// Whether the log's scene still resolves to its state 0.
Result<std::optional<Divergence>> compare_start(LogReader& log) {
  Result<const StepRecord*> expected = log.read_step(0);
  if (!expected.ok()) return expected.error();
  Result<sim::World> world = sim::create_world(log.header().scene);
  if (!world.ok()) return std::optional(failed_at(0, "start", world.error()));
  BodyStates actual;
  copy_visible(world->bodies(), actual);
  std::optional<Divergence> found = first_difference((*expected)->states, actual);
  if (found) found->phase = "start";
  return found;
}

std::vector<std::string> notes_of(const LogReader& log, const LogHeader& ours_now) {
  const LogHeader& header = log.header();
  std::vector<std::string> notes;
  const std::uint32_t ours = sim::method_version(header.scene.world.method);
  if (header.method_version != ours) {
    notes.push_back("the log was recorded with version " + std::to_string(header.method_version) + " of method " +
                    header.method + ", this build has version " + std::to_string(ours));
  }
  const bool same_names = header.phases == ours_now.phases && header.phase_rows_max == ours_now.phase_rows_max;
  if (!same_names) {
    notes.emplace_back("the phases of the method have changed since: only states are compared");
  } else if (!same_phase_words(header, ours_now)) {
    notes.push_back(phase_hash_note(header, ours_now));
  }
  if (!log.condition().whole()) notes.push_back("the log is not whole: " + log.condition().summary(log.last_step()));
  return notes;
}

/// The difference in step k, if there is one. States are decoded only then: for most steps the hashes are enough.
/// phases: empty where phase words cannot be compared.
Result<std::optional<Divergence>> compare_step(LogReader& log, const StepRecord& actual, Player& player,
                                               const std::vector<std::string>& phases) {
  Result<const StepRecord*> read = log.read_hashes(actual.step);
  if (!read.ok()) return read.error();
  StepRecord expected = **read;
  if (phases.empty()) leave_out_phase_words(actual, expected);
  std::optional<Divergence> found = first_difference(expected, actual, phases);
  if (!found || !(*read)->has_states) return found;
  read = log.read_step(actual.step);
  if (!read.ok()) return read.error();
  expected = **read;
  if (phases.empty()) leave_out_phase_words(actual, expected);
  return first_difference(expected, player.add_states(), phases);
}

/// After the last step of a chunk: whether the hidden state is that of the keyframe which follows.
Result<std::optional<Divergence>> compare_hidden(LogReader& log, const sim::WorldState& state) {
  const auto& chunks = log.chunks();
  const auto next = std::partition_point(chunks.begin(), chunks.end(),
                                         [&](const ChunkPlace& place) { return place.first_step <= state.step; });
  const bool comes = next != chunks.end() && next->first_step == state.step + 1;
  const bool same_version = log.header().method_version == sim::method_version(state.def.method);
  if (!comes || !same_version) return std::optional<Divergence>();
  Result<const Keyframe*> keyframe = log.keyframe_at_or_before(state.step);
  if (!keyframe.ok()) return keyframe.error();
  const Hash128 actual = sim::continuation_hash(state);
  if ((*keyframe)->continuation_hash == actual) return std::optional<Divergence>();
  Divergence divergence;
  divergence.step = state.step;
  divergence.phase = "step";
  divergence.field = "continuation_hash";
  divergence.expected = to_string((*keyframe)->continuation_hash);
  divergence.actual = to_string(actual);
  return std::optional(divergence);
}

}  // namespace

Status must_be_ours(const LogReader& log) {
  if (!log.header().engine) return {};
  return bad_input(log.name() + ": this log was written by " + to_string(*log.header().engine) +
                   "; it cannot be replayed, only compared (diff, measure, dump, render, check)");
}

Result<Player> Player::at(LogReader& log, std::uint64_t k) {
  if (Status ok = must_be_ours(log); !ok.ok()) return ok.error();
  Result<const Keyframe*> keyframe = log.keyframe_at_or_before(k);
  if (!keyframe.ok()) return keyframe.error();
  Result<sim::World> world = sim::World::restore((*keyframe)->state);
  if (!world.ok()) return Error{world.error().kind, log.name() + ": " + world.error().message};
  Player player(log, *std::move(world));
  while (player.world_.state().step < k) {
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
  record_.has_states = true;
  copy_visible(world_.bodies(), record_.states);
  return record_;
}

Result<const StepRecord*> Player::step_hashes(sim::Observer* also) {
  const std::uint64_t k = world_.state().step + 1;
  Result<const StepRecord*> logged = log_->read_hashes(k);
  if (!logged.ok()) return logged.error();
  record_.inputs = (*logged)->inputs;
  for (const sim::Command& command : record_.inputs) {
    if (Status ok = sim::apply(world_, command); !ok.ok()) {
      return cannot_finish("input \"" + std::string(sim::name_of(command)) + "\" before step " + std::to_string(k) +
                           ": " + ok.error().message);
    }
  }
  record_.dt = world_.state().def.dt;
  hashes_->clear();
  Both both(*hashes_, also != nullptr ? *also : *hashes_);
  Result<sim::StepCounters> counters =
      sim::step(world_, also != nullptr ? &both : static_cast<sim::Observer*>(hashes_.get()));
  if (!counters.ok()) return counters.error();
  record_.step = k;
  record_.phase_words = hashes_->words();
  record_.counters = *counters;
  record_.state_hash = sim::state_hash(world_.bodies());
  record_.has_states = false;
  return &record_;
}

namespace {

/// replay_log() for a log of ours.
Result<ReplayReport> replay_steps(LogReader& log, const ReplayOptions& options, const Progress& progress) {
  const LogHeader& header = log.header();
  const std::uint64_t from = std::max(options.from_step, log.first_state());
  const std::uint64_t last = log.last_step();
  const LogHeader ours_now = header_for(header.scene);
  ReplayReport report;
  report.notes = notes_of(log, ours_now);
  const bool has_scene = !header.recovered || !header.recovered->header_lost;  // and not one made of state 0
  if (from == 0 && has_scene) {
    Result<std::optional<Divergence>> start = compare_start(log);
    if (!start.ok()) return start.error();
    report.first = *std::move(start);
    if (report.first) return report;
  }
  Result<Player> player = Player::at(log, from);
  if (!player.ok()) return player.error();
  player->use(options.workers);
  const bool same_words = same_phase_words(header, ours_now);
  const std::vector<std::string> phases = same_words ? header.phases : std::vector<std::string>();
  for (std::uint64_t k = from + 1; k <= last; ++k) {
    if (const Gap* gap = log.lost_at(k); gap != nullptr) {
      k = gap->end_step();
      if (player = Player::at(log, k - 1); !player.ok()) return player.error();
      player->use(options.workers);
    }
    const auto unreadable = [&](const Error& error) {
      return Error{error.kind, error.message + "; the steps before step " + std::to_string(k) + " replayed the same"};
    };
    if (Result<const StepRecord*> logged = log.read_hashes(k); !logged.ok()) return unreadable(logged.error());
    Result<const StepRecord*> actual = player->step_hashes();
    if (actual.ok()) {
      Result<std::optional<Divergence>> found = compare_step(log, **actual, *player, phases);
      if (found.ok() && !*found) found = compare_hidden(log, player->world().state());
      if (!found.ok()) return unreadable(found.error());
      report.first = *std::move(found);
    } else {
      report.first = failed_at(k, "step", actual.error());
    }
    ++report.steps;
    if (report.first || (progress && !progress(k - from, last - from))) break;
  }
  report.final_hash = sim::state_hash(player->world().bodies());
  return report;
}

}  // namespace

Result<ReplayReport> replay_log(LogReader& log, const ReplayOptions& options, const Progress& progress) {
  if (Status ok = must_be_ours(log); !ok.ok()) return ok.error();
  log.read_ahead(true);
  Result<ReplayReport> report = replay_steps(log, options, progress);
  log.read_ahead(false);
  return report;
}

}  // namespace tumble::replay
