#include "replay/live/live_stepper.h"

#include <string>
#include <utility>
#include <variant>

#include "replay/picture/picture_markers.h"
#include "src/base/check.h"
#include "src/world/float_environment.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {

LiveStepper::LiveStepper(LiveOptions options)
    : options_(std::move(options)),
      logs_(options_.begin, options_.states),
      pacer_(options_.dt, options_.pace, 0),
      pace_(options_.pace) {}

// The thread that writes a log starts with the environment of the thread that opens it, and codes states by arithmetic.
Status LiveStepper::open() {
  if (Status ok = check_arithmetic(); !ok.ok()) return ok;
  return logs_.open(options_.log);
}

void LiveStepper::begin() {
  workers_ = worker_threads(options_.threads);
  adopt_recorder();
  restart_clock();
}

std::chrono::steady_clock::time_point LiveStepper::due() const {
  return began_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(pacer_.due()));
}

void LiveStepper::set(const Pace& pace) {
  pace_ = pace;
  restart_clock();
  // A pause may last; what was played until then must survive a crash.
  if (!pace_.paused || logs_.recorder() == nullptr) return;
  if (Status ok = logs_.recorder()->flush(); !ok.ok()) end(ok.error());
}

void LiveStepper::back(double seconds) {
  const Status ok = check_arithmetic();
  change_log(ok.ok() ? logs_.back(seconds) : ok);
}

void LiveStepper::again() {
  const Status ok = check_arithmetic();
  change_log(ok.ok() ? logs_.again() : ok);
}

void LiveStepper::change_log(const Status& changed) {
  if (!changed.ok()) return end(changed.error());
  frame_.ended.clear();
  adopt_recorder();
  frame_.notice = "playing on in " + logs_.path();
  restart_clock();
}

void LiveStepper::end(const Error& error) {
  frame_.ended = error.message;
  if (Status ok = logs_.finish(); !ok.ok() && failed_.ok()) failed_ = ok;
}

Status LiveStepper::finish() {
  if (Status ok = logs_.finish(); !ok.ok() && failed_.ok()) failed_ = ok;
  return failed_;
}

void LiveStepper::adopt_recorder() {
  Recorder& recorder = *logs_.recorder();
  recorder.use(workers_.get());
  recorder.watch([this](sim::Observer* hashes) {
    times_.begin(logs_.recorder()->world().state().def.method, hashes);
    return &times_;
  });
  for (const sim::BoxDef& box : recorder.scene().boxes) looks_[box.id] = box.material.texture;
  for (const sim::TimedCommand& input : recorder.scene().inputs) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input.command)) {
      looks_[thrown->box.id] = thrown->box.material.texture;
    }
  }
  frame_.snapshot.ground = recorder.world().state().def.ground;
  frame_.snapshot.camera = recorder.scene().camera;
  frame_.snapshot.light = recorder.scene().light;
  frame_.dt = 0;
}

// A thread starts with the environment of the thread that started it, and a driver may have changed that one before.
Status LiveStepper::check_arithmetic() {
  if (sim::check_float_environment().ok()) return {};
  sim::restore_float_environment();
  ++frame_.restored;
  if (Status ok = sim::check_float_environment(); !ok.ok()) return ok;
  if (workers_ == nullptr) return {};
  workers_ = worker_threads(options_.threads);  // the old ones may have started with the same environment
  if (logs_.recorder() != nullptr) logs_.recorder()->use(workers_.get());
  return {};
}

// A SetDt sets what the clock asks for; the length of the step follows from that.
void LiveStepper::take_dt(std::vector<sim::Command>& inputs) {
  const double before = options_.dt;
  std::erase_if(inputs, [&](const sim::Command& input) {
    const auto* set = std::get_if<sim::SetDt>(&input);
    if (set != nullptr && set->dt >= sim::kDtMin && set->dt <= sim::kDtMax) options_.dt = set->dt;
    return set != nullptr;
  });
  if (options_.dt != before) restart_clock();
}

void LiveStepper::add_views(const std::vector<View>& views) {
  for (const View& view : views) {
    if (Status ok = logs_.recorder()->add_view(view); !ok.ok()) frame_.notice = ok.error().message;
  }
}

std::vector<sim::Command> LiveStepper::prepare(std::vector<sim::Command> given, double dt_s) {
  std::vector<std::string> refused;
  std::vector<sim::Command> accepted = checker_.check(*logs_.recorder(), std::move(given), refused);
  if (!refused.empty()) frame_.notice = "refused: " + refused.back();
  for (const sim::Command& input : accepted) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input)) looks_[thrown->box.id] = thrown->box.material.texture;
  }
  if (logs_.recorder()->world().state().def.dt != dt_s) accepted.emplace_back(sim::SetDt{dt_s});
  return accepted;
}

void LiveStepper::step(std::vector<sim::Command> inputs, const std::vector<View>& views) {
  SIM_CHECK(can_step());
  frame_.inputs_done += inputs.size();
  if (Status ok = check_arithmetic(); !ok.ok()) return end(ok.error());
  take_dt(inputs);
  const double start = now();
  const double dt = pace_.paused ? options_.dt * (pace_.even ? 1 : pace_.speed) : pacer_.begin(start);
  inputs = prepare(std::move(inputs), dt);
  add_views(views);
  const Status stepped = logs_.recorder()->step(inputs);
  frame_.step_seconds = now() - start;
  if (!pace_.paused) pacer_.end(now());
  if (!stepped.ok()) return end(stepped.error());
  frame_.dt = dt;
  logs_.note_step(dt);
}

const LiveFrame& LiveStepper::frame() {
  if (const Recorder* recorder = logs_.recorder()) {
    const sim::WorldState& state = recorder->world().state();
    frame_.step = state.step;
    frame_.gravity = state.def.gravity;
    fill_bodies(frame_, recorder->world(), looks_);
    if (with_contacts_) add_contact_markers(recorder->world(), frame_.snapshot);
  }
  frame_.time = logs_.time();
  frame_.scene_dt = options_.dt;
  frame_.log = logs_.path();
  frame_.phase_names = times_.names();
  frame_.phase_seconds = times_.seconds();
  frame_.hash_seconds = times_.inner_seconds();
  ++frame_.serial;
  return frame_;
}

}  // namespace tumble::replay
