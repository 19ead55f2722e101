// tumble record: runs a scene and writes a log.
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/log/session_clock.h"
#include "replay/measure/start_warnings.h"
#include "replay/session/frame_clock.h"
#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/arguments/kept_arguments.h"
#include "tools/arguments/session_start.h"
#include "tools/arguments/transform_arguments.h"
#include "tools/commands/session_stepper.h"
#include "tools/files/log_files.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/recorder.h"
#include "tumble/sim/limits.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::tools {
namespace {

constexpr double kSecondsMax = 1e9;

struct RecordCommand {
  std::string scene;
  std::string from;
  bool no_inputs = false;
  std::string log;
  std::optional<double> seconds;
  std::optional<std::uint64_t> steps;
  std::vector<std::string> overrides;
  std::optional<std::uint64_t> threads;
  RealTime realtime;
  TransformArguments transform;
  KeptArguments kept;
  bool json = false;
  bool quiet = false;
};

// A recorded session in numbers, beside those in its log.
struct Recorded {
  replay::LogSummary log;
  replay::SessionClock clock;
  std::uint64_t bodies = 0;             // of the start and thrown in
  std::uint64_t moving_body_steps = 0;  // bodies neither frozen nor static, summed over the steps
  double elapsed_s = 0;
  std::optional<replay::Frames> frames;  // of a session in real time
};

std::uint64_t count_moving(const sim::Bodies& bodies) {
  std::uint64_t count = 0;
  for (sim::BodyIndex i = 0; i < bodies.size(); ++i) count += bodies.moves(i) ? 1U : 0U;
  return count;
}

std::uint64_t count_bodies(const sim::SceneDef& scene, std::uint64_t last_step) {
  std::uint64_t count = scene.boxes.size();
  for (const sim::TimedCommand& input : scene.inputs) {
    if (input.step <= last_step && std::holds_alternative<sim::Throw>(input.command)) ++count;
  }
  return count;
}

Result<Recorded> run_session(const std::string& path, replay::Recorder& recorder, const RecordCommand& options) {
  SessionStepper stepper(recorder, options.realtime);
  const sim::SceneDef& scene = recorder.scene();
  const std::uint64_t first = recorder.world().state().step;
  const process::InterruptGuard guard;
  ProgressBar bar("recording", !options.quiet);
  Recorded session;
  Status status;
  for (std::uint64_t k = first + 1; k <= scene.steps && status.ok(); ++k) {
    status = stepper.step();
    if (!status.ok()) break;
    session.clock.add_step(recorder.world().state().def.dt);
    session.moving_body_steps += count_moving(recorder.world().bodies());
    bar.show(k - first, scene.steps - first);
    if (process::InterruptGuard::interrupted()) status = cannot_finish("interrupted after step " + std::to_string(k));
  }
  Result<replay::LogSummary> summary = recorder.finish();
  if (!summary.ok()) return status.ok() ? summary.error() : status.error();
  if (!status.ok()) {
    const std::string saved = "; " + path + " is complete up to step " + std::to_string(first + summary->steps);
    return Error{status.error().kind, status.error().message + saved};
  }
  session.log = *summary;
  session.bodies = count_bodies(scene, first + summary->steps);
  session.elapsed_s = stepper.elapsed_s();
  session.frames = stepper.frames();
  return session;
}

std::optional<double> bytes_each(const Recorded& session) {
  if (session.moving_body_steps == 0) return std::nullopt;
  return static_cast<double>(session.log.bytes) / static_cast<double>(session.moving_body_steps);
}

// Where hardly anything moves, the log's fixed parts would pass for the cost of motion.
bool moves_enough(const Recorded& session) {
  return session.moving_body_steps * 20 >= session.bodies * session.log.steps;
}

// Whether the session followed the clock. Frames can be computed in time and yet begin late, on a busy machine.
std::string clock_text(const replay::Frames& frames) {
  if (frames.bounded == 0) return "followed: each step is as long as the time since the step before";
  const std::string why = frames.missed > 0 ? "" : "; the machine began frames late, though each was quick to compute";
  return seconds_text(frames.behind_s) + " behind: " + count_text(frames.bounded, "step") +
         " reached the longest step allowed" + why;
}

void print_text(const std::string& path, const sim::SceneDef& scene, const Recorded& session) {
  Listing listing;
  listing.add("scene", printable(scene.name) + (scene.title.empty() ? "" : ": " + printable(scene.title)));
  listing.add("bodies", std::to_string(session.bodies));
  listing.add("steps", std::to_string(session.log.steps));
  listing.add("simulated", seconds_text(session.clock.now()));
  listing.add("elapsed", seconds_text(session.elapsed_s));
  if (session.frames) {
    const replay::Frames& frames = *session.frames;
    listing.add("frames", std::to_string(frames.met) + " computed in time, " + std::to_string(frames.missed) +
                              " late; the longest took " + rounded(frames.longest_s * 1000, "ms"));
    listing.add("clock", clock_text(frames));
  }
  listing.add("log", path);
  std::string size = bytes_text(session.log.bytes);
  if (const auto each = bytes_each(session); each && moves_enough(session))
    size += ", " + rounded(*each, "bytes per moving body-step");
  listing.add("size", size);
  listing.add("final hash", to_string(session.log.final_hash));
  listing.print();
}

void print_as_json(const std::string& path, const sim::SceneDef& scene, const Recorded& session,
                   const std::vector<std::string>& warnings) {
  Json json;
  json["log"] = path;
  json["scene"] = scene.name;
  json["bodies"] = session.bodies;
  json["steps"] = session.log.steps;
  json["simulated"] = session.clock.now();
  json["elapsed"] = session.elapsed_s;
  json["frames"] = nullptr;
  if (session.frames) {
    json["frames"] = {{"met", session.frames->met},
                      {"missed", session.frames->missed},
                      {"bounded", session.frames->bounded},
                      {"longest", session.frames->longest_s},
                      {"behind", session.frames->behind_s}};
  }
  json["bytes"] = session.log.bytes;
  json["moving_body_steps"] = session.moving_body_steps;
  json["bytes_per_moving_body_step"] = nullptr;
  if (const auto each = bytes_each(session)) json["bytes_per_moving_body_step"] = *each;
  json["final_hash"] = to_string(session.log.final_hash);
  json["warnings"] = warnings;
  print_json("record", json);
}

using Started = Result<std::unique_ptr<replay::Recorder>>;

// Starts a session of a scene from state 0. path: the log; empty: named after the scene.
Started start_scene(const RecordCommand& options, const Kept& kept, std::string& path) {
  replay::RecordOptions how;
  how.states = kept.states;
  how.hashes = kept.hashes;
  const Result<sim::Transform> transform = parse_transform(options.transform);
  if (!transform.ok()) return transform.error();
  how.transform = *transform;
  how.overrides = options.overrides;
  if (options.steps) how.overrides.push_back("world.steps=" + std::to_string(*options.steps));
  if (options.seconds) how.overrides.push_back("world.seconds=" + exact(*options.seconds));

  const Result<SceneStart> start = read_scene_start(options.scene, std::move(how));
  if (!start.ok()) return start.error();
  if (path.empty()) path = start->name + ".tumble";
  files::OutputGuard guard;
  guard.keep(start->path, "the scene");
  if (Status ok = guard.claim("-o", path); !ok.ok()) return ok.error();
  return replay::Recorder::start(path, start->scene, start->how);
}

// Starts a session that continues from a state of another one, and tells whether that log is whole.
Started start_from_log(const RecordCommand& options, const Kept& kept, std::string& path, Exit& verdict) {
  const Result<LogPlace> place = parse_log_place(options.from);
  if (!place.ok()) return place.error();
  if (path.empty()) path = place->name() + ".tumble";
  files::OutputGuard guard;
  guard.keep(place->log, "the log to continue");
  if (Status ok = guard.claim("-o", path); !ok.ok()) return ok.error();
  Result<replay::LogReader> log = open_log(place->log);
  if (!log.ok()) return log.error();
  const replay::GoOnOptions how = {kept.states, kept.hashes, options.steps, options.seconds, !options.no_inputs};
  Started started = replay::Recorder::go_on(path, *log, place->step, how);
  if (started.ok()) verdict = judge("record", *log, verdict);
  return started;
}

Result<Exit> record(const RecordCommand& options) {
  if (options.scene.empty() == options.from.empty()) {
    return bad_input(
        "SCENE is required, or --from LOG:STEP in its place\n'tumble record --help' explains the arguments.");
  }
  const Result<Kept> kept = parse_kept(options.kept);
  if (!kept.ok()) return kept.error();
  std::string path = options.log;
  Exit verdict = Exit::kSame;
  const Started recorder =
      options.from.empty() ? start_scene(options, *kept, path) : start_from_log(options, *kept, path, verdict);
  if (!recorder.ok()) return recorder.error();
  std::vector<std::string> advice;
  if (options.from.empty()) advice = replay::start_warnings((*recorder)->world().state(), (*recorder)->scene().inputs);
  if (std::string text = inputs_left_out(options.scene, options.overrides, (*recorder)->scene()); !text.empty())
    advice.push_back(std::move(text));
  for (const std::string& warning : advice) std::cerr << "tumble record: warning: " << printable(warning) << '\n';
  const std::unique_ptr<WorkerThreads> threads = worker_threads(options.threads.value_or(1));
  (*recorder)->use(threads.get());
  const Result<Recorded> session = run_session(path, **recorder, options);
  if (!session.ok()) return session.error();
  if (options.json) {
    print_as_json(path, (*recorder)->scene(), *session, advice);
  } else if (!options.quiet) {
    print_text(path, (*recorder)->scene(), *session);
  }
  return verdict;
}

}  // namespace

Action declare_record(Arguments& arguments) {
  auto options = std::make_shared<RecordCommand>();
  const Argument scene = arguments.positional(
      "SCENE", options->scene, "A scene file (.toml), or the name of a golden case ('tumble scenes' lists them)");
  arguments.option("-o,--output", "LOG", options->log, "The log; <scene>.tumble in the current folder if not given");
  const Argument seconds = arguments.positive("--seconds", "S", options->seconds, kSecondsMax, "Simulate this long");
  arguments.whole("--steps", "N", options->steps, 1, sim::kStepsMax, "Take this many steps").excludes(seconds);
  const Argument from = arguments
                            .option("--from", "LOG:STEP", options->from,
                                    "Continue from the state after step STEP of LOG instead of beginning a scene; "
                                    "--seconds and --steps count from there")
                            .excludes(scene);
  arguments.flag("--no-inputs", options->no_inputs, "With --from: leave out the inputs that LOG has after STEP")
      .needs(from);
  arguments
      .option("--set", "KEY=VALUE", options->overrides,
              "Set a value of the scene, as in 'grid.rows=7'; may be repeated")
      .excludes(from);
  add_transform(arguments, options->transform, from);
  arguments.threads(options->threads);
  const Argument realtime = arguments.flag("--realtime", options->realtime.on,
                                           "Step with the clock, a frame every dt of the scene; "
                                           "step lengths are inputs in the log, so it replays like any other");
  arguments
      .positive("--longest-step", "S", options->realtime.longest_step, sim::kDtMax,
                "With --realtime: the longest step, s; four times dt if not given")
      .needs(realtime);
  add_kept(arguments, options->kept);
  arguments.json(options->json);
  arguments.flag("--quiet", options->quiet, "Print no result and no progress, only warnings and errors");
  arguments.footer(
      "Examples:\n"
      "  tumble record brick_wall\n"
      "  tumble record tilted_grid -o small.tumble --set grid.rows=6 --set grid.cols=6 --steps 150\n"
      "  tumble record my_scene.toml --states hashes --json\n"
      "  tumble record my_scene.toml --hashes every:10\n"
      "  tumble record tilted_grid --realtime --set world.dt=0.0333 --seconds 5\n"
      "  tumble record brick_wall -o mirrored.tumble --mirror x --permute 7\n"
      "  tumble record --from brick_wall.tumble:120 --seconds 2");
  return [options] { return record(*options); };
}

}  // namespace tumble::tools
