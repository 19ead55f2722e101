// tumble render: pictures and movies of recorded states.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <system_error>

#include "src/files/output_guard.h"
#include "src/process/interrupt.h"
#include "tools/arguments/command.h"
#include "tools/arguments/render_options.h"
#include "tools/arguments/step_range.h"
#include "tools/files/log_files.h"
#include "tools/output/movie.h"
#include "tools/output/progress.h"
#include "tools/output/text.h"
#include "tumble/render/png.h"

namespace tumble::tools {
namespace {

// Facts about the drawn pictures, for the listing and for --json.
struct Summary {
  std::uint64_t pictures = 0;
  std::string first_hash, last_hash;  // state hashes
  std::string driver, backend;
  std::optional<replay::NotFinite> missing;  // of the first picture that lacks a body
  std::uint64_t older = 0;                   // pictures of an earlier run in the folder
};

// In steps: 12 is a state, 11.25 a moment between two.
double moment_of(const Frame& frame) {
  const auto step = static_cast<double>(frame.step);
  return frame.is_state() ? step : step - 1 + frame.part;
}

std::string moment_text(const Frame& frame) { return exact(moment_of(frame)); }

render::PngText text_of(const replay::LogReader& log, const RenderPlan& plan, const Frame& frame, const Hash128& hash) {
  render::PngText text = {{"Software", "tumble " TUMBLE_VERSION},
                          {"Scene", printable(log.header().scene.name)},
                          {"Step", moment_text(frame)},
                          {"State hash", to_string(hash)},
                          {"Effects", render::to_string(plan.settings.effects)}};
  return text;
}

// Pictures of states are named after their step, others by their number.
std::string picture_path(const RenderPlan& plan, std::size_t index, bool only_states) {
  if (plan.kind == OutputKind::kPicture) return plan.output;
  std::string number = std::to_string(only_states ? plan.frames[index].step : index);
  const std::size_t width = 4;
  if (number.size() < width) number.insert(0, width - number.size(), '0');
  return (std::filesystem::path(plan.output) / ("frame_" + number + ".png")).string();
}

bool has_only_states(const RenderPlan& plan) {
  return std::ranges::all_of(plan.frames, [](const Frame& frame) { return frame.is_state() && !frame.seen; });
}

Status check_outputs(const RenderArguments& arguments, const RenderPlan& plan) {
  files::OutputGuard guard;
  guard.keep(arguments.log, "the log that is drawn");
  guard.keep(arguments.compare, "the log of --compare");
  if (plan.kind != OutputKind::kFolder) return claim_output(guard, "-o", plan.output, files::kind_by_name(plan.output));
  std::error_code ignored;
  if (!std::filesystem::exists(plan.output, ignored)) return {};  // prepare_output makes the folder
  if (!std::filesystem::is_directory(plan.output, ignored)) {
    return bad_input("-o: " + plan.output +
                     ": is no folder to draw into; a picture's path ends with .png, a movie's with .mp4 or .webm");
  }
  const bool only_states = has_only_states(plan);
  for (std::size_t i = 0; i < plan.frames.size(); ++i) {
    if (Status ok = claim_output(guard, "-o", picture_path(plan, i, only_states), files::FileKind::kPng); !ok.ok())
      return ok;
  }
  return {};
}

// Pictures in the folder that this run does not replace: they could be mistaken for this run's.
std::uint64_t count_older(const RenderPlan& plan) {
  if (plan.kind != OutputKind::kFolder) return 0;
  const bool only_states = has_only_states(plan);
  std::set<std::string> ours;
  for (std::size_t i = 0; i < plan.frames.size(); ++i) {
    ours.insert(std::filesystem::path(picture_path(plan, i, only_states)).filename().string());
  }
  std::uint64_t older = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator at(plan.output, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.starts_with("frame_") && name.ends_with(".png") && !ours.contains(name)) ++older;
  }
  return older;
}

Status prepare_output(const RenderPlan& plan, Movie& movie) {
  if (plan.kind == OutputKind::kMovie) {
    return movie.start(plan.output, plan.settings.width, plan.settings.height, plan.fps);
  }
  if (plan.kind == OutputKind::kPicture) return {};
  std::error_code error;
  std::filesystem::create_directories(plan.output, error);
  if (!error && std::filesystem::is_directory(plan.output, error)) return {};
  return bad_input(plan.output + ": cannot be made a folder" + (error ? ": " + error.message() : "") +
                   "; a picture's path ends with .png, a movie's with .mp4 or .webm");
}

class Drawing {
 public:
  Drawing(const RenderPlan& plan, replay::LogReader& log, replay::LogReader* other)
      : plan_(plan), log_(log), frames_(log, other, plan.show), only_states_(has_only_states(plan)) {}

  Result<Summary> run() {
    Result<std::unique_ptr<render::Renderer>> renderer = render::Renderer::create(plan_.settings, plan_.backend);
    if (!renderer.ok()) return renderer.error();
    renderer_ = *std::move(renderer);
    const process::InterruptGuard guard;  // before ffmpeg has a file
    if (Status ok = prepare_output(plan_, movie_); !ok.ok()) return ok.error();
    summary_.older = count_older(plan_);
    summary_.driver = renderer_->driver();
    summary_.backend = renderer_->backend_name();
    ProgressBar bar("drawing");
    for (std::size_t i = 0; i < plan_.frames.size() && !process::InterruptGuard::interrupted(); ++i) {
      bar.show(i, plan_.frames.size());
      if (Status ok = draw(i); !ok.ok()) return ok.error();
    }
    bar.finish();
    if (process::InterruptGuard::interrupted()) return interrupted();
    if (plan_.kind == OutputKind::kMovie) {
      if (Status ok = movie_.finish(); !ok.ok()) return ok.error();
    }
    return summary_;
  }

 private:
  // A movie is whole or not there: `movie_` discards it.
  [[nodiscard]] Error interrupted() const {
    const std::string drawn = "interrupted after " + count_text(summary_.pictures, "picture") + " of " +
                              std::to_string(plan_.frames.size()) + "; ";
    if (plan_.kind == OutputKind::kMovie) return cannot_finish(drawn + "no movie was written to " + plan_.output);
    return cannot_finish(drawn + plan_.output + " holds them");
  }

  Status draw(std::size_t index) {
    const Frame& frame = plan_.frames[index];
    const Result<replay::Picture> picture = frames_.make(frame);
    if (!picture.ok()) return picture.error();
    if (!summary_.missing) summary_.missing = picture->not_finite;
    if (frame.seen) renderer_->use(frame.seen->effects);
    const Result<render::Image> image = renderer_->draw(picture->snapshot, plan_.stage);
    if (!image.ok()) return image.error();
    summary_.last_hash = to_string(picture->state_hash);
    if (summary_.pictures == 0) summary_.first_hash = summary_.last_hash;
    ++summary_.pictures;
    if (plan_.kind == OutputKind::kMovie) return movie_.add(*image);
    return render::write_png(picture_path(plan_, index, only_states_), *image,
                             text_of(log_, plan_, frame, picture->state_hash));
  }

  const RenderPlan& plan_;
  replay::LogReader& log_;
  FrameMaker frames_;
  std::unique_ptr<render::Renderer> renderer_;
  Movie movie_;
  Summary summary_;
  bool only_states_;
};

void print_text(const RenderPlan& plan, const Summary& summary) {
  Listing listing;
  const char* what[] = {"picture", "folder", "movie"};
  listing.add(what[static_cast<int>(plan.kind)], printable(plan.output));
  // To a thousandth of a step: dt as a float makes 239.99998748302525 of the last one.
  const auto about = [](const Frame& frame) { return exact(std::round(1000 * moment_of(frame)) / 1000); };
  const std::string first = about(plan.frames.front()), last = about(plan.frames.back());
  if (plan.frames.size() == 1) {
    listing.add("step", moment_text(plan.frames.front()));
    listing.add("state hash", summary.first_hash);
  } else {
    listing.add("steps", first + " to " + last + " in " + count_text(summary.pictures, "picture"));
  }
  listing.add("size", std::to_string(plan.settings.width) + " x " + std::to_string(plan.settings.height));
  if (summary.older > 0) listing.add("also there", count_text(summary.older, "picture") + " of an earlier run");
  listing.add("drawn with", summary.backend + ": " + printable(summary.driver));
  listing.print();
}

void print_json_summary(const std::string& log, const RenderPlan& plan, const Summary& summary) {
  Json json;
  json["log"] = log;
  json["output"] = plan.output;
  json["pictures"] = summary.pictures;
  json["older_pictures"] = summary.older;
  json["first_step"] = static_cast<double>(plan.frames.front().step) - 1 + plan.frames.front().part;
  json["last_step"] = static_cast<double>(plan.frames.back().step) - 1 + plan.frames.back().part;
  json["first_state_hash"] = summary.first_hash;
  json["last_state_hash"] = summary.last_hash;
  json["width"] = plan.settings.width;
  json["height"] = plan.settings.height;
  json["samples"] = plan.settings.samples;
  json["effects"] = render::to_string(plan.settings.effects);
  json["backend"] = summary.backend;
  json["driver"] = summary.driver;
  print_json("render", json);
}

Result<Exit> render_command(const RenderArguments& arguments) {
  Result<replay::LogReader> log = open_values(arguments.log);
  if (!log.ok()) return log.error();
  std::optional<replay::LogReader> other;
  if (!arguments.compare.empty()) {
    Result<replay::LogReader> opened = open_values(arguments.compare);
    if (!opened.ok()) return opened.error();
    other.emplace(*std::move(opened));
  }
  const Result<RenderPlan> plan = plan_of(arguments, *log);
  if (!plan.ok()) return plan.error();
  if (Status ok = check_outputs(arguments, *plan); !ok.ok()) return ok.error();
  if (other) {
    const std::uint64_t last = plan->frames.back().step;
    if (const Result<StepRange> range = check_range({last, last}, *other); !range.ok()) return range.error();
  }
  const Result<Summary> summary = Drawing(*plan, *log, other ? &*other : nullptr).run();
  if (!summary.ok()) return summary.error();
  if (arguments.json) {
    print_json_summary(arguments.log, *plan, *summary);
  } else {
    print_text(*plan, *summary);
  }
  if (summary->missing) {
    const replay::NotFinite& lost = *summary->missing;
    std::cerr << "tumble render: step " << lost.step << ": body " << lost.body << " is not drawn, because its "
              << lost.field << " is " << exact(lost.value);
    if (lost.bodies > 1) std::cerr << "; " << count_text(lost.bodies - 1, "body") << " more likewise";
    std::cerr << '\n';
  }
  const Exit verdict = judge("render", *log, Exit::kSame);
  return other ? judge("render", *other, verdict) : verdict;
}

}  // namespace

Action declare_render(Arguments& arguments) {
  auto given = std::make_shared<RenderArguments>();
  declare_arguments(arguments, *given);
  arguments.footer(
      "A PNG says which scene, step and state it shows. docs/rendering.md explains effects and passes.\n\n"
      "Examples:\n"
      "  tumble render brick_wall.tumble --step 60 -o wall.png --size 1280x720\n"
      "  tumble render brick_wall.tumble -o wall.mp4 --speed 0.25\n"
      "  tumble render pyramid.tumble --every 60 -o frames --show freezing\n"
      "  tumble render played.tumble --as-seen -o played.mp4\n"
      "  tumble render a.tumble --compare b.tumble --step 300\n"
      "  tumble render wall.tumble --camera position=3,-8,4 --camera target=0,0,1");
  return [given] { return render_command(*given); };
}

}  // namespace tumble::tools
