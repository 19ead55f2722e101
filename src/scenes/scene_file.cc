#include "tumble/scenes/scene_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>
#include <vector>

#include "src/scenes/body_ids.h"
#include "src/scenes/overrides.h"
#include "src/scenes/parse_toml.h"
#include "src/scenes/read_bodies.h"
#include "src/scenes/read_generators.h"
#include "src/scenes/read_inputs.h"
#include "src/scenes/read_world.h"
#include "src/scenes/rules.h"

namespace tumble::scenes {
namespace {

// The body tables of a scene as read, before ids are given and generators expanded.
struct BodyTables {
  std::vector<sim::BoxDef> boxes;
  std::vector<Generator> generators;
  std::vector<TableReader> generator_readers;  // for messages about what they make
  std::vector<PendingInput> inputs;
  BodyIds ids;
  std::uint64_t count = 0;
};

// The tables of an array such as [[box]]; none after an error.
std::vector<const toml::table*> tables_of(TableReader& top, std::string_view name) {
  std::vector<const toml::table*> tables;
  const toml::array* array = top.array_of_tables(name);
  if (!array) return tables;
  for (const toml::node& node : *array) tables.push_back(node.as_table());
  return tables;
}

std::string label_of(std::string_view name) { return "[[" + std::string(name) + "]]"; }

// Counts bodies before they are made, and reserves the ids that their table gives.
void announce(BodyTables& bodies, TableReader& reader, std::uint64_t count, sim::BodyId first,
              std::string_view id_key) {
  bodies.count += count;
  if (bodies.count > sim::kBodiesMax) {
    reader.problem().report(reader.place(), reader.label() + ": " +
                                                found_wanted("more than " + std::to_string(sim::kBodiesMax) + " bodies",
                                                             "fewer of them up to here"));
    return;
  }
  if (first == 0) return;
  const std::string what = reader.label() + " key " + in_quotes(id_key);
  bodies.ids.reserve(first, count, reader.place(id_key), what, reader.problem());
}

void read_boxes(TableReader& top, const sim::Material& material, BodyTables& bodies) {
  for (const toml::table* table : tables_of(top, "box")) {
    TableReader reader(*table, label_of("box"), top.problem());
    sim::BoxDef box = read_box(reader, material);
    box.origin.table = static_cast<std::uint32_t>(bodies.boxes.size());
    reader.finish();
    announce(bodies, reader, 1, box.id, "id");
    bodies.boxes.push_back(box);
  }
}

void read_generators(TableReader& top, const sim::Material& material, BodyTables& bodies) {
  for (std::size_t shape = 0; shape < std::size(kGeneratorNames); ++shape) {
    std::uint32_t table_number = 0;
    for (const toml::table* table : tables_of(top, kGeneratorNames[shape])) {
      TableReader reader(*table, label_of(kGeneratorNames[shape]), top.problem());
      Generator generator = read_generator(reader, shape, table_number++, material);
      const std::uint64_t count = body_count(generator.shape).value_or(0);
      if (count > 0) announce(bodies, reader, count, generator.first_id.value_or(0), "first_id");
      bodies.generators.push_back(std::move(generator));
      bodies.generator_readers.push_back(std::move(reader));
    }
  }
}

void read_inputs(TableReader& top, const sim::Material& material, const InputClock& clock, BodyTables& bodies) {
  const std::vector<const toml::table*> tables = tables_of(top, "input");
  if (tables.size() > sim::kInputsMax) {
    top.fail("input", "at most " + std::to_string(sim::kInputsMax) + " inputs");
    return;
  }
  for (const toml::table* table : tables) {
    TableReader reader(*table, label_of("input"), top.problem());
    PendingInput input = read_input(reader, static_cast<std::uint32_t>(bodies.inputs.size()), clock, material);
    if (const auto* thrown = std::get_if<sim::Throw>(&input.timed.command)) {
      announce(bodies, reader, 1, thrown->box.id, "id");
    }
    bodies.inputs.push_back(std::move(input));
  }
}

// Boxes, then generators, then thrown boxes: the order in which ids are given to those without one.
std::vector<sim::BoxDef> resolve_boxes(BodyTables& bodies, Problem& problem) {
  bodies.ids.finish_reserving(problem);
  if (problem.found()) return {};
  std::vector<sim::BoxDef> boxes = std::move(bodies.boxes);
  boxes.reserve(bodies.count);
  for (sim::BoxDef& box : boxes) {
    if (box.id == 0) box.id = bodies.ids.next();
  }
  for (std::size_t i = 0; i < bodies.generators.size(); ++i) {
    const Generator& generator = bodies.generators[i];
    std::vector<sim::BoxDef> made = generate_checked(generator, bodies.generator_readers[i]);
    for (std::size_t k = 0; k < made.size(); ++k) {
      made[k].id = generator.first_id ? *generator.first_id + k : bodies.ids.next();
      boxes.push_back(made[k]);
    }
  }
  for (PendingInput& input : bodies.inputs) {
    auto* thrown = std::get_if<sim::Throw>(&input.timed.command);
    if (thrown && thrown->box.id == 0) thrown->box.id = bodies.ids.next();
  }
  std::sort(boxes.begin(), boxes.end(), [](const sim::BoxDef& a, const sim::BoxDef& b) { return a.id < b.id; });
  return boxes;
}

sim::SceneDef resolve(const toml::table& root, std::string_view file_name, Problem& problem) {
  TableReader top(root, "", problem);
  sim::SceneDef scene;
  read_titles(top, file_name, scene);
  sim::Material material;
  if (const toml::table* table = top.table("material"))
    material = read_material(*table, "[material]", "", material, problem);
  const InputClock clock = read_world(top, scene);
  scene.world.ground_material = material;
  read_view(top, scene);

  BodyTables bodies;
  read_boxes(top, material, bodies);
  read_generators(top, material, bodies);
  read_inputs(top, material, clock, bodies);
  top.finish();
  if (bodies.count == 0) {
    problem.report(top.place(),
                   found_wanted("no body", "at least one [[box]], generator or [[input]] that throws a box"));
  }
  scene.boxes = resolve_boxes(bodies, problem);
  if (!problem.found()) scene.inputs = check_inputs(std::move(bodies.inputs), scene.boxes, problem);
  return scene;
}

Result<sim::SceneDef> parse_and_resolve(std::string_view text, std::string_view file_name,
                                        std::span<const std::string> overrides) {
  Problem problem(file_name);
  std::optional<toml::table> root = parse_toml(text, "", problem);
  if (!root) return problem.error();
  for (const std::string& argument : overrides) {
    if (Status status = apply_override(*root, argument); !status.ok()) return status.error();
  }
  sim::SceneDef scene = resolve(*root, file_name, problem);
  if (problem.found()) return problem.error();
  return scene;
}

}  // namespace

Result<sim::SceneDef> parse_scene(std::string_view toml_text, std::string_view file_name,
                                  std::span<const std::string> overrides) {
  try {
    return parse_and_resolve(toml_text, file_name, overrides);
  } catch (const std::bad_alloc&) {
    return cannot_finish(std::string(file_name) + ": not enough memory for this scene");
  }
}

}  // namespace tumble::scenes
