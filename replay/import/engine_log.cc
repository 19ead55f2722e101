#include "tumble/replay/engine_log.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "replay/format/limits.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "src/world/body_check.h"
#include "src/world/edit_bodies.h"
#include "tumble/sim/limits.h"
#include "tumble/sim/step.h"

namespace tumble::replay {
namespace {

/// Writes a state into a row unchanged: without rounding to a grid, without normalising.
void put(sim::Bodies& bodies, sim::BodyIndex i, const EngineState& state) {
  bodies.position.set(i, state.position);
  bodies.orientation.set(i, state.orientation);
  bodies.velocity.set(i, state.velocity);
  bodies.spin.set(i, state.spin);
  bodies.frozen[i] = state.frozen && bodies.is_static[i] == 0 ? 1 : 0;
}

void put(sim::Bodies& bodies, const sim::BoxDef& box) {
  put(bodies, *bodies.find(box.id), {box.position, box.orientation, box.velocity, box.spin, box.frozen});
}

/// Errors (kBadInput): a finite orientation that is no rotation, which would be measured and drawn wrongly.
Status check_rotation(sim::BodyId id, const sim::Quat& q) {
  const double length = std::sqrt(sim::squared_length(q));
  if (!(std::fabs(length - 1) > EngineState::kLengthOffMax) || !std::isfinite(length)) return {};
  return bad_input("body " + std::to_string(id) + ": found an orientation of length " + significant(length, 9) +
                   ", wanted 1; divide its numbers by the length");
}

Result<sim::World> world_of(const sim::SceneDef& start) {
  if (Status ok = sim::check_def(start.world); !ok.ok()) return ok.error();
  if (start.boxes.size() > sim::kBodiesMax) {
    return bad_input("found more than " + std::to_string(sim::kBodiesMax) + " bodies");
  }
  sim::WorldState state;
  state.def = start.world;
  sim::BodyId before = 0;
  for (const sim::BoxDef& box : start.boxes) {
    if (Status ok = sim::check_box(box); !ok.ok()) return ok.error();
    if (Status ok = check_rotation(box.id, box.orientation); !ok.ok()) return ok.error();
    if (box.id <= before) return bad_input("body " + std::to_string(box.id) + ": ids must ascend and be unique");
    before = box.id;
    sim::insert_body(state, box);
  }
  Result<sim::World> world = sim::World::restore(std::move(state));
  if (!world.ok()) return world;
  for (const sim::BoxDef& box : start.boxes) put(world->mutable_state().bodies, box);
  return world;
}

Status check_engine(const EngineDef& def) {
  const EngineName& engine = def.engine;
  if (engine.name.empty()) return bad_input("engine: found no name, wanted one");
  if (engine.precision_bits != kBinary32Bits && engine.precision_bits != kBinary64Bits) {
    return bad_input("engine: found a precision of " + std::to_string(engine.precision_bits) +
                     " bits, wanted 24 (binary32) or 53 (binary64)");
  }
  if (def.phases.size() > kPhasesMax) {
    return bad_input("engine: found " + std::to_string(def.phases.size()) + " phases, wanted at most " +
                     std::to_string(kPhasesMax));
  }
  return def.table ? check_table(*def.table) : Status();
}

LogHeader header_of(const EngineDef& def, const sim::SceneDef& start) {
  LogHeader header = header_for(start);
  header.engine = def.engine;
  header.table = def.table;
  header.method = "engine";
  header.method_version = 0;  // no build has this version, so none takes the steps for its own
  header.phases = def.phases;
  header.phase_hash_version = 1;  // the phases are those of the engine
  return header;
}

}  // namespace

Result<std::unique_ptr<EngineLog>> EngineLog::create(const std::string& path, const EngineDef& def,
                                                     const sim::SceneDef& start) {
  if (Status ok = check_engine(def); !ok.ok()) return ok.error();  // before a file is created
  if (const Result<sim::World> world = world_of(start); !world.ok()) return world.error();
  Result<std::unique_ptr<ByteSink>> sink = open_file_sink(path);
  if (!sink.ok()) return sink.error();
  return create(*std::move(sink), def, start);
}

Result<std::unique_ptr<EngineLog>> EngineLog::create(std::unique_ptr<ByteSink> sink, const EngineDef& def,
                                                     const sim::SceneDef& start) {
  if (Status ok = check_engine(def); !ok.ok()) return ok.error();
  Result<sim::World> world = world_of(start);
  if (!world.ok()) return world.error();
  Result<std::unique_ptr<LogWriter>> writer = LogWriter::create(std::move(sink), header_of(def, start), world->state());
  if (!writer.ok()) return writer.error();
  std::unique_ptr<EngineLog> log(new EngineLog(*std::move(world), def.phases.size()));
  log->writer_ = *std::move(writer);
  return log;
}

Error EngineLog::at_step(const std::string& message) const {
  return bad_input("step " + std::to_string(step()) + ": " + message);
}

Status EngineLog::input(const sim::Command& command) {
  if (!told_.empty()) return at_step("found an input after a state, wanted the inputs of a step before its states");
  const auto* thrown = std::get_if<sim::Throw>(&command);
  Status applied;
  if (thrown != nullptr) {
    if (Status ok = check_rotation(thrown->box.id, thrown->box.orientation); !ok.ok()) {
      return at_step(ok.error().message);
    }
    sim::Throw awake = *thrown;  // the other engine decides what rests; no contacts are searched
    awake.box.frozen = false;
    applied = sim::apply(world_, awake);
    if (applied.ok()) put(world_.mutable_state().bodies, thrown->box);
  } else {
    applied = sim::apply(world_, command);
  }
  if (!applied.ok()) return at_step(applied.error().message);
  inputs_.push_back(command);
  return {};
}

Status EngineLog::set_state(sim::BodyId id, const EngineState& state) {
  const auto row = world_.bodies().find(id);
  if (!row) return at_step("found a state of body " + std::to_string(id) + ", wanted the id of a body that exists");
  if (Status ok = check_rotation(id, state.orientation); !ok.ok()) return at_step(ok.error().message);
  if (told_.empty()) told_.assign(world_.bodies().size(), 0);
  SIM_CHECK(told_.size() == world_.bodies().size(), told_.size(), world_.bodies().size());
  told_[*row] = 1;
  put(world_.mutable_state().bodies, *row, state);
  return {};
}

Status EngineLog::set_phase_hashes(std::span<const std::uint64_t> words) {
  if (phase_count_ == 0) return at_step("found phase hashes, but the log was begun without names of phases");
  if (words.empty() || words.size() % phase_count_ != 0) {
    return at_step("found " + std::to_string(words.size()) + " phase hashes, wanted a multiple of the " +
                   std::to_string(phase_count_) + " phases");
  }
  if (words.size() / phase_count_ > sim::PhaseHashes::kRowsMax) {
    return at_step("found phase hashes of " + std::to_string(words.size() / phase_count_) +
                   " sub-steps, wanted at most " + std::to_string(sim::PhaseHashes::kRowsMax));
  }
  phase_words_.assign(words.begin(), words.end());
  return {};
}

Status EngineLog::check_all_told() const {
  const sim::Bodies& bodies = world_.bodies();
  for (sim::BodyIndex i = 0; i < bodies.size(); ++i) {
    if (!bodies.moves(i) || (!told_.empty() && told_[i] != 0)) continue;
    return at_step("found no state of body " + std::to_string(bodies.id[i]) +
                   ", wanted one of every body that is neither static nor frozen");
  }
  return {};
}

Status EngineLog::end_step(double dt_s) {
  if (!(dt_s >= sim::kDtMin && dt_s <= sim::kDtMax)) {
    return at_step("found a dt of " + std::to_string(dt_s) + " s, wanted " + std::to_string(sim::kDtMin) + " … " +
                   std::to_string(sim::kDtMax) + " s");
  }
  if (Status ok = check_all_told(); !ok.ok()) return ok;
  if (phase_count_ > 0 && phase_words_.empty()) return at_step("found no phase hashes, wanted one of each phase");
  sim::WorldState& state = world_.mutable_state();
  state.def.dt = dt_s;
  ++state.step;
  const sim::Energy energy = sim::total_energy(state);
  StepInfo info;
  info.dt = dt_s;
  info.inputs = inputs_;
  info.phase_words = phase_words_;
  info.counters.substeps = 1;
  info.counters.kinetic = energy.kinetic;
  info.counters.potential = energy.potential;
  info.counters.inputs = world_.input_energy();
  world_.forget_input_energy();
  Status written = writer_->append(info, state);
  inputs_.clear();
  phase_words_.clear();
  told_.clear();
  return written;
}

Result<LogSummary> EngineLog::finish() {
  if (!inputs_.empty() || !told_.empty()) return at_step("was begun but not ended, wanted end_step() before finish()");
  return writer_->finish();
}

}  // namespace tumble::replay
