#include "replay/export/table/table_frame.h"

#include <algorithm>
#include <cmath>

#include "replay/export/table/channel_cells.h"
#include "replay/format/not_finite.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

std::string triple(const sim::Vec3& v) { return exact(v.x()) + ' ' + exact(v.y()) + ' ' + exact(v.z()); }

/// A value on one line.
std::string line_text(const std::string& text) { return printable(text); }

}  // namespace

EngineAxes table_axes(const LogHeader& header) {
  EngineAxes axes = header.axes();
  axes.metres = 1;
  return axes;
}

TableSettings table_settings(const ExportPlan& plan) {
  const LogHeader& header = plan.header;
  const EngineAxes axes = table_axes(header);
  const sim::Camera& camera = header.scene.camera;
  TableSettings lines;
  const auto add = [&](const char* key, const std::string& value) { lines.emplace_back(key, line_text(value)); };
  const bool ours = !header.engine;
  add("engine", ours ? "Tumble" : header.engine->name);
  const std::string version = ours ? header.tool_version : header.engine->version;
  if (!version.empty()) add("version", version);
  if (!header.scene.name.empty()) add("scene", header.scene.name);
  add("up", std::string(1, static_cast<char>('x' + axes.up)));
  add("handed", axes.left_handed ? "left" : "right");
  for (const auto& [key, value] : precision_settings(header)) lines.emplace_back(key, value);
  if (plan.dt) add("dt", exact(*plan.dt));
  add("gravity", triple(axes.their_length(header.scene.world.gravity)));
  add("ground", header.scene.world.ground ? "yes" : "no");
  add("camera.position", triple(axes.their_length(camera.position)));
  add("camera.target", triple(axes.their_length(camera.target)));
  add("camera.fov", exact(camera.fov));
  add("camera.focus", exact(camera.focus));
  add("camera.blur", exact(camera.blur));
  if (const std::string derived = derived_columns(header.declared); !derived.empty()) add("derived", derived);
  return lines;
}

const BodyStates& TableFrame::states(const BodyStates& ours) {
  if (ours_) return ours;
  theirs_ = ours;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    theirs_.position.set(i, axes_.their_length(ours.position[i]));
    theirs_.velocity.set(i, axes_.their_length(ours.velocity[i]));
    theirs_.spin.set(i, axes_.their_axial(ours.spin[i]));
    const sim::Quat q = axes_.their_turn(ours.orientation[i]);
    theirs_.orientation.w[i] = q.w;
    theirs_.orientation.x[i] = q.x;
    theirs_.orientation.y[i] = q.y;
    theirs_.orientation.z[i] = q.z;
  }
  return theirs_;
}

sim::Vec3 TableFrame::extents(const sim::Vec3& size) const {
  const sim::Vec3 turned = axes_.their_direction(size);
  return {std::fabs(turned.x()), std::fabs(turned.y()), std::fabs(turned.z())};
}

std::string shape_word(const ExportBody& body, const EngineAxes& axes) {
  if (body.shape == nullptr || body.shape->kind >= Shape::Kind::kHull) return "box";
  if (body.shape->kind == Shape::Kind::kSphere) return "sphere";
  const char* word = body.shape->kind == Shape::Kind::kCapsule ? "capsule-" : "cylinder-";
  return word + std::string(1, axes.along(body.shape->axis).letter);
}

std::string left_out_values(std::uint64_t count) {
  return count_text(count, "value") + " of channels whose body is absent in the step: a table has no row";
}

std::vector<std::string> left_out_of_tables(const ExportPlan& plan) {
  std::vector<std::string> left_out;
  const EngineAxes axes = plan.header.axes();
  if (axes.metres != 1) left_out.push_back("the unit of length " + axes.unit() + ": lengths are in m");
  for (const Channel& channel : plan.header.declared.channels) {
    if (!fits_column(channel.unit)) left_out.push_back("the unit of channel " + channel.name);
    if (channel.type.kind == ChannelKind::kBytes) {
      left_out.push_back("the kind of channel " + channel.name + ": its bytes are text in hexadecimal");
    }
  }
  if (std::ranges::any_of(plan.bodies, [](const ExportBody& body) {
        return body.shape != nullptr && body.shape->kind >= Shape::Kind::kHull;
      })) {
    left_out.emplace_back("hulls and meshes: a table has the boxes around them");
  }
  left_out.emplace_back("title, category, light and text of the scene, and the material of the ground");
  if (!plan.header.engine) left_out.emplace_back("the method and its parameters: `import` makes the log of an engine");
  left_out.emplace_back("inputs, phase hashes, counters, contacts, notes and snapshots");
  return left_out;
}

}  // namespace tumble::replay
