#include "tools/arguments/render_options.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "replay/import/camera_change.h"
#include "src/base/text.h"
#include "tools/arguments/numbers.h"
#include "tools/arguments/step_range.h"
#include "tools/output/movie.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

constexpr double kFpsMax = 1000;
constexpr double kSpeedMax = 1000;

Error wrong(const char* option, const std::string& found, const std::string& wanted) {
  return bad_input(std::string(option) + ": found " + in_quotes(found) + ", wanted " + wanted);
}

Status read_show(const std::string& list, replay::PictureOptions& show) {
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::string word = list.substr(begin, end - begin);
    begin = end + 1;
    if (word == "bounds") {
      show.bounds = true;
    } else if (word == "freezing") {
      show.freezing = true;
    } else if (word == "contacts") {
      show.contacts = true;
    } else if (word == "velocities") {
      show.velocities = true;
    } else {
      return wrong("--show", word, "bounds, contacts, freezing or velocities, with commas between");
    }
  }
  return {};
}

Status read_look(const RenderArguments& arguments, RenderPlan& plan) {
  if (Status ok = read_size(arguments.size, plan.settings); !ok.ok()) return ok;
  const Result<render::Effects> effects = render::parse_effects(arguments.effects);
  if (!effects.ok()) return effects.error();
  plan.settings.effects = *effects;
  const Result<render::Stage> stage = render::parse_stage(arguments.pass);
  if (!stage.ok()) return stage.error();
  plan.stage = *stage;
  const Result<render::Backend> backend = render::parse_backend(arguments.gl);
  if (!backend.ok()) return backend.error();
  plan.backend = *backend;
  // An intermediate image is shown without scaling; with more samples it would be larger than the picture.
  plan.settings.samples = plan.stage == render::Stage::kFinal ? static_cast<int>(arguments.samples.value_or(2)) : 1;
  return read_show(arguments.show, plan.show);
}

Status read_camera(const std::vector<std::string>& settings, const sim::Camera& scene, replay::PictureOptions& show) {
  replay::CameraChange change;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) return wrong("--camera", setting, "KEY=VALUE, as in position=3,-8,4");
    if (Status ok = change.set(setting.substr(0, equals), setting.substr(equals + 1)); !ok.ok()) {
      return Error{ok.error().kind, "--camera: " + ok.error().message};
    }
  }
  const Result<sim::Camera> camera = change.applied_to(scene);
  if (!camera.ok()) return Error{camera.error().kind, "--camera: " + camera.error().message};
  show.camera = *camera;
  return {};
}

Result<OutputKind> kind_of(const std::string& output) {
  if (Movie::is_movie(output)) return OutputKind::kMovie;
  if (output.ends_with(".png")) return OutputKind::kPicture;
  const std::filesystem::path path = output;
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored) || path.filename().empty();
  if (is_folder || path.extension().empty()) return OutputKind::kFolder;
  return wrong("-o", output, "FILE.png for a picture, FILE.mp4 or FILE.webm for a movie, or FOLDER/ for pictures");
}

// "brick_wall_0120.png" in the current folder.
std::string default_output(const RenderArguments& arguments, std::uint64_t step) {
  std::string number = std::to_string(step);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return std::filesystem::path(arguments.log).stem().string() + '_' + number + ".png";
}

Result<std::vector<Frame>> frames_of(const RenderArguments& arguments, replay::LogReader& log, const RenderPlan& plan,
                                     const StepRange& range) {
  if (arguments.as_seen) return frames_as_seen(log, range.first, range.last, 1 / plan.fps);
  const bool in_time = arguments.speed || (plan.kind == OutputKind::kMovie && !arguments.every);
  if (!in_time) return frames_of_states(range.first, range.last, arguments.every.value_or(1));
  const double seconds_each = arguments.speed.value_or(1) / plan.fps;
  return frames_in_time(log, range.first, range.last, seconds_each);
}

}  // namespace

Status read_size(const std::string& text, render::Settings& settings) {
  const std::size_t x = text.find('x');
  const auto width = parse_whole(text.substr(0, x));
  const auto height = x == std::string::npos ? std::nullopt : parse_whole(text.substr(x + 1));
  constexpr std::uint64_t kLow = render::kSizeMin, kHigh = render::kSizeMax;
  if (!width || !height || *width < kLow || *height < kLow || *width > kHigh || *height > kHigh) {
    return wrong(
        "--size", text,
        "WxH in pixels, each from " + std::to_string(kLow) + " to " + std::to_string(kHigh) + ", as in 640x480");
  }
  settings.width = static_cast<int>(*width);
  settings.height = static_cast<int>(*height);
  return {};
}

void declare_arguments(Arguments& arguments, RenderArguments& target) {
  arguments.positional("LOG", target.log, "The log to draw").required();
  const Argument step = arguments.whole("--step", "K", target.step, 0, sim::kStepsMax,
                                        "One picture: the state after step K, 0 being the start (default: the last)");
  const Argument every =
      arguments.whole("--every", "N", target.every, 1, sim::kStepsMax, "Every N-th state").excludes(step);
  arguments.option("--steps", "A:B", target.steps, "From the state after step A to that after B (default: all)")
      .excludes(step);
  arguments.option("-o,--output", "PATH", target.output,
                   "The output: FILE.png; FILE.mp4 or FILE.webm for a movie; else a folder for numbered pictures");
  arguments.option("--size", "WxH", target.size, "Width and height in pixels (default: 640x480)");
  arguments.whole("--samples", "N", target.samples, 1, render::kSamplesMax,
                  "Samples of a pixel along each edge: 1 is quick, 2 (default) has smooth edges");
  arguments
      .option("--effects", "LIST", target.effects,
              "all, none, or some of specular,shadow,bloom,dof,motion,vertex; with - before each, all but these")
      .offers({"all", "none", "specular", "shadow", "bloom", "dof", "motion", "vertex"});
  arguments
      .option("--pass", "NAME", target.pass,
              "The image to write: depth, base, masks, shrunk, hdr, blur_x, blurred, glow, final (default)")
      .offers({"depth", "base", "masks", "shrunk", "hdr", "blur_x", "blurred", "glow", "final"});
  arguments.option("--show", "LIST", target.show, "Some of bounds,contacts,freezing,velocities")
      .offers({"bounds", "contacts", "freezing", "velocities"});
  arguments
      .option("--camera", "KEY=VALUE", target.camera,
              "Another camera: position=X,Y,Z, target=X,Y,Z (m), fov=DEGREES, focus=M (the distance to the target "
              "if not given), blur=B; may be repeated")
      .offers({"position=", "target=", "fov=", "focus=", "blur="});
  arguments.option("--compare", "OTHER", target.compare,
                   "Draw OTHER over LOG: bodies that differ are orange, OTHER's are blue");
  const Argument speed =
      arguments
          .positive("--speed", "X", target.speed, kSpeedMax, "Simulated seconds a second shows; 0.1 is slow motion")
          .excludes(step)
          .excludes(every);
  arguments
      .flag("--as-seen", target.as_seen,
            "A movie as the one who played saw it: camera, effects, pauses and slow motion (logs of 'tumble live')")
      .excludes(step)
      .excludes(every)
      .excludes(speed);
  arguments.positive("--fps", "F", target.fps, kFpsMax, "Frames a second of a movie (default: 30)");
  arguments.option("--gl", "WHICH", target.gl, "OpenGL through: auto (default), osmesa, egl")
      .offers({"auto", "osmesa", "egl"});
  arguments.json(target.json);
}

Result<RenderPlan> plan_of(const RenderArguments& arguments, replay::LogReader& log) {
  RenderPlan plan;
  if (Status ok = read_look(arguments, plan); !ok.ok()) return ok.error();
  const bool many = arguments.every || !arguments.steps.empty() || arguments.speed || arguments.as_seen;
  const std::uint64_t last = log.last_step();
  plan.output = arguments.output;
  plan.fps = arguments.fps.value_or(plan.fps);
  if (plan.output.empty()) {
    if (many) return bad_input("wanted -o PATH: a movie (.mp4, .webm) or a folder for many pictures");
    plan.output = default_output(arguments, arguments.step.value_or(last));
  }
  const Result<OutputKind> kind = kind_of(plan.output);
  if (!kind.ok()) return kind.error();
  plan.kind = *kind;
  if (Status ok = read_camera(arguments.camera, log.header().scene.camera, plan.show); !ok.ok()) return ok.error();
  if (plan.kind == OutputKind::kPicture && many) {
    return wrong("-o", plan.output, "a movie (.mp4, .webm) or a folder: one .png holds one picture");
  }
  const bool is_one = plan.kind == OutputKind::kPicture || arguments.step;
  Result<StepRange> range = is_one ? check_range({arguments.step.value_or(last), arguments.step.value_or(last)}, log)
                            : arguments.steps.empty() ? StepRange{log.first_state(), last}
                                                      : parse_range(arguments.steps, log);
  if (!range.ok()) return range.error();
  Result<std::vector<Frame>> frames = frames_of(arguments, log, plan, *range);
  if (!frames.ok()) return frames.error();
  plan.frames = *std::move(frames);
  return plan;
}

}  // namespace tumble::tools
