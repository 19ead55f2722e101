#include "tumble/replay/engine_log.h"

#include <algorithm>
#include <utility>

#include "replay/format/limits.h"
#include "replay/format/step_values.h"
#include "replay/import/apply_as_told.h"
#include "replay/import/end_reason.h"
#include "replay/import/engine_header.h"
#include "replay/import/known_bodies.h"
#include "replay/import/phase_names.h"
#include "replay/log/told_bodies.h"
#include "src/base/check.h"
#include "src/base/text.h"
#include "src/world/body_check.h"
#include "src/world/edit_bodies.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

/// Writes a state into a row unchanged: without rounding to a grid, without normalising.
void put_state(sim::Bodies& bodies, sim::BodyIndex i, const EngineState& state) {
  bodies.position.set(i, state.position);
  bodies.orientation.set(i, state.orientation);
  bodies.velocity.set(i, state.velocity);
  bodies.spin.set(i, state.spin);
  bodies.frozen[i] = state.frozen && bodies.is_static[i] == 0 ? 1 : 0;
}

void put_state(sim::Bodies& bodies, const sim::BoxDef& box) {
  put_state(bodies, *bodies.find(box.id), {box.position, box.orientation, box.velocity, box.spin, box.frozen});
}

Result<sim::World> world_of(const sim::SceneDef& start, const EngineDef& def) {
  if (Status ok = sim::check_def(start.world); !ok.ok()) return ok.error();
  if (start.boxes.size() > sim::kBodiesMax) {
    return bad_input("found more than " + std::to_string(sim::kBodiesMax) + " bodies");
  }
  sim::WorldState state;
  state.def = start.world;
  sim::BodyId before = 0;
  for (const sim::BoxDef& box : start.boxes) {
    if (Status ok = sim::check_box(box); !ok.ok()) return ok.error();
    if (Status ok = check_rotation(box.id, box.orientation, EngineState::kLengthOffMax); !ok.ok()) return ok.error();
    if (box.id <= before) return bad_input("body " + std::to_string(box.id) + ": ids must ascend and be unique");
    before = box.id;
    sim::insert_body(state, box);
  }
  Result<sim::World> world = sim::World::restore(std::move(state));
  if (!world.ok()) return world;
  sim::Bodies& bodies = world->mutable_state().bodies;
  for (const sim::BoxDef& box : start.boxes) put_state(bodies, box);
  for (const auto& [id, told] : def.start_states) {
    const auto row = bodies.find(id);
    if (!row) return bad_input("found a state of body " + std::to_string(id) + ", wanted a body of the start");
    if (Status ok = check_rotation(id, told.orientation, EngineState::kLengthOffMax); !ok.ok()) return ok.error();
    put_state(bodies, *row, told);
  }
  return world;
}

Status check_engine_def(const EngineDef& def) {
  if (Status ok = check_engine(def.engine); !ok.ok()) return ok;
  if (Status ok = check_phase_names(def.phases); !ok.ok()) return bad_input("engine: " + ok.error().message);
  const Status table = def.table ? check_table(*def.table) : Status();
  return table.ok() ? check_declared(def.declared) : table;
}

LogHeader header_of(const EngineDef& def, const sim::SceneDef& start) {
  LogHeader header = header_for(start);
  header.engine = def.engine;
  header.table = def.table;
  header.declared = def.declared;
  header.method = "engine";
  header.method_version = 0;  // no build has this version, so none takes the steps for its own
  header.phases = def.phases;
  header.phase_hash_version = 1;  // the phases are those of the engine
  return header;
}

constexpr const char* kFinished = "the log is finished, and takes no more calls";

Error bad_step(std::uint64_t step, const std::string& message) {
  return bad_input("step " + std::to_string(step) + ": " + message);
}

}  // namespace

Result<std::unique_ptr<EngineLog>> EngineLog::create(const std::string& path, const EngineDef& def,
                                                     const sim::SceneDef& start) {
  Result<std::unique_ptr<EngineLog>> log = create([&] { return open_file_sink(path); }, def, start);
  if (log.ok()) (*log)->path_ = place_of_log(path);
  return log;
}

Result<std::unique_ptr<EngineLog>> EngineLog::create(std::unique_ptr<ByteSink> sink, const EngineDef& def,
                                                     const sim::SceneDef& start) {
  return create([&]() -> Result<std::unique_ptr<ByteSink>> { return std::move(sink); }, def, start);
}

Result<std::unique_ptr<EngineLog>> EngineLog::create(const MakeSink& make_sink, const EngineDef& def,
                                                     const sim::SceneDef& start) {
  if (Status ok = check_engine_def(def); !ok.ok()) return ok.error();
  Result<sim::World> world = world_of(start, def);
  if (!world.ok()) return world.error();
  const Status told = check_bodies(def.declared.start, def.declared.channels, world->bodies(), {});
  if (!told.ok()) return told.error();
  LogHeader header = header_of(def, start);
  if (def.first_state > 0) begin_at(def.first_state, header, world->mutable_state());
  Result<std::unique_ptr<ByteSink>> sink = make_sink();
  if (!sink.ok()) return sink.error();
  Result<std::unique_ptr<LogWriter>> writer = LogWriter::create(*std::move(sink), header, world->state());
  if (!writer.ok()) return writer.error();
  std::unique_ptr<EngineLog> log(new EngineLog(*std::move(world), def));
  log->writer_ = *std::move(writer);
  return log;
}

EngineLog::~EngineLog() = default;

EngineLog::EngineLog(sim::World world, const EngineDef& def)
    : world_(std::move(world)),
      phase_count_(def.phases.size()),
      values_(std::make_unique<StepValues>(def.declared.channels)),
      known_(std::make_unique<KnownBodies>()) {
  for (const Shape& shape : def.declared.shapes) {
    const Hash128 hash = hash_of(shape);
    shapes_.emplace(hash.high, hash.low);
  }
}

Error EngineLog::at_step(const std::string& message) {
  Error error = bad_step(step(), message);
  if (refusal_.empty()) refusal_ = "a call was refused: " + error.message;
  return error;
}

Status EngineLog::input(const sim::Command& command) {
  if (!told_.empty()) return at_step("found an input after a state, wanted the inputs of a step before its states");
  if (Status ok = known_->see(command, world_.bodies()); !ok.ok()) return at_step(ok.error().message);
  sim::Command awake = command;  // the other engine decides what rests; no contacts are searched
  if (auto* thrown = std::get_if<sim::Throw>(&awake)) {
    Status turned = check_rotation(thrown->box.id, thrown->box.orientation, EngineState::kLengthOffMax);
    if (!turned.ok()) return at_step(turned.error().message);
    thrown->box.frozen = false;
  }
  if (Status ok = apply_as_told(world_, awake); !ok.ok()) return at_step(ok.error().message);
  if (const auto* thrown = std::get_if<sim::Throw>(&command)) put_state(world_.mutable_state().bodies, thrown->box);
  inputs_.push_back(command);
  return {};
}

Status EngineLog::set_state(sim::BodyId id, const EngineState& state) {
  const auto row = world_.bodies().find(id);
  if (!row) return at_step("found a state of body " + std::to_string(id) + ", wanted the id of a body that exists");
  if (Status ok = check_rotation(id, state.orientation, EngineState::kLengthOffMax); !ok.ok())
    return at_step(ok.error().message);
  if (told_.empty()) told_.assign(world_.bodies().size(), 0);
  SIM_CHECK(told_.size() == world_.bodies().size(), told_.size(), world_.bodies().size());
  if (told_[*row] != 0) return at_step("found a second state of body " + std::to_string(id) + ", wanted one in a step");
  told_[*row] = 1;
  put_state(world_.mutable_state().bodies, *row, state);
  return {};
}

Status EngineLog::set_value(std::size_t channel, const ChannelValue& value, const ChannelKey& key) {
  if (Status ok = values_->set(channel, value, key); !ok.ok()) return at_step(ok.error().message);
  return {};
}

Status EngineLog::set_values(StepValues& values) {
  if (values.channels() != values_->channels()) return at_step("found values of other channels than the log's");
  std::swap(*values_, values);
  return {};
}

Status EngineLog::add_contact(const EngineContact& contact) {
  if (contact.a == 0 || contact.a > sim::kBodyIdMax || contact.b > sim::kBodyIdMax) {
    return at_step("found a contact of bodies " + std::to_string(contact.a) + " and " + std::to_string(contact.b) +
                   ", wanted a body first, and a body or 0 (the ground) second");
  }
  if (extras_.contacts.size() >= kContactsPerStepMax) {
    return at_step("found more than " + std::to_string(kContactsPerStepMax) + " contacts");
  }
  extras_.contacts.push_back(contact);
  return {};
}

Status EngineLog::add_note(std::string_view text) {
  if (text.size() > kNoteBytesMax) return at_step("found a note of " + bytes_text(text.size()));
  extras_.notes.emplace_back(text);
  return {};
}

Status EngineLog::add_snapshot(std::span<const std::byte> bytes, std::string_view name) {
  EngineSnapshot snapshot{std::string(name), {reinterpret_cast<const char*>(bytes.data()), bytes.size()}};
  if (Status ok = check_snapshot(snapshot); !ok.ok()) return at_step(ok.error().message);
  extras_.snapshots.push_back(std::move(snapshot));
  return {};
}

Status EngineLog::add_superseded(const Superseded& before) {
  if (before.difference.size() > kNoteBytesMax) return at_step("found a text too long");
  extras_.superseded.push_back(before);
  return {};
}

Status EngineLog::describe_body(const BodyInfo& info, const Shape* shape) {
  if (Status ok = check_body_info(info); !ok.ok()) return at_step(ok.error().message);
  if (shape != nullptr) {
    if (Status ok = check_shape(*shape); !ok.ok()) return at_step(ok.error().message);
    const Hash128 hash = hash_of(*shape);
    if (shapes_.emplace(hash.high, hash.low).second) extras_.shapes.push_back(*shape);
  }
  if (info.shape != Hash128() && !shapes_.contains({info.shape.high, info.shape.low})) {
    return at_step("body " + std::to_string(info.id) + ": found the hash of no shape that was given");
  }
  if (Status ok = known_->describe(info); !ok.ok()) return at_step(ok.error().message);
  extras_.bodies.push_back(info);
  return {};
}

/// Orders the values and contacts of the step as a log has them.
void EngineLog::close_extras() {
  values_->move_to(extras_);
  std::ranges::stable_sort(extras_.contacts, {}, [](const EngineContact& c) { return std::pair(c.a, c.b); });
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

Status EngineLog::check_all_told() {
  const sim::Bodies& bodies = world_.bodies();
  for (sim::BodyIndex i = 0; i < bodies.size(); ++i) {
    if (!bodies.moves(i) || (!told_.empty() && told_[i] != 0)) continue;
    return at_step("found no state of body " + std::to_string(bodies.id[i]) +
                   ", wanted one of every body that is neither static nor frozen");
  }
  return {};
}

Status EngineLog::end_step(double dt_s) {
  if (!writer_) return bad_input(kFinished);
  if (!(dt_s >= sim::kDtMin && dt_s <= sim::kDtMax)) {
    return at_step("found a dt of " + exact(dt_s) + " s, wanted " + exact(sim::kDtMin) + " … " + exact(sim::kDtMax) +
                   " s");
  }
  if (Status ok = check_all_told(); !ok.ok()) return ok;
  if (phase_count_ > 0 && phase_words_.empty()) return at_step("found no phase hashes, wanted one of each phase");
  close_extras();
  const Status told = check_bodies(extras_, values_->channels(), world_.bodies(), inputs_);
  if (!told.ok()) return at_step(told.error().message);
  sim::WorldState& state = world_.mutable_state();
  state.def.dt = dt_s;
  ++state.step;
  const sim::Energy energy = sim::total_energy(state);
  StepInfo info;
  info.dt = dt_s;
  info.inputs = inputs_, info.phase_words = phase_words_, info.extras = &extras_;
  info.counters.substeps = 1;
  info.counters.kinetic = energy.kinetic, info.counters.potential = energy.potential;
  info.counters.inputs = world_.input_energy();
  world_.forget_input_energy();
  Status written = writer_->append(info, state);
  drop_step();
  return written;
}

void EngineLog::drop_step() {
  close_extras();  // which empties the values
  extras_.clear();
  inputs_.clear();
  phase_words_.clear();
  told_.clear();
}

Result<LogSummary> EngineLog::finish(const std::string& why) {
  if (!writer_) return bad_input(kFinished);
  if (!inputs_.empty() || !told_.empty() || !values_->empty() || !extras_.empty())
    return bad_step(step(), "was begun but not ended, wanted end_step() before finish()");
  Result<LogSummary> summary = std::exchange(writer_, nullptr)->finish();  // and lets go of the file
  if (!summary.ok()) return summary;
  const Status kept = keep_end_reason(path_, refusal_.empty() ? why : refusal_, *summary);
  return kept.ok() ? summary : kept.error();
}

}  // namespace tumble::replay
