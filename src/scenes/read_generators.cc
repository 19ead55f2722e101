#include "src/scenes/read_generators.h"

#include <array>
#include <cmath>

#include "src/scenes/rules.h"

namespace tumble::scenes {
namespace {

Shape read_grid(TableReader& reader) {
  GridShape shape;
  shape.rows = reader.integer("rows", shape.rows, kCountRule);
  shape.cols = reader.integer("cols", shape.cols, kCountRule);
  shape.pitch = reader.number("pitch", shape.pitch, kDistanceRule);
  shape.tilt = reader.number("tilt", shape.tilt, kTiltRule);
  shape.base = reader.number("base", shape.base, kShiftRule);
  return shape;
}

Shape read_tower(TableReader& reader) {
  TowerShape shape;
  shape.count = reader.integer("count", shape.count, kCountRule);
  shape.taper = reader.number("taper", shape.taper, kTaperRule);
  shape.position = reader.vector("position", shape.position, kPositionRule);
  return shape;
}

Shape read_pyramid(TableReader& reader) {
  PyramidShape shape;
  shape.base = reader.integer("base", shape.base, kCountRule);
  shape.spacing = reader.number("spacing", shape.spacing, kDistanceRule);
  shape.position = reader.vector("position", shape.position, kPositionRule);
  return shape;
}

Shape read_wall(TableReader& reader) {
  WallShape shape;
  shape.courses = reader.integer("courses", shape.courses, kCountRule);
  shape.bricks = reader.integer("bricks", shape.bricks, kCountRule);
  shape.spacing = reader.number("spacing", shape.spacing, kDistanceRule);
  shape.shift = reader.number("shift", shape.shift, kShiftRule);
  shape.position = reader.vector("position", shape.position, kPositionRule);
  return shape;
}

Shape read_pile(TableReader& reader) {
  PileShape shape;
  std::array<std::uint64_t, 3> count = {shape.nx, shape.ny, shape.nz};
  reader.integers("count", count, kCountsRule);
  shape.nx = count[0];
  shape.ny = count[1];
  shape.nz = count[2];
  shape.pitch = reader.number("pitch", shape.pitch, kDistanceRule);
  shape.position = reader.vector("position", shape.position, kPositionRule);
  return shape;
}

// By index of kGeneratorNames, with the key that a message about too many bodies points at.
struct ShapeReader {
  Shape (*read)(TableReader& reader);
  const char* count_key;
};
constexpr ShapeReader kShapeReaders[] = {
    {read_grid, "rows"}, {read_tower, "count"}, {read_pyramid, "base"}, {read_wall, "courses"}, {read_pile, "count"}};
static_assert(std::size(kShapeReaders) == std::size(kGeneratorNames));
static_assert(std::size(kShapeReaders) == std::variant_size_v<Shape>);

Jitter read_jitter(TableReader& reader) {
  Jitter jitter;
  const toml::table* table = reader.table("jitter");
  if (!table) return jitter;
  TableReader inner(*table, reader.label(), reader.problem(), "jitter.");
  jitter.position = inner.number("position", jitter.position, kDistanceRule);
  jitter.degrees = inner.number("degrees", jitter.degrees, kTurnRule);
  jitter.seed = inner.integer("seed", jitter.seed, kSeedRule);
  inner.finish();
  return jitter;
}

bool position_holds(const sim::Vec3& position) {
  return kPositionRule.holds(position.x()) && kPositionRule.holds(position.y()) && kPositionRule.holds(position.z());
}

bool size_holds(const sim::Vec3& size) {
  return kSizeRule.holds(size.x()) && kSizeRule.holds(size.y()) && kSizeRule.holds(size.z());
}

std::string vector_text(const sim::Vec3& v) {
  return "[" + number_text(v.x()) + ", " + number_text(v.y()) + ", " + number_text(v.z()) + "]";
}

}  // namespace

Generator read_generator(TableReader& reader, std::size_t shape, std::uint32_t table,
                         const sim::Material& scene_material) {
  Generator generator;
  generator.table = table;
  generator.shape = kShapeReaders[shape].read(reader);
  generator.body = read_body_template(reader, scene_material);
  generator.jitter = read_jitter(reader);
  generator.first_id = read_id(reader, "first_id");
  if (!body_count(generator.shape)) {
    reader.fail(kShapeReaders[shape].count_key,
                "counts that make at most " + std::to_string(sim::kBodiesMax) + " bodies");
  }
  reader.finish();
  return generator;
}

std::vector<sim::BoxDef> generate_checked(const Generator& generator, const TableReader& reader) {
  std::vector<sim::BoxDef> boxes = generate(generator);
  for (const sim::BoxDef& box : boxes) {
    std::string wrong;
    if (!size_holds(box.size)) wrong = "size " + found_wanted(vector_text(box.size), kSizeRule.text());
    if (!kMassRule.holds(box.mass)) wrong = "mass " + found_wanted(number_text(box.mass), kMassRule.text());
    if (!position_holds(box.position)) {
      wrong = "position " + found_wanted(vector_text(box.position), kPositionRule.text());
    }
    if (wrong.empty()) continue;
    reader.problem().report(reader.place(), reader.label() + " row " + std::to_string(box.origin.row) + ", column " +
                                                std::to_string(box.origin.column) + ": " + wrong);
    return {};
  }
  return boxes;
}

}  // namespace tumble::scenes
