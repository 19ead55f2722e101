// tumble scenes: lists the scenes that can be recorded by name.
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>

#include "tools/arguments/arguments.h"
#include "tools/arguments/command.h"
#include "tools/files/scene_files.h"
#include "tools/output/text.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::tools {
namespace {

struct ScenesCommand {
  bool json = false;
};

Result<sim::SceneDef> load(const SceneFile& file) {
  const Result<std::string> text = read_scene(file.path);
  if (!text.ok()) return text.error();
  return scenes::parse_scene(*text, file.path);
}

std::uint64_t count_bodies(const sim::SceneDef& scene) {
  std::uint64_t count = scene.boxes.size();
  for (const sim::TimedCommand& input : scene.inputs)
    count += std::holds_alternative<sim::Throw>(input.command) ? 1U : 0U;
  return count;
}

Result<Exit> list_scenes(const ScenesCommand& options) {
  const std::vector<SceneFile> cases = find_cases();
  if (cases.empty()) {
    return bad_input("found no folder golden/cases from here upwards; go to the source folder, or give record a file");
  }
  Exit exit = Exit::kSame;
  Table table({"NAME", "CATEGORY", ">BODIES", ">STEPS", "TITLE"});
  Json json = Json::array();
  for (const SceneFile& file : cases) {
    const Result<sim::SceneDef> scene = load(file);
    if (!scene.ok()) {
      std::cerr << "tumble scenes: " << scene.error().message << '\n';
      exit = Exit::kBadInput;
      continue;
    }
    const std::uint64_t bodies = count_bodies(*scene);
    table.add(
        {file.name, scene->category, std::to_string(bodies), std::to_string(scene->steps), printable(scene->title)});
    json.push_back({{"name", file.name},
                    {"category", scene->category},
                    {"title", scene->title},
                    {"bodies", bodies},
                    {"steps", scene->steps},
                    {"file", file.path}});
  }
  if (options.json) {
    print_json("scenes", json);
  } else {
    table.print();
  }
  return exit;
}

}  // namespace

Action declare_scenes(Arguments& arguments) {
  auto options = std::make_shared<ScenesCommand>();
  arguments.json(options->json);
  arguments.footer(
      "The golden cases: golden/cases/NAME/scene.toml of the nearest folder from here upwards, and those that came\n"
      "with the program.\n\n"
      "Examples:\n"
      "  tumble scenes\n"
      "  tumble scenes --json");
  return [options] { return list_scenes(*options); };
}

}  // namespace tumble::tools
