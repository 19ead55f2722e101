#include "tools/arguments/session_start.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include "src/base/text.h"
#include "tools/arguments/numbers.h"
#include "tools/files/scene_files.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::tools {

Result<SceneStart> read_scene_start(const std::string& scene, replay::RecordOptions how) {
  const Result<SceneFile> file = find_scene(scene);
  if (!file.ok()) return file.error();
  Result<std::string> text = read_scene(file->path);
  if (!text.ok()) return text.error();
  how.scene_text = *std::move(text);
  Result<sim::SceneDef> parsed = scenes::parse_scene(how.scene_text, file->path, how.overrides);
  if (!parsed.ok()) return parsed.error();
  return SceneStart{file->name, file->path, *std::move(parsed), std::move(how)};
}

std::string LogPlace::name() const {
  return std::filesystem::path(log).stem().string() + "_from_" + std::to_string(step);
}

Result<LogPlace> parse_log_place(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const std::optional<std::uint64_t> step =
      colon == std::string::npos ? std::nullopt : parse_whole(text.substr(colon + 1));
  if (step && colon > 0) return LogPlace{text.substr(0, colon), *step};
  return bad_input("--from: found " + in_quotes(text) + ", wanted LOG:STEP, as in brick_wall.tumble:120");
}

std::string inputs_left_out(const std::string& scene, const std::vector<std::string>& overrides,
                            const sim::SceneDef& recorded) {
  std::vector<sim::TimedCommand> inputs = recorded.inputs;
  if (!scene.empty()) {
    replay::RecordOptions whole;
    std::ranges::copy_if(overrides, std::back_inserter(whole.overrides), [](const std::string& set) {
      return !set.starts_with("world.steps=") && !set.starts_with("world.seconds=");
    });
    Result<SceneStart> start = read_scene_start(scene, std::move(whole));
    if (start.ok()) inputs = std::move(start->scene.inputs);
  }
  const auto is_late = [&](const sim::TimedCommand& input) { return input.step > recorded.steps; };
  const auto first = std::ranges::find_if(inputs, is_late);
  if (first == inputs.end()) return "";
  const auto count = static_cast<std::uint64_t>(std::ranges::count_if(inputs, is_late));
  return count_text(count, "input") + (count == 1 ? " is" : " are") + " planned behind step " +
         std::to_string(recorded.steps) + ", the last one, and not given; the first: " + sim::name_of(first->command) +
         " before step " + std::to_string(first->step);
}

}  // namespace tumble::tools
