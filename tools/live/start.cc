#include "tools/live/start.h"

#include <filesystem>
#include <memory>
#include <utility>

#include "src/files/output_guard.h"
#include "tools/arguments/session_start.h"
#include "tools/files/log_files.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/recorder.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::tools {
namespace {

// A session by hand cannot be repeated, so a log that was not named is never replaced.
std::string unused_log(const std::string& name) {
  std::string path = name + ".tumble";
  std::error_code error;
  for (int k = 2; std::filesystem::exists(path, error); ++k) path = name + "_" + std::to_string(k) + ".tumble";
  return path;
}

Status claim(const std::string& read, const char* about, const std::string& log) {
  files::OutputGuard guard;
  guard.keep(read, about);
  return guard.claim("-o", log);
}

Result<LiveStart> start_of_scene(const LiveArguments& arguments, const replay::StatesMode& states) {
  replay::RecordOptions how;
  how.states = states;
  how.overrides = arguments.overrides;
  Result<SceneStart> scene = read_scene_start(arguments.scene, std::move(how));
  if (!scene.ok()) return scene.error();
  LiveStart start;
  start.name = scene->name;
  start.camera = scene->scene.camera;
  start.options.dt = scene->scene.world.dt;
  start.options.log = arguments.log.empty() ? unused_log(scene->name + "_live") : arguments.log;
  if (Status ok = claim(scene->path, "the scene", start.options.log); !ok.ok()) return ok.error();
  start.options.begin = [scene = *std::move(scene)](const std::string& path) {
    return replay::Recorder::start(path, scene.scene, scene.how);
  };
  return start;
}

// The dt of a log that was played is that of its last step. The scene's own is in its text.
double dt_of(const replay::LogHeader& header) {
  const Result<sim::SceneDef> scene = scenes::parse_scene(header.scene_text, "scene", header.overrides);
  return scene.ok() ? scene->world.dt : header.scene.world.dt;
}

Result<LiveStart> start_of_log(const LiveArguments& arguments, const replay::StatesMode& states) {
  const Result<LogPlace> place = parse_log_place(arguments.from);
  if (!place.ok()) return place.error();
  Result<replay::LogReader> opened = open_log(place->log);
  if (!opened.ok()) return opened.error();
  const auto log = std::make_shared<replay::LogReader>(*std::move(opened));
  LiveStart start;
  start.name = place->name();
  start.camera = log->header().scene.camera;
  start.verdict = judge("live", *log, Exit::kSame);
  start.options.dt = dt_of(log->header());
  start.options.log = arguments.log.empty() ? unused_log(place->name()) : arguments.log;
  if (Status ok = claim(place->log, "the log to continue", start.options.log); !ok.ok()) return ok.error();
  replay::GoOnOptions how = {.states = states};
  how.keep_inputs = !arguments.no_inputs;
  if (log->header().scene.steps <= place->step) how.steps = 1;  // the scene's own end; a played session has none
  start.options.begin = [log, how, step = place->step](const std::string& path) {
    return replay::Recorder::go_on(path, *log, step, how);
  };
  return start;
}

}  // namespace

Result<LiveStart> read_live_start(const LiveArguments& arguments) {
  if (arguments.scene.empty() == arguments.from.empty()) {
    return bad_input(
        "SCENE is required, or --from LOG:STEP in its place\n'tumble live --help' explains the arguments.");
  }
  const Result<replay::StatesMode> states = replay::parse_states_mode(arguments.states);
  if (!states.ok()) return bad_input("--" + states.error().message);
  Result<LiveStart> start =
      arguments.from.empty() ? start_of_scene(arguments, *states) : start_of_log(arguments, *states);
  if (!start.ok()) return start;
  start->options.states = *states;
  start->options.threads = static_cast<unsigned>(arguments.threads.value_or(1));
  start->options.pace.even = arguments.even;
  return start;
}

}  // namespace tumble::tools
