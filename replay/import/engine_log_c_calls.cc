#include <algorithm>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <utility>

#include "replay/import/engine_log_c_impl.h"
#include "tumble/replay/engine_log_c.h"

using tumble::Result;
using tumble::Status;
using tumble::replay::EngineLog;
using tumble::replay::EngineState;
using tumble::replay::guarded;
using tumble::replay::missing;
using tumble::replay::vector_of;
using tumble::replay::while_open;

namespace {

EngineState state_of(const TumbleLogState& state) {
  const double* q = state.orientation;
  return {vector_of(state.position),
          {q[0], q[1], q[2], q[3]},
          vector_of(state.velocity),
          vector_of(state.spin),
          state.frozen != 0};
}

tumble::sim::BoxDef box_of(const TumbleLogBody& body) {
  const EngineState state = state_of(body.state);
  tumble::sim::BoxDef box;
  box.id = body.id;
  box.size = vector_of(body.size);
  box.mass = body.mass;
  box.is_static = body.is_static != 0;
  box.position = state.position;
  box.orientation = state.orientation;
  box.velocity = state.velocity;
  box.spin = state.spin;
  box.frozen = state.frozen;
  box.material.friction = box.material.friction_dynamic = body.friction;
  box.material.restitution = body.restitution;
  if (body.in_grid != 0) box.origin = {tumble::sim::Origin::Kind::kGrid, 0, body.row, body.column};
  return box;
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

Status begin(TumbleLog& log, const char* path, const TumbleLogStart* start) {
  if (log.log) return tumble::bad_input("found tumble_log_begin() twice");
  if (path == nullptr || start == nullptr) return missing("a path and a start");
  log.def.engine.precision_bits = static_cast<std::uint32_t>(start->precision_bits);
  if (start->phases != nullptr) log.def.phases = words_of(start->phases);
  tumble::sim::SceneDef& scene = log.start;
  scene.name = start->scene != nullptr ? start->scene : "session";
  scene.world.dt = start->dt;
  scene.world.gravity = vector_of(start->gravity);
  scene.world.ground = start->ground != 0;
  scene.steps = start->planned_steps;
  std::ranges::sort(scene.boxes, {}, &tumble::sim::BoxDef::id);
  if (Status ok = tumble::replay::declare_channels(log); !ok.ok()) return ok;
  Result<std::unique_ptr<EngineLog>> made = EngineLog::create(path, log.def, scene);
  if (!made.ok()) return made.error();
  log.log = *std::move(made);
  return {};
}

}  // namespace

TumbleLog* tumble_log_new(const char* engine, const char* version) {
  try {
    auto log = std::make_unique<TumbleLog>();
    if (engine != nullptr) log->def.engine.name = engine;
    if (version != nullptr) log->def.engine.version = version;
    return log.release();
  } catch (const std::exception&) {
    return nullptr;
  }
}

const char* tumble_log_message(const TumbleLog* log) {
  if (log == nullptr) return "found NULL, wanted a log of tumble_log_new()";
  return log->status.ok() ? "" : log->status.error().message.c_str();
}

TumbleLogStatus tumble_log_add_body(TumbleLog* log, const TumbleLogBody* body) {
  return guarded(log, [&]() -> Status {
    if (log->log)
      return tumble::bad_input("found a body of the start after tumble_log_begin(), wanted tumble_log_throw()");
    if (body == nullptr) return missing("a body");
    log->start.boxes.push_back(box_of(*body));
    return {};
  });
}

TumbleLogStatus tumble_log_begin(TumbleLog* log, const char* path, const TumbleLogStart* start) {
  return guarded(log, [&] { return begin(*log, path, start); });
}

TumbleLogStatus tumble_log_throw(TumbleLog* log, const TumbleLogBody* body) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (body == nullptr) return missing("a body");
    return open.input(tumble::sim::Throw{box_of(*body)});
  });
}

TumbleLogStatus tumble_log_remove(TumbleLog* log, uint64_t id) {
  return while_open(log, [&](EngineLog& open) { return open.input(tumble::sim::Remove{id}); });
}

TumbleLogStatus tumble_log_push(TumbleLog* log, uint64_t id, const double impulse[3]) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (impulse == nullptr) return missing("an impulse");
    tumble::sim::Push push;
    push.id = id;
    push.impulse = vector_of(impulse);
    return open.input(push);
  });
}

TumbleLogStatus tumble_log_set_velocity(TumbleLog* log, uint64_t id, const double velocity[3], const double spin[3]) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (velocity == nullptr || spin == nullptr) return missing("a velocity and a spin");
    return open.input(tumble::sim::SetVelocity{id, vector_of(velocity), vector_of(spin)});
  });
}

TumbleLogStatus tumble_log_set_gravity(TumbleLog* log, const double gravity[3]) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (gravity == nullptr) return missing("a gravity");
    return open.input(tumble::sim::SetGravity{vector_of(gravity)});
  });
}

TumbleLogStatus tumble_log_set_state(TumbleLog* log, uint64_t id, const TumbleLogState* state) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (state == nullptr) return missing("a state");
    return open.set_state(id, state_of(*state));
  });
}

TumbleLogStatus tumble_log_set_phase_hashes(TumbleLog* log, const uint64_t* words, size_t count) {
  return while_open(log, [&](EngineLog& open) -> Status {
    if (words == nullptr) return missing("phase hashes");
    return open.set_phase_hashes({words, count});
  });
}

TumbleLogStatus tumble_log_end_step(TumbleLog* log, double dt) {
  return while_open(log, [&](EngineLog& open) { return open.end_step(dt); });
}

TumbleLogStatus tumble_log_finish(TumbleLog* log) {
  return while_open(log, [&](EngineLog& open) -> Status {
    const Result<tumble::replay::LogSummary> summary = open.finish();
    if (!summary.ok()) return summary.error();
    return {};
  });
}

void tumble_log_free(TumbleLog* log) { delete log; }
