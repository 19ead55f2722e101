#include "replay/export/table/table_frame.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "replay/arrays/pair_cell.h"
#include "replay/format/not_finite.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

std::string triple(const sim::Vec3& v) { return exact(v.x()) + ' ' + exact(v.y()) + ' ' + exact(v.z()); }

/// Whether a unit comes back from behind the name of a column.
bool fits_behind_name(const std::string& unit) {
  const auto wrong = [](char c) { return c == ',' || static_cast<unsigned char>(c) < ' '; };
  return unit.find(" (") == std::string::npos && !unit.starts_with('(') && std::ranges::none_of(unit, wrong);
}

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

std::string channel_column(const Channel& channel) {
  constexpr std::array<const char*, 3> kPrefixes = {"world.", "channel.", "pair."};  // by scope
  return kPrefixes.at(static_cast<std::size_t>(channel.type.scope)) + channel.name;
}

std::string unit_in_column(const Channel& channel) {
  const bool brackets = channel.name.ends_with(')') && channel.name.find(" (") != std::string::npos;
  const std::string unit = fits_behind_name(channel.unit) ? channel.unit : "";
  return unit.empty() && !brackets ? std::string() : " (" + unit + ')';
}

std::string value_cell(const ChannelValue& value, ChannelKind kind) {
  if (const auto* wide = std::get_if<double>(&value)) return number_cell(*wide);
  if (const auto* narrow = std::get_if<float>(&value); narrow != nullptr && std::isinf(*narrow)) {
    return number_cell(*narrow);
  }
  return to_string(value, kind);
}

std::string pair_cell(const ChannelValues& values, ChannelKind kind, std::size_t row) {
  std::string cell;
  const sim::BodyId body = values.keys[row].a;
  for (; row < values.size() && values.keys[row].a == body; ++row) {
    const ChannelValue value = values.value(row, kind);
    const auto* text = std::get_if<std::string>(&value);
    cell += (cell.empty() ? "" : " ") + std::to_string(values.keys[row].b) + '=';
    if (text == nullptr) cell += value_cell(value, kind);
    if (text != nullptr) cell += kind == ChannelKind::kBytes ? hex_digits(*text) : escaped_cell(*text);
  }
  return cell;
}

std::string left_out_values(std::uint64_t count) {
  return count_text(count, "value") + " of channels whose body is absent in the step: a table has no row";
}

std::vector<std::string> left_out_of_tables(const ExportPlan& plan) {
  std::vector<std::string> left_out;
  const EngineAxes axes = plan.header.axes();
  if (axes.metres != 1) left_out.push_back("the unit of length " + axes.unit() + ": lengths are in m");
  for (const Channel& channel : plan.header.declared.channels) {
    if (!fits_behind_name(channel.unit)) left_out.push_back("the unit of channel " + channel.name);
    if (channel.type.kind == ChannelKind::kBytes) {
      left_out.push_back("the kind of channel " + channel.name + ": its bytes are text in hexadecimal");
    }
  }
  if (std::ranges::any_of(plan.bodies, [](const ExportBody& body) {
        return body.shape != nullptr && body.shape->kind >= Shape::Kind::kHull;
      })) {
    left_out.emplace_back("hulls and meshes: a table has the boxes around them");
  }
  left_out.emplace_back("inputs, phase hashes, counters, contacts, notes and snapshots");
  return left_out;
}

std::size_t value_row(const ChannelValues& values, sim::BodyId id, std::size_t& from) {
  while (from < values.size() && values.keys[from].a < id) ++from;
  return from < values.size() && values.keys[from].a == id ? from : values.size();
}

}  // namespace tumble::replay
