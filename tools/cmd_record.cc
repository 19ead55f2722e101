// tumble record: a scene in, a log out.
#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "replay/recorder.h"
#include "replay/session_clock.h"
#include "src/model/limits.h"
#include "src/scenes/scene_file.h"
#include "tools/arguments.h"
#include "tools/command.h"
#include "tools/interrupt.h"
#include "tools/progress.h"
#include "tools/scene_files.h"
#include "tools/text.h"
#include "tools/transform_arguments.h"

namespace tumble::tools {
namespace {

constexpr double kSecondsMax = 1e9;

struct Options {
  std::string scene;
  std::string log;
  std::optional<double> seconds;
  std::optional<std::uint64_t> steps;
  std::vector<std::string> overrides;
  std::optional<std::uint64_t> threads;
  TransformArguments transform;
  std::string states = "all";
  bool json = false;
  bool quiet = false;
};

// What a session came to, beside what its log says.
struct Session {
  replay::LogSummary log;
  replay::SessionClock clock;
  std::uint64_t bodies = 0;             // of the start and thrown in
  std::uint64_t moving_body_steps = 0;  // bodies neither frozen nor static, summed over the steps
  double elapsed_s = 0;
};

std::uint64_t count_moving(const sim::Bodies& bodies) {
  std::uint64_t count = 0;
  for (sim::BodyIndex i = 0; i < bodies.size(); ++i) count += bodies.moves(i) ? 1U : 0U;
  return count;
}

std::uint64_t count_bodies(const sim::SceneDef& scene, std::uint64_t steps) {
  std::uint64_t count = scene.boxes.size();
  for (const sim::TimedCommand& input : scene.inputs) {
    if (input.step <= steps && std::holds_alternative<sim::Throw>(input.command)) ++count;
  }
  return count;
}

Result<Session> run_session(const std::string& path, const sim::SceneDef& scene, const replay::RecordOptions& options,
                            bool quiet) {
  const auto begin = std::chrono::steady_clock::now();
  Result<std::unique_ptr<replay::Recorder>> started = replay::Recorder::start(path, scene, options);
  if (!started.ok()) return started.error();
  replay::Recorder& recorder = **started;
  const InterruptGuard guard;
  ProgressBar bar("recording", !quiet);
  Session session;
  Status status;
  for (std::uint64_t k = 1; k <= scene.steps && status.ok(); ++k) {
    status = recorder.step();
    if (!status.ok()) break;
    session.clock.add_step(recorder.world().state().def.dt);
    session.moving_body_steps += count_moving(recorder.world().bodies());
    bar.show(k, scene.steps);
    if (InterruptGuard::interrupted()) status = cannot_finish("interrupted after step " + std::to_string(k));
  }
  Result<replay::LogSummary> summary = recorder.finish();
  if (!summary.ok()) return status.ok() ? summary.error() : status.error();
  if (!status.ok()) {
    const std::string saved = "; " + path + " is complete up to step " + std::to_string(summary->steps);
    return Error{status.error().kind, status.error().message + saved};
  }
  session.log = *summary;
  session.bodies = count_bodies(scene, summary->steps);
  session.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return session;
}

void print_text(const std::string& path, const sim::SceneDef& scene, const Session& session) {
  Listing listing;
  listing.add("scene", printable(scene.name) + (scene.title.empty() ? "" : ": " + printable(scene.title)));
  listing.add("bodies", std::to_string(session.bodies));
  listing.add("steps", std::to_string(session.log.steps));
  listing.add("simulated", seconds_text(session.clock.now()));
  listing.add("elapsed", seconds_text(session.elapsed_s));
  listing.add("log", path);
  std::string size = bytes_text(session.log.bytes);
  if (session.moving_body_steps > 0) {
    const double each = static_cast<double>(session.log.bytes) / static_cast<double>(session.moving_body_steps);
    size += ", " + rounded(each, "bytes per moving body-step");
  }
  listing.add("size", size);
  listing.add("final hash", to_string(session.log.final_hash));
  listing.print();
}

void print_as_json(const std::string& path, const sim::SceneDef& scene, const Session& session) {
  Json json;
  json["log"] = path;
  json["scene"] = scene.name;
  json["bodies"] = session.bodies;
  json["steps"] = session.log.steps;
  json["simulated"] = session.clock.now();
  json["elapsed"] = session.elapsed_s;
  json["bytes"] = session.log.bytes;
  json["moving_body_steps"] = session.moving_body_steps;
  json["bytes_per_moving_body_step"] = nullptr;
  if (session.moving_body_steps > 0) {
    json["bytes_per_moving_body_step"] =
        static_cast<double>(session.log.bytes) / static_cast<double>(session.moving_body_steps);
  }
  json["final_hash"] = to_string(session.log.final_hash);
  print_json(json);
}

Result<Exit> record(const Options& options) {
  replay::RecordOptions how;
  Result<replay::StatesMode> states = replay::parse_states_mode(options.states);
  if (!states.ok()) return bad_input("--" + states.error().message);
  how.states = *states;
  const Result<sim::Transform> transform = parse_transform(options.transform);
  if (!transform.ok()) return transform.error();
  how.transform = *transform;
  how.overrides = options.overrides;
  if (options.steps) how.overrides.push_back("world.steps=" + std::to_string(*options.steps));
  if (options.seconds) how.overrides.push_back("world.seconds=" + exact(*options.seconds));

  const Result<SceneFile> file = find_scene(options.scene);
  if (!file.ok()) return file.error();
  Result<std::string> text = read_scene(file->path);
  if (!text.ok()) return text.error();
  how.scene_text = *std::move(text);
  const Result<sim::SceneDef> scene = scenes::parse_scene(how.scene_text, file->path, how.overrides);
  if (!scene.ok()) return scene.error();

  const std::string path = options.log.empty() ? file->name + ".tumble" : options.log;
  const Result<Session> session = run_session(path, *scene, how, options.quiet);
  if (!session.ok()) return session.error();
  if (options.json) {
    print_as_json(path, *scene, *session);
  } else if (!options.quiet) {
    print_text(path, *scene, *session);
  }
  return Exit::kSame;
}

}  // namespace

Action declare_record(CLI::App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("SCENE", options->scene,
                 "A scene file (.toml), or the name of a golden case ('tumble scenes' lists them)")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", options->log, "The log; <scene>.tumble in the current folder if not given")
      ->type_name("LOG");
  CLI::Option* seconds = add_positive(app, "--seconds", options->seconds, kSecondsMax, "Simulate this long");
  seconds->type_name("S");
  add_whole(app, "--steps", options->steps, 1, sim::kStepsMax, "Take this many steps")
      ->type_name("N")
      ->excludes(seconds);
  app.add_option("--set", options->overrides, "Set a value of the scene, as in 'grid.rows=7'; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  add_transform(app, options->transform);
  add_threads(app, options->threads);
  app.add_option("--states", options->states,
                 "Which states the log holds: all (if not given), every:N (one step in N) or hashes (none); the others "
                 "can be simulated again")
      ->type_name("MODE");
  add_json(app, options->json);
  app.add_flag("--quiet", options->quiet, "Print nothing but errors");
  app.footer(
      "Examples:\n"
      "  tumble record brick_wall\n"
      "  tumble record tilted_grid -o small.tumble --set grid.rows=6 --set grid.cols=6 --steps 150\n"
      "  tumble record my_scene.toml --states hashes --json\n"
      "  tumble record brick_wall -o twin.tumble --mirror x --permute 7");
  return [options] { return record(*options); };
}

}  // namespace tumble::tools
