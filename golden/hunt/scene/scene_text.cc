#include "golden/hunt/scene/scene_text.h"

#include <string_view>
#include <variant>

#include "src/base/text.h"
#include "tumble/scenes/scene_file.h"

namespace tumble::hunt {
namespace {

using sim::Material;
using sim::Quat;
using sim::Vec3;

// TOML tells 1 from 1.0; a scene takes both for a number.
std::string text_of(double value) { return exact(value); }
std::string text_of(const Vec3& v) { return "[" + exact(v.x()) + ", " + exact(v.y()) + ", " + exact(v.z()) + "]"; }
std::string text_of(const Quat& q) {
  return "[" + exact(q.w) + ", " + exact(q.x) + ", " + exact(q.y) + ", " + exact(q.z) + "]";
}
// A text of one line, as the reader of scenes takes it, as a basic string of TOML.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}
std::string text_of(bool value) { return value ? "true" : "false"; }
std::string text_of(std::uint64_t value) { return std::to_string(value); }

// "key = value" unless the value is the default.
template <class T>
void put(std::string& out, const char* key, const T& value, const T& otherwise) {
  if (value == otherwise) return;
  out += std::string(key) + " = " + text_of(value) + "\n";
}

void put_material(std::string& out, const Material& material, const Material& of_scene) {
  if (material.friction == of_scene.friction && material.friction_dynamic == of_scene.friction_dynamic &&
      material.restitution == of_scene.restitution)
    return;
  out += "material = { friction = " + exact(material.friction) +
         ", friction_dynamic = " + exact(material.friction_dynamic) + ", restitution = " + exact(material.restitution) +
         " }\n";
}

void put_box(std::string& out, const sim::BoxDef& box, const Material& of_scene) {
  const sim::BoxDef usual;
  out += "id = " + std::to_string(box.id) + "\n";
  put(out, "size", box.size, usual.size);
  put(out, "mass", box.mass, usual.mass);
  put(out, "static", box.is_static, false);
  put(out, "position", box.position, Vec3(0, 0, 0.5));
  put(out, "orientation", box.orientation, Quat{});
  put(out, "velocity", box.velocity, usual.velocity);
  put(out, "spin", box.spin, usual.spin);
  put_material(out, box.material, of_scene);
  put(out, "frozen", box.frozen, false);
}

struct PutCommand {
  std::string& out;
  const Material& of_scene;

  void operator()(const sim::Throw& input) const { put_box(out, input.box, of_scene); }
  void operator()(const sim::Push& input) const {
    named(input.id);
    out += "impulse = " + text_of(input.impulse) + "\n";
    if (!input.at_centre) out += "at = " + text_of(input.at) + "\n";
  }
  void operator()(const sim::Remove& input) const { named(input.id); }
  void operator()(const sim::Wake& input) const { named(input.id); }
  void operator()(const sim::SetVelocity& input) const {
    named(input.id);
    out += "velocity = " + text_of(input.velocity) + "\n";
    put(out, "spin", input.spin, Vec3(0, 0, 0));
  }
  void operator()(const sim::SetGravity& input) const { out += "gravity = " + text_of(input.gravity) + "\n"; }
  void operator()(const sim::SetDt& input) const { out += "dt = " + text_of(input.dt) + "\n"; }

 private:
  void named(sim::BodyId id) const { out += "id = " + std::to_string(id) + "\n"; }
};

void put_world(std::string& out, const sim::SceneDef& scene) {
  const sim::WorldDef &world = scene.world, usual;
  out += "\n[world]\n";
  out += std::string("method = \"") + name_of(world.method) + "\"\n";
  put(out, "dt", world.dt, usual.dt);
  out += "steps = " + std::to_string(scene.steps) + "\n";
  put<std::uint64_t>(out, "substeps", world.substeps, usual.substeps);
  put<std::uint64_t>(out, "split_collisions", world.split_collisions, usual.split_collisions);
  put(out, "gravity", world.gravity, usual.gravity);
  put(out, "ground", world.ground, usual.ground);
  put(out, "freezing", world.freezing, usual.freezing);
  put(out, "freeze_energy", world.freeze_energy, usual.freeze_energy);
  put(out, "freeze_time", world.freeze_time, usual.freeze_time);
  put(out, "slip_speed", world.slip_speed, usual.slip_speed);
  put(out, "air_drag", world.air_drag, usual.air_drag);
}

void put_ground_material(std::string& out, const Material& material) {
  const Material usual;
  if (material == usual) return;
  out += "\n[material]\n";
  put(out, "friction", material.friction, usual.friction);
  out += "friction_dynamic = " + exact(material.friction_dynamic) + "\n";
  put(out, "restitution", material.restitution, usual.restitution);
}

}  // namespace

std::string scene_text(const sim::SceneDef& scene) {
  std::string out = "name = " + quoted(scene.name) + "\n";
  if (!scene.title.empty() && scene.title != scene.name) out += "title = " + quoted(scene.title) + "\n";
  if (!scene.category.empty() && scene.category != "session") out += "category = " + quoted(scene.category) + "\n";
  put_world(out, scene);
  put_ground_material(out, scene.world.ground_material);
  for (const sim::BoxDef& box : scene.boxes) {
    out += "\n[[box]]\n";
    put_box(out, box, scene.world.ground_material);
  }
  for (const sim::TimedCommand& input : scene.inputs) {
    out += "\n[[input]]\nstep = " + std::to_string(input.step) + "\nkind = \"" + name_of(input.command) + "\"\n";
    std::visit(PutCommand{out, scene.world.ground_material}, input.command);
  }
  return out;
}

Result<TextScene> settled(const sim::SceneDef& scene) {
  constexpr int kTries = 8;
  TextScene now{scene_text(scene), {}};
  for (int k = 0; k < kTries; ++k) {
    Result<sim::SceneDef> read = scenes::parse_scene(now.text, scene.name + ".toml");
    if (!read.ok()) return read.error();
    now.scene = *std::move(read);
    std::string again = scene_text(now.scene);
    if (again == now.text) return now;
    now.text = std::move(again);
  }
  return bad_input(scene.name + ": reading the scene changes it again and again");
}

}  // namespace tumble::hunt
