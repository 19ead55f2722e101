#include "src/scenes/read_bodies.h"

#include <array>

#include "src/math/trig.h"
#include "src/scenes/rules.h"

namespace tumble::scenes {
namespace {

constexpr double kDirectionLengthMin = 1e-6;  // shorter axes and quaternions have no reliable direction

double read_mass(TableReader& reader, const sim::Vec3& size) {
  if (reader.has("mass") && reader.has("density")) {
    reader.fail("density", "either mass or density; remove one");
    return 1;
  }
  if (!reader.has("density")) return reader.number("mass", 1, kMassRule);
  const double volume = (size.x() * size.y()) * size.z();
  const double mass = reader.required_number("density", kDensityRule) * volume;
  if (kMassRule.holds(mass)) return mass;
  reader.fail("density", kMassRule.text() + " (density times volume gives " + number_text(mass) + " kg)");
  return 1;
}

sim::Quat read_axis_and_degrees(TableReader& reader) {
  if (!reader.has("axis") || !reader.has("degrees")) {
    reader.fail(reader.has("axis") ? "degrees" : "axis", "both axis and degrees");
    return {};
  }
  const sim::Vec3 axis = reader.required_vector("axis", kAxisRule);
  const double degrees = reader.required_number("degrees", kDegreesRule);
  if (sim::length(axis) >= kDirectionLengthMin) return turned_about(axis, degrees);
  reader.fail("axis", "a direction, not all zero");
  return {};
}

sim::Quat read_orientation(TableReader& reader) {
  const bool turned = reader.has("axis") || reader.has("degrees");
  if (reader.has("orientation") && turned) {
    reader.fail("orientation", "either orientation or axis with degrees; remove one");
    return {};
  }
  if (turned) return read_axis_and_degrees(reader);
  std::array<double, 4> q{};
  if (!reader.numbers("orientation", q, kQuaternionRule)) return {};
  const double squares = q[0] * q[0] + ((q[1] * q[1] + q[2] * q[2]) + q[3] * q[3]);
  if (squares >= kDirectionLengthMin * kDirectionLengthMin) return sim::normalised({q[0], q[1], q[2], q[3]});
  reader.fail("orientation", "a quaternion w, x, y, z that is not zero");
  return {};
}

}  // namespace

sim::Quat turned_about(const sim::Vec3& axis, double degrees) {
  const sim::SinCos half = sim::sin_cos_degrees(degrees / 2);
  const sim::Vec3 part = axis * (half.sin / sim::length(axis));
  return sim::normalised({half.cos, part.x(), part.y(), part.z()});
}

sim::Material read_material(const toml::table& table, const std::string& label, const std::string& prefix,
                            const sim::Material& base, Problem& problem) {
  TableReader reader(table, label, problem, prefix);
  sim::Material material = base;
  material.friction = reader.number("friction", base.friction, kFrictionRule);
  const double following = reader.has("friction") ? material.friction : base.friction_dynamic;
  material.friction_dynamic = reader.number("friction_dynamic", following, kFrictionRule);
  material.restitution = reader.number("restitution", base.restitution, kRestitutionRule);
  material.texture =
      static_cast<sim::Texture>(reader.choice("texture", static_cast<std::size_t>(base.texture), sim::kTextureNames));
  reader.finish();
  return material;
}

BodyTemplate read_body_template(TableReader& reader, const sim::Material& scene_material) {
  BodyTemplate body;
  body.size = reader.vector("size", {1, 1, 1}, kSizeRule);
  body.mass = read_mass(reader, body.size);
  body.material = scene_material;
  if (const toml::table* own = reader.table("material")) {
    body.material = read_material(*own, reader.label(), "material.", scene_material, reader.problem());
  }
  body.frozen = reader.flag("frozen", false);
  return body;
}

sim::BoxDef read_box(TableReader& reader, const sim::Material& scene_material) {
  const BodyTemplate body = read_body_template(reader, scene_material);
  sim::BoxDef box;
  box.id = read_id(reader, "id").value_or(0);
  box.size = body.size;
  box.mass = body.mass;
  box.material = body.material;
  box.frozen = body.frozen;
  box.is_static = reader.flag("static", false);
  box.position = reader.vector("position", {0, 0, 0.5}, kPositionRule);
  box.orientation = read_orientation(reader);
  box.velocity = reader.vector("velocity", {0, 0, 0}, kVelocityRule);
  box.spin = reader.vector("spin", {0, 0, 0}, kSpinRule);

  const bool at_rest = box.is_static || box.frozen;
  const char* wanted =
      box.is_static ? "zero or nothing: a static box does not move" : "zero or nothing: a frozen box starts at rest";
  if (at_rest && box.velocity != sim::Vec3(0, 0, 0)) reader.fail("velocity", wanted);
  if (at_rest && box.spin != sim::Vec3(0, 0, 0)) reader.fail("spin", wanted);
  if (box.is_static && box.frozen) reader.fail("frozen", "false or nothing: a static box does not move anyway");
  return box;
}

std::optional<sim::BodyId> read_id(TableReader& reader, std::string_view key) {
  if (!reader.has(key)) return std::nullopt;
  return reader.required_integer(key, kIdRule);
}

}  // namespace tumble::scenes
