#include "src/scenes/read_world.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "src/scenes/rules.h"

namespace tumble::scenes {
namespace {

constexpr std::array<const char*, 7> kCategories = {"symmetry", "energy",    "stacking", "impact",
                                                    "freezing", "rendering", "session"};
constexpr std::size_t kDefaultCategory = 6;
constexpr double kDefaultSeconds = 5;

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
}

// Names become file names, so characters that a shell or a file system treats specially are refused.
bool is_name(std::string_view text) {
  return !text.empty() && text.size() <= kNameLengthMax && text[0] != '.' && text[0] != '-' &&
         std::all_of(text.begin(), text.end(), is_name_character);
}

std::string name_of_file(std::string_view path) {
  const auto last_part = [](std::string_view text) { return text.substr(text.find_last_of('/') + 1); };
  std::string_view stem = last_part(path);
  stem = stem.substr(0, stem.find_last_of('.'));
  if (stem == "scene" && path.find('/') != std::string_view::npos) {
    stem = last_part(path.substr(0, path.find_last_of('/')));
  }
  std::string name(stem.substr(0, kNameLengthMax));
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !is_name_character(c); }, '_');
  return is_name(name) ? name : "scene";
}

std::uint64_t read_steps(TableReader& reader, double dt, bool& overridden) {
  const bool by_steps = reader.has("steps");
  if (by_steps && reader.has("seconds")) {
    reader.fail("steps", "either steps or seconds; remove one");
    return 1;
  }
  const char* key = by_steps ? "steps" : "seconds";
  overridden = reader.has(key) && reader.place(key).is_override();
  if (by_steps) return reader.required_integer("steps", kStepsRule);
  const double steps = std::round(reader.number("seconds", kDefaultSeconds, kSecondsRule) / dt);
  if (steps >= 1 && steps <= static_cast<double>(sim::kStepsMax)) return static_cast<std::uint64_t>(steps);
  reader.fail(reader.has("seconds") ? "seconds" : "dt",
              "times that make 1 to " + std::to_string(sim::kStepsMax) + " steps (seconds / dt)");
  return 1;
}

void read_look(TableReader& reader, sim::Vec3& position, sim::Vec3& target) {
  position = reader.vector("position", position, kViewRule);
  target = reader.vector("target", target, kViewRule);
  if (position == target) reader.fail("target", "another point than position, or there is no direction to look in");
}

// An empty stand-in for a table that the scene leaves out, so that defaults are written once.
const toml::table& table_or_empty(TableReader& top, std::string_view name) {
  static const toml::table kEmpty;
  const toml::table* table = top.table(name);
  return table ? *table : kEmpty;
}

}  // namespace

void read_titles(TableReader& top, std::string_view file_name, sim::SceneDef& scene) {
  scene.name = top.text("name", name_of_file(file_name), kNameLengthMax);
  if (!is_name(scene.name)) {
    top.fail("name", "a name of letters, digits, \"_\", \"-\" and \".\" that begins with a letter, a digit or \"_\"");
  }
  scene.title = top.text("title", scene.name, kTitleLengthMax);
  scene.category = kCategories[top.choice("category", kDefaultCategory, kCategories)];
}

InputClock read_world(TableReader& top, sim::SceneDef& scene) {
  TableReader reader(table_or_empty(top, "world"), "[world]", top.problem());
  sim::WorldDef& world = scene.world;
  world.method =
      static_cast<sim::Method>(reader.choice("method", static_cast<std::size_t>(world.method), sim::kMethodNames));
  world.dt = reader.number("dt", world.dt, kDtRule);
  InputClock clock{world.dt, 0, false};
  clock.steps = read_steps(reader, world.dt, clock.steps_overridden);
  scene.steps = clock.steps;
  world.substeps = static_cast<std::uint32_t>(reader.integer("substeps", world.substeps, kSubstepsRule));
  world.split_collisions =
      static_cast<std::uint32_t>(reader.integer("split_collisions", world.split_collisions, kSplitRule));
  world.gravity = reader.vector("gravity", world.gravity, kGravityRule);
  world.ground = reader.flag("ground", world.ground);
  world.freezing = reader.flag("freezing", world.freezing);
  world.freeze_energy = reader.number("freeze_energy", world.freeze_energy, kFreezeEnergyRule);
  world.freeze_time = reader.number("freeze_time", world.freeze_time, kFreezeTimeRule);
  world.slip_speed = reader.number("slip_speed", world.slip_speed, kSlipSpeedRule);
  world.air_drag = reader.number("air_drag", world.air_drag, kAirDragRule);
  reader.finish();
  return clock;
}

void read_view(TableReader& top, sim::SceneDef& scene) {
  TableReader camera(table_or_empty(top, "camera"), "[camera]", top.problem());
  read_look(camera, scene.camera.position, scene.camera.target);
  scene.camera.fov = camera.number("fov", scene.camera.fov, kFovRule);
  scene.camera.focus = sim::focus_on_target(scene.camera);
  scene.camera.focus = camera.number("focus", scene.camera.focus, kFocusRule);
  scene.camera.blur = camera.number("blur", scene.camera.blur, kBlurRule);
  camera.finish();

  TableReader light(table_or_empty(top, "light"), "[light]", top.problem());
  read_look(light, scene.light.position, scene.light.target);
  light.finish();
}

}  // namespace tumble::scenes
