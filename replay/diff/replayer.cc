#include "tumble/replay/replayer.h"

#include <algorithm>
#include <utility>

#include "replay/diff/world_difference.h"
#include "src/base/text.h"
#include "tumble/replay/player.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

Divergence failed_at(std::uint64_t step, const char* phase, const Error& error) {
  Divergence divergence;
  divergence.step = step;
  divergence.phase = phase;
  divergence.field = "error";
  divergence.expected = std::string("none");
  divergence.actual = error.message;
  return divergence;
}

bool is_our_version(const LogReader& log) {
  return log.header().method_version == sim::method_version(log.header().scene.world.method);
}

/// The parts of the first keyframe that the scene of a log tells. A continued scene holds places and velocities as
/// numbers to read, from which a world is made anew: their last bits and the hidden state are the keyframe's alone.
WorldParts parts_of_scene(const LogReader& log) {
  const bool continued = log.header().goes_on.has_value();
  return {.visible = !continued, .hidden = !continued && is_our_version(log)};
}

/// Compares the world that this build makes of the log's scene with the log's first keyframe.
Result<std::optional<Divergence>> compare_start(LogReader& log) {
  const std::uint64_t first = log.first_state();
  Result<const Keyframe*> keyframe = log.keyframe_at_or_before(first);
  if (!keyframe.ok()) return keyframe.error();
  Result<sim::World> world = sim::create_world(log.header().scene);
  if (!world.ok()) return std::optional(failed_at(first, "start", world.error()));
  return world_difference((*keyframe)->state, world->state(), parts_of_scene(log));
}

/// Reasons why a difference may be expected, or why less than everything was compared.
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
  if (std::string note = not_whole(log); !note.empty()) notes.push_back(std::move(note));
  return notes;
}

/// The difference in a step, if there is one. Compares hashes first and decodes states only where they differ, which
/// saves most of the decoding. ours_now: the header of a log that this build would record.
Result<std::optional<Divergence>> compare_step(LogReader& log, const StepRecord& actual, Player& player,
                                               const LogHeader& ours_now) {
  static const std::vector<std::string> kNone;
  const std::vector<std::string>& phases = same_phase_words(log.header(), ours_now) ? log.header().phases : kNone;
  Result<const StepRecord*> read = log.read_hashes(actual.step);
  if (!read.ok()) return read.error();
  StepRecord expected = **read;
  leave_out_phase_words(log.header(), ours_now, actual, expected);
  std::optional<Divergence> found = first_difference(expected, actual, phases);
  if (!found || !(*read)->has_states) return found;
  read = log.read_step(actual.step);
  if (!read.ok()) return read.error();
  expected = **read;
  leave_out_phase_words(log.header(), ours_now, actual, expected);
  return first_difference(expected, player.add_states(), phases);
}

/// After the last step of a chunk, compares the world with the next keyframe. Hidden state (solver memory, rest times)
/// shows in no visible column until steps later; this finds a difference within a chunk.
Result<std::optional<Divergence>> compare_keyframe(LogReader& log, const sim::WorldState& state) {
  const auto& chunks = log.chunks();
  const auto next = std::partition_point(chunks.begin(), chunks.end(),
                                         [&](const ChunkPlace& place) { return place.first_step <= state.step; });
  if (next == chunks.end() || next->first_step != state.step + 1) return std::optional<Divergence>();
  Result<const Keyframe*> keyframe = log.keyframe_at_or_before(state.step);
  if (!keyframe.ok()) return keyframe.error();
  const bool our_version = is_our_version(log);
  std::optional<Divergence> found =
      keyframe_difference((*keyframe)->state, (*keyframe)->continuation_hash, state,
                          our_version ? sim::continuation_hash(state) : Hash128(), {.hidden = our_version});
  if (found) found->phase = "step";
  return found;
}

/// The parts that a replay without a difference speaks of.
ComparisonScope scope_of_replay(const LogReader& log, const LogHeader& ours_now, bool start, std::uint64_t from) {
  const LogHeader& header = log.header();
  ComparisonScope scope;
  scope.compared = {"step lengths", "inputs", "counters", "state hashes"};
  const auto leave_out = [&](std::string part) { scope.not_compared.push_back(std::move(part)); };
  if (same_phase_words(header, ours_now)) {
    add_phase_hashes(log, log, {from, log.last_step()}, scope);
  } else {
    leave_out("phase hashes and contact counts: their names or versions differ");
  }
  const bool our_version = is_our_version(log);
  std::uint64_t keyframes = 0;
  for (const ChunkPlace& place : log.chunks()) {  // the replay starts again from a keyframe behind missing steps
    if (place.first_step > from + 1 && log.lost_at(place.first_step - 1) == nullptr) ++keyframes;
  }
  if (start) {
    scope.compared.emplace_back("the world made of the scene (parameters, sizes, masses, inertias, materials" +
                                std::string(header.goes_on ? ")" : ", states)"));
  } else if (header.recovered && header.recovered->header_lost) {
    leave_out("the world made of the scene: the header was lost, and its scene is made of the first keyframe");
  } else {
    leave_out("the world made of the scene: the replay begins with a later step");
  }
  if (start && header.goes_on) {
    leave_out("the first state, visible and hidden: a continued log has it in its keyframe alone");
  }
  if (keyframes > 0) scope.compared.push_back("complete states of " + count_text(keyframes, "later keyframe"));
  if (!our_version) leave_out("hidden states of keyframes: another version of the method keeps others");
  leave_out("stored states: their bytes are as written, and 'tumble info' compares them with their hashes");
  for (const MissingSteps& run : header.missing()) leave_out(to_string(run) + ": lost before the log was recovered");
  if (std::string part = not_intact(log); !part.empty()) leave_out(std::move(part));
  leave_out(never_compared());
  return scope;
}

/// replay_log() for a log of ours. Steps that a recovered log lacks are jumped over: the replay starts again from the
/// keyframe behind them, since the inputs in between are lost.
Result<ReplayReport> replay_steps(LogReader& log, const ReplayOptions& options, const Progress& progress) {
  const LogHeader& header = log.header();
  const std::uint64_t first = log.first_state();
  const std::uint64_t from = std::max(options.from_step, first);
  const std::uint64_t last = log.last_step();
  const LogHeader ours_now = header_for(header.scene);
  ReplayReport report;
  report.notes = notes_of(log, ours_now);
  const bool has_scene = !header.recovered || !header.recovered->header_lost;  // and not one made of state 0
  const bool compare_scene = from == first && has_scene;
  report.scope = scope_of_replay(log, ours_now, compare_scene, from);
  if (compare_scene) {
    Result<std::optional<Divergence>> start = compare_start(log);
    if (!start.ok()) return start.error();
    report.first = *std::move(start);
    if (report.first) return report;
  }
  Result<Player> player = Player::at(log, from);
  if (!player.ok()) return player.error();
  player->use(options.workers);
  for (std::uint64_t k = from + 1; k <= last; ++k) {
    if (const MissingSteps* missing = log.lost_at(k); missing != nullptr) {
      k = missing->end_step();
      if (player = Player::at(log, k - 1); !player.ok()) return player.error();
      player->use(options.workers);
    }
    const auto unreadable = [&](const Error& error) {
      return Error{error.kind, error.message + "; the steps before step " + std::to_string(k) + " replayed the same"};
    };
    if (Result<const StepRecord*> logged = log.read_hashes(k); !logged.ok()) return unreadable(logged.error());
    Result<const StepRecord*> actual = player->step_hashes();
    if (actual.ok()) {
      Result<std::optional<Divergence>> found = compare_step(log, **actual, *player, ours_now);
      if (found.ok() && !*found) found = compare_keyframe(log, player->world().state());
      if (!found.ok()) return unreadable(found.error());
      report.first = *std::move(found);
    } else {
      report.first = failed_at(k, "step", actual.error());
    }
    ++report.steps;
    if (report.first) break;
    if (progress && !progress(k - from, last - from)) {
      return cannot_finish("interrupted; identical so far: " + count_text(report.steps, "step"));
    }
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
