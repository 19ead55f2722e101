#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/picture/picture_source.h"
#include "tools/arguments/arguments.h"
#include "tools/output/frames.h"
#include "tumble/render/renderer.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The arguments of `tumble render`, as given.
struct RenderArguments {
  std::string log, compare, output;
  std::optional<std::uint64_t> step, every, samples;
  std::optional<double> speed, fps;
  std::vector<std::string> camera;
  std::string steps, size = "640x480", effects = "all", pass = "final", show, gl = "auto";
  bool as_seen = false;
  bool json = false;
};
void declare_arguments(Arguments& arguments, RenderArguments& target);

/// The argument --size: sets width and height of `settings`. Errors (kBadInput): not WxH within a picture's limits.
Status read_size(const std::string& text, render::Settings& settings);

/// The kind of output.
enum class OutputKind { kPicture, kFolder, kMovie };

/// The meaning of the arguments for a log.
struct RenderPlan {
  render::Settings settings;
  render::Stage stage = render::Stage::kFinal;
  render::Backend backend = render::Backend::kAuto;
  replay::PictureOptions show;
  OutputKind kind = OutputKind::kPicture;
  std::string output;
  std::vector<Frame> frames;
  double fps = 30;
};

/// Errors (kBadInput): a word, size or range that is wrong, or arguments that do not go together; the log's.
Result<RenderPlan> plan_of(const RenderArguments& arguments, replay::LogReader& log);

}  // namespace tumble::tools
