#include "golden/canaries/log_canaries.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "golden/canaries/lying_log.h"
#include "replay/codec/chunk_codec.h"
#include "replay/codec/state_keys.h"
#include "replay/log/byte_memory.h"
#include "replay/log/verify.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/player.h"
#include "tumble/replay/recorder.h"
#include "tumble/replay/replayer.h"
#include "tumble/replay/session.h"
#include "tumble/sim/step.h"

namespace tumble::golden {
namespace {

using replay::LogReader;
using replay::MemoryFile;

constexpr std::uint64_t kLogSteps = 13;  // two full chunks, and one of a single step
constexpr std::uint64_t kChunk = 6;

/// Stacked boxes, one of them frozen. Inputs push them, throw another one at them and take one away.
sim::SceneDef session_scene(sim::Method method) {
  sim::SceneDef scene;
  scene.name = "canary";
  scene.world.method = method;
  scene.steps = kLogSteps;
  for (std::uint64_t i = 0; i < 4; ++i) {
    sim::BoxDef box;
    box.id = 10 + i;
    box.position = {0.125 * static_cast<double>(i), 0, 0.5 + 0.99 * static_cast<double>(i)};
    box.size = {1, 1.25, 1};
    box.material.friction_dynamic = 0.25;
    box.frozen = i == 0;
    scene.boxes.push_back(box);
  }
  sim::BoxDef thrown = scene.boxes.back();
  thrown.id = 5;
  thrown.position = {-3, 0, 1};
  thrown.velocity = {20, 0, 1};
  scene.inputs = {{2, sim::Throw{thrown}},
                  {3, sim::Push{11, {1, 0, 2}, false, {0.5, 0.25, 1.5}}},
                  {4, sim::SetDt{1.0 / 100}},
                  {8, sim::Remove{13}},
                  {9, sim::SetGravity{{0.5, 0, -8}}},
                  {kLogSteps, sim::SetVelocity{12, {0, 1, 3}, {1, 2, 3}}}};
  return scene;
}

Result<MemoryFile> record(const sim::SceneDef& scene, std::uint64_t lie_step = 0, const Lie& lie = {}) {
  return record_lying(scene, kChunk, lie_step, lie);
}

Result<LogReader> open(const MemoryFile& file) {
  return LogReader::open(std::make_unique<replay::MemoryByteSource>(file, "the canary's log"));
}

/// The first difference that replay finds; an error if it cannot read on.
Result<std::optional<replay::Divergence>> replayed(const Result<MemoryFile>& file) {
  if (!file.ok()) return file.error();
  Result<LogReader> log = open(*file);
  if (!log.ok()) return log.error();
  Result<replay::ReplayReport> report = replay::replay_log(*log);
  if (!report.ok()) return report.error();
  return report->first;
}

Result<std::optional<replay::Divergence>> differing(const Result<MemoryFile>& file, const Result<MemoryFile>& other,
                                                    const replay::Tolerances& tolerances = {}) {
  if (!file.ok()) return file.error();
  if (!other.ok()) return other.error();
  Result<LogReader> a = open(*file), b = open(*other);
  if (!a.ok()) return a.error();
  if (!b.ok()) return b.error();
  Result<replay::DiffReport> report = replay::diff_logs(*a, *b, tolerances);
  if (!report.ok()) return report.error();
  return report->first;
}

bool is_same(const Result<std::optional<replay::Divergence>>& found) { return found.ok() && !found->has_value(); }
bool is_at(const Result<std::optional<replay::Divergence>>& found, std::uint64_t step, const std::string& field) {
  return found.ok() && found->has_value() && (*found)->step == step && (*found)->field == field;
}

bool nothing_is_found(sim::Method method) {
  const Result<MemoryFile> file = record(session_scene(method));
  if (!is_same(replayed(file)) || !is_same(differing(file, file))) return false;
  Result<LogReader> log = open(*file);
  if (!log.ok() || log->step_count() != kLogSteps || !log->condition().whole()) return false;
  const replay::VerifyReport report = replay::verify(*log);
  return report.condition.whole() && report.states_checked == kLogSteps;
}

/// Every field of a body, in the last step, by one unit in the last place.
bool fields_are_named(sim::Method method) {
  const Result<MemoryFile> truth = record(session_scene(method));
  for (std::size_t c = 0; c < replay::kColumnCount; ++c) {
    const Result<MemoryFile> lying = record(session_scene(method), kLogSteps, [c](sim::WorldState& state, auto&) {
      replay::BodyStates states;
      replay::copy_visible(state.bodies, states);
      double& value = (*replay::columns_of(states)[c])[1];
      value = std::nextafter(value, std::numeric_limits<double>::infinity());
      state.bodies.position = states.position;
      state.bodies.orientation = states.orientation;
      state.bodies.velocity = states.velocity;
      state.bodies.spin = states.spin;
    });
    if (!is_at(replayed(lying), kLogSteps, replay::kColumnNames[c])) return false;
    if (!is_at(differing(truth, lying), kLogSteps, replay::kColumnNames[c])) return false;
  }
  return true;
}

bool counters_are_compared(sim::Method method) {
  const std::pair<const char*, double sim::StepCounters::*> counters[] = {
      {"kinetic", &sim::StepCounters::kinetic},
      {"potential", &sim::StepCounters::potential},
      {"input_energy", &sim::StepCounters::inputs},
      {"removed_energy", &sim::StepCounters::removed}};
  return std::ranges::all_of(counters, [&](const auto& counter) {
    const Lie lie = [&](sim::WorldState&, sim::StepCounters& of) { of.*counter.second += 1; };
    return is_at(replayed(record(session_scene(method), kLogSteps, lie)), kLogSteps, counter.first);
  });
}

bool hidden_state_is_compared(sim::Method method) {
  const Lie lie = [](sim::WorldState& state, auto&) { state.bodies.low_energy_time[1] += 1; };
  return is_at(replayed(record(session_scene(method), kChunk, lie)), kChunk, "low_energy_time");
}

bool start_is_compared(sim::Method method) {
  sim::SceneDef other = session_scene(method);
  other.steps = 0;
  other.inputs.clear();
  sim::SceneDef moved = other;
  moved.boxes[1].position.x() += std::ldexp(1, -20);
  return is_at(differing(record(other), record(moved)), 0, "position.x");
}

bool tolerances_hold(sim::Method method) {
  const Result<MemoryFile> truth = record(session_scene(method));
  const auto moved_by = [&](double distance) {
    return record(session_scene(method), kLogSteps,
                  [=](sim::WorldState& state, auto&) { state.bodies.position.x[1] += distance; });
  };
  replay::Tolerances tolerances;
  tolerances.position = 1e-6;
  return is_same(differing(truth, moved_by(0.5e-6), tolerances)) &&
         is_at(differing(truth, moved_by(1.5e-6), tolerances), kLogSteps, "position.x");
}

/// A log cut at the end of a record: only the missing footer shows it.
bool torn_end_is_seen(sim::Method method) {
  const Result<MemoryFile> file = record(session_scene(method));
  if (!file.ok()) return false;
  Result<LogReader> log = open(*file);
  if (!log.ok() || log->chunks().empty()) return false;
  (*file)->resize(log->chunks().back().offset + log->chunks().back().length);
  Result<LogReader> torn = open(*file);
  return torn.ok() && torn->condition().torn && torn->step_count() == kLogSteps;
}

/// The second chunk from a session that was the same up to its first step.
bool strange_chunk_is_seen(sim::Method method) {
  const Result<MemoryFile> file = record(session_scene(method));
  const Lie lie = [](sim::WorldState& state, auto&) { state.bodies.velocity.x[1] += 1; };
  const Result<MemoryFile> other = record(session_scene(method), 1, lie);
  if (!file.ok() || !other.ok()) return false;
  Result<LogReader> a = open(*file), b = open(*other);
  if (!a.ok() || !b.ok() || a->chunks().size() < 2 || b->chunks().size() < 2) return false;
  const replay::ChunkPlace first = a->chunks()[0], second = b->chunks()[1];
  auto spliced = std::make_shared<std::vector<std::byte>>(
      (*file)->begin(), (*file)->begin() + static_cast<std::ptrdiff_t>(first.offset + first.length));
  const auto from = (*other)->begin() + static_cast<std::ptrdiff_t>(second.offset);
  spliced->insert(spliced->end(), from, from + static_cast<std::ptrdiff_t>(second.length));
  Result<LogReader> log = open(spliced);
  return log.ok() && !log->condition().damages.empty();
}

/// Continued from every step in turn, the session must end in the state of the one that never stopped.
bool goes_on(sim::Method method) {
  const Result<MemoryFile> file = record(session_scene(method));
  if (!file.ok()) return false;
  Result<LogReader> log = open(*file);
  if (!log.ok()) return false;
  Result<replay::Player> player = replay::Player::at(*log, kLogSteps);
  if (!player.ok()) return false;
  const Hash128 wanted = sim::continuation_hash(player->world().state());
  for (std::uint64_t k = 0; k < kLogSteps; ++k) {
    auto sink = std::make_unique<replay::MemoryByteSink>(std::make_shared<std::vector<std::byte>>(), "gone on");
    auto recorder = replay::Recorder::go_on(std::move(sink), *log, k, {});
    if (!recorder.ok()) return false;
    for (std::uint64_t step = k; step < kLogSteps; ++step) {
      if (!(*recorder)->step().ok()) return false;
    }
    if (sim::continuation_hash((*recorder)->world().state()) != wanted) return false;
  }
  return true;
}

/// A chunk of made-up numbers: no change of the physics changes it.
Result<replay::MessageBytes> made_up_chunk() {
  sim::SceneDef scene = session_scene(sim::Method::kLayered);
  for (sim::BoxDef& box : scene.boxes) box.position[2] += 8;
  const Result<sim::World> world = sim::create_world(scene);
  if (!world.ok()) return world.error();
  replay::Keyframe keyframe = {world->state(), {1, 2}};
  keyframe.state.pairs = {{0, 1}, {1, 3}, {5, 6}};
  keyframe.state.contact_objects = {{2, 2}, {0, 1}};
  sim::ContactMemory& memory = keyframe.state.contact_memory;
  memory.a = {0}, memory.b = {1}, memory.count = {1}, memory.twist = {0.75}, memory.feature = {3}, memory.impulse = {7};
  memory.friction = {{0.5}, {1.5}, {2.5}};
  std::vector<replay::StepRecord> steps(3);
  replay::BodyStates states;
  replay::copy_visible(keyframe.state.bodies, states);
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double now = static_cast<double>(k + 1);
    states.position.z[1] -= 0.125 * now;  // falls
    states.position.x[2] += 0.25;         // was hit
    states.velocity.x[2] = 8 - now;
    states.spin.y[2] = now;
    states.frozen[3] ^= 1;
    steps[k] = {k + 1, 1.0 / 64, {}, {11, 12 + k}, {3, k}, {1, 2, 3, 4 + now, 5 + now, 6 + now, 7 + now},
                true,  states,   {}};
  }
  return replay::ChunkEncoder().encode(keyframe, steps);
}

/// Other builds read these bytes, so they must stay as they always were. After an extension of the schema, or a codec
/// with a number of its own, the hash of the new bytes belongs here.
CanaryResult written_as_ever() {
  constexpr const char* kWritten = "68c56c3a7e28d98f4acbebb125f229ce";
  const Result<replay::MessageBytes> chunk = made_up_chunk();
  const std::string found = chunk.ok() ? to_string(hash_bytes(chunk->bytes())) : chunk.error().message;
  const bool same = found == kWritten;
  return {"", same, same ? "seen" : "its bytes have the hash " + found + ", wanted " + kWritten, "format"};
}

// What must hold in a session of each method.
auto by_method(bool (*holds)(sim::Method method)) {
  return [holds]() -> CanaryResult {
    for (const sim::Method method : {sim::Method::kThesis, sim::Method::kLayered}) {
      if (holds(method)) continue;
      return {"", false, std::string("not so in a session of method ") + name_of(method), "format"};
    }
    return {"", true, "seen", "format"};
  };
}

}  // namespace

void run_log_canaries(CanaryRoll& roll) {
  roll.ask("a log is written in another way than ever", written_as_ever);
  roll.ask("nothing is wrong with a log, which must be seen", by_method(nothing_is_found));
  roll.ask("a field of the last state in a log differs", by_method(fields_are_named));
  roll.ask("a counter of the last step in a log differs", by_method(counters_are_compared));
  roll.ask("the hidden state where a chunk ends differs", by_method(hidden_state_is_compared));
  roll.ask("state 0 of two logs differs", by_method(start_is_compared));
  roll.ask("two logs differ by more than a tolerance", by_method(tolerances_hold));
  roll.ask("a log ends between two records", by_method(torn_end_is_seen));
  roll.ask("a chunk comes from another session", by_method(strange_chunk_is_seen));
  roll.ask("a session goes on from any step, and must end alike", by_method(goes_on));
}

}  // namespace tumble::golden
