#include "python/binding/world.h"

#include <algorithm>
#include <utility>

#include "src/files/output_guard.h"
#include "src/world/float_environment.h"
#include "tumble/scenes/scene_file.h"
#include "tumble/sim/step.h"

namespace tumble::python {
namespace {

/// What a log holds of its steps.
struct Kept {
  replay::StatesMode states;
  replay::HashesMode hashes;
};

Result<Kept> kept_of(const std::string& states, const std::string& hashes) {
  const Result<replay::StatesMode> of_states = replay::parse_states_mode(states);
  if (!of_states.ok()) return bad_input("states: " + of_states.error().message);
  const Result<replay::HashesMode> of_hashes = replay::parse_hashes_mode(hashes);
  if (!of_hashes.ok()) return bad_input("hashes: " + of_hashes.error().message);
  return Kept{*of_states, *of_hashes};
}

}  // namespace

Result<LiveWorld::Running> LiveWorld::begin(const WorldStart& start) {
  Result<sim::SceneDef> scene = scenes::parse_scene(start.text, start.file, start.overrides);
  if (!scene.ok()) return scene.error();
  if (start.log.empty()) {
    Result<replay::Session> session = replay::Session::start(*std::move(scene));
    if (!session.ok()) return session.error();
    return Running(*std::move(session));
  }
  const Result<Kept> kept = kept_of(start.states, start.hashes);
  if (!kept.ok()) return kept.error();
  files::OutputGuard guard;
  guard.keep(start.file, "the scene");
  if (Status ok = guard.claim("record", start.log); !ok.ok()) return ok.error();
  replay::RecordOptions how;
  how.states = kept->states;
  how.hashes = kept->hashes;
  how.scene_text = start.text;
  how.overrides = start.overrides;
  Result<std::unique_ptr<replay::Recorder>> recorder = replay::Recorder::start(start.log, *scene, how);
  if (!recorder.ok()) return recorder.error();
  return Running(*std::move(recorder));
}

Result<LiveWorld::Running> LiveWorld::go_on(replay::LogReader& from, const WorldGoesOn& how) {
  const Result<Kept> kept = kept_of(how.states, how.hashes);
  if (!kept.ok()) return kept.error();
  const replay::GoOnOptions options = {kept->states, kept->hashes, how.steps, std::nullopt, how.inputs};
  if (!how.log.empty()) {
    files::OutputGuard guard;
    guard.keep(from.name(), "the log to continue");
    if (Status ok = guard.claim("record", how.log); !ok.ok()) return ok.error();
    Result<std::unique_ptr<replay::Recorder>> recorder = replay::Recorder::go_on(how.log, from, how.step, options);
    if (!recorder.ok()) return recorder.error();
    return Running(*std::move(recorder));
  }
  Result<replay::Continuation> next = replay::continuation_of(from, how.step, options);
  if (!next.ok()) return next.error();
  Result<replay::Session> session = replay::Session::resume(std::move(next->state), std::move(next->header.scene));
  if (!session.ok()) return session.error();
  return Running(*std::move(session));
}

LiveWorld::LiveWorld(const WorldStart& start)
    : LiveWorld(take(released([&] { return begin(start); })), start.threads) {}

LiveWorld::LiveWorld(LogFile& from, const WorldGoesOn& how)
    : LiveWorld(take(from.read([&](replay::LogReader& reader) { return go_on(reader, how); })), how.threads) {}

LiveWorld::LiveWorld(Running running, std::uint64_t threads)
    : threads_(worker_threads(threads)), running_(std::move(running)) {
  std::visit(
      [&](auto& session) {
        if constexpr (requires { session.use(threads_.get()); }) {
          session.use(threads_.get());
        } else {
          session->use(threads_.get());
        }
      },
      running_);
  for (const sim::BoxDef& box : scene().boxes) highest_id_ = std::max(highest_id_, box.id);
  for (const sim::TimedCommand& input : scene().inputs) note_id(input.command);
}

void LiveWorld::note_id(const sim::Command& command) {
  if (const auto* thrown = std::get_if<sim::Throw>(&command)) highest_id_ = std::max(highest_id_, thrown->box.id);
}

std::uint64_t LiveWorld::next_id() {
  return released([&] {
    const std::scoped_lock lock(mutex_);
    return highest_id_ + 1;
  });
}

const sim::World& LiveWorld::world() const {
  if (const auto* session = std::get_if<replay::Session>(&running_)) return session->world();
  return std::get<std::unique_ptr<replay::Recorder>>(running_)->world();
}

const sim::SceneDef& LiveWorld::scene() const {
  if (const auto* session = std::get_if<replay::Session>(&running_)) return session->scene();
  return std::get<std::unique_ptr<replay::Recorder>>(running_)->scene();
}

Status LiveWorld::can_step() const {
  if (failed_) return cannot_finish("the session ended with an error before: " + failed_->message);
  if (finished_) return bad_input("the session is finished; its world takes no more steps");
  // Any module of Python may be compiled with flags that change the arithmetic of the thread that loads it.
  return sim::check_float_environment();
}

// The scene's own inputs of the coming step come first, as the session applies them.
Status LiveWorld::try_input(const sim::Command& command) {
  if (Status ok = can_step(); !ok.ok()) return ok;
  if (!preview_) {
    preview_.emplace(world());
    preview_->use(nullptr);
    const std::uint64_t coming = preview_->state().step + 1;
    for (const sim::TimedCommand& input : scene().inputs) {
      if (input.step != coming) continue;
      if (Status ok = sim::apply(*preview_, input.command); !ok.ok()) return ok;
    }
  }
  if (Status ok = sim::apply(*preview_, command); !ok.ok()) return ok;
  note_id(command);
  inputs_.push_back(command);
  return {};
}

void LiveWorld::add_input(const sim::Command& command) {
  check(released([&] {
    const std::scoped_lock lock(mutex_);
    return try_input(command);
  }));
}

Status LiveWorld::step_once() {
  if (Status ok = can_step(); !ok.ok()) return ok;
  preview_.reset();
  const std::vector<sim::Command> inputs = std::exchange(inputs_, {});
  failed_ = cannot_finish("out of memory in a step");  // stays if an exception leaves this function
  Status status;
  if (auto* session = std::get_if<replay::Session>(&running_)) {
    const Result<replay::TakenStep> taken = session->step(inputs);
    if (!taken.ok()) status = taken.error();
  } else {
    status = std::get<std::unique_ptr<replay::Recorder>>(running_)->step(inputs);
  }
  failed_ = status.ok() ? std::nullopt : std::optional(status.error());
  return status;
}

std::uint64_t LiveWorld::step(std::uint64_t count) {
  std::uint64_t taken = 0;
  check(released([&]() -> Status {
    const std::scoped_lock lock(mutex_);
    Interruption interruption;
    for (; taken < count; ++taken) {
      if (interruption.came()) return {};
      if (Status ok = step_once(); !ok.ok()) return ok;
    }
    return {};
  }));
  return taken;
}

std::optional<replay::LogSummary> LiveWorld::finish() {
  const auto complete = [&]() -> Result<std::optional<replay::LogSummary>> {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(finished_, true)) return std::optional<replay::LogSummary>();
    auto* recorder = std::get_if<std::unique_ptr<replay::Recorder>>(&running_);
    if (recorder == nullptr) return std::optional<replay::LogSummary>();
    const Result<replay::LogSummary> summary = (*recorder)->finish();
    if (!summary.ok()) return summary.error();
    return std::optional(*summary);
  };
  return take(released(complete));
}

}  // namespace tumble::python
