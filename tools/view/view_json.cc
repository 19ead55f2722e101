#include "tools/view/view_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <variant>

#include "replay/view/step_gaps.h"
#include "src/base/text.h"
#include "tools/output/divergence_output.h"
#include "tumble/replay/body_states.h"

namespace tumble::tools {
namespace {

constexpr int kDigits = 7;

Json vector_json(const sim::Vec3& v) { return {short_json(v.x()), short_json(v.y()), short_json(v.z())}; }

/// null in a row that was not read: a count of nothing would be taken for one that was seen.
template <class Row, class Member>
Json column(std::span<const Row> rows, Member member) {
  Json numbers = Json::array();
  for (const Row& row : rows) {
    if (!row.read) {
      numbers.push_back(nullptr);
    } else if constexpr (std::is_floating_point_v<std::decay_t<decltype(row.*member)>>) {
      numbers.push_back(exact_json(row.*member));
    } else {
      numbers.push_back(row.*member);
    }
  }
  return numbers;
}

/// By channel: its values.
Json channels_json(std::span<const replay::TimelineRow> rows) {
  std::size_t count = 0;
  for (const replay::TimelineRow& row : rows) count = std::max(count, row.channels.size());
  Json channels = Json::array();
  for (std::size_t c = 0; c < count; ++c) {
    Json values = Json::array();
    for (const replay::TimelineRow& row : rows) {
      values.push_back(c < row.channels.size() ? exact_json(row.channels[c]) : Json(nullptr));
    }
    channels.push_back(std::move(values));
  }
  return channels;
}

/// An infinite value is told: a bound may be broken by it.
Json bound_value_json(double value) { return std::isinf(value) ? exact_json(value) : short_json(value); }

/// By bound: its values, and 1 for each step up to which it is broken; null where it is not judged.
Json bounds_json(std::span<const replay::TimelineRow> rows) {
  std::size_t count = 0;
  for (const replay::TimelineRow& row : rows) count = std::max(count, row.bounds.size());
  Json bounds = Json::array();
  for (std::size_t b = 0; b < count; ++b) {
    Json values = Json::array(), broken = Json::array();
    for (const replay::TimelineRow& row : rows) {
      const bool judged = b < row.bounds.size() && row.bounds[b].judged;
      values.push_back(judged && row.bounds[b].value ? bound_value_json(*row.bounds[b].value) : Json(nullptr));
      broken.push_back(judged ? Json(row.bounds[b].holds ? 0 : 1) : Json(nullptr));
    }
    bounds.push_back({{"value", values}, {"broken", broken}});
  }
  return bounds;
}

Json shape_json(const replay::Shape& shape) {
  using Kind = replay::Shape::Kind;
  static const std::map<Kind, const char*> kNames = {{Kind::kSphere, "sphere"},
                                                     {Kind::kCapsule, "capsule"},
                                                     {Kind::kCylinder, "cylinder"},
                                                     {Kind::kHull, "hull"},
                                                     {Kind::kMesh, "mesh"}};
  Json points = Json::array();
  for (const sim::Vec3& point : shape.points) {
    for (int c = 0; c < 3; ++c) points.push_back(short_json(point[c]));
  }
  const auto name = kNames.find(shape.kind);
  return {{"kind", name == kNames.end() ? "box" : name->second},
          {"axis", shape.axis},
          {"radius", short_json(shape.radius)},
          {"half_length", short_json(shape.half_length)},
          {"points", points},
          {"triangles", shape.triangles},
          {"words", to_string(shape)}};
}

std::string vector_text(const sim::Vec3& v, const char* unit) {
  return significant(v.x(), 4) + ", " + significant(v.y(), 4) + ", " + significant(v.z(), 4) + ' ' + unit;
}

std::string input_text(const sim::Command& input) {
  if (const auto* thrown = std::get_if<sim::Throw>(&input)) {
    return significant(thrown->box.mass, 4) + " kg at " + vector_text(thrown->box.velocity, "m/s");
  }
  if (const auto* push = std::get_if<sim::Push>(&input)) return vector_text(push->impulse, "N s");
  if (const auto* set = std::get_if<sim::SetVelocity>(&input)) return vector_text(set->velocity, "m/s");
  if (const auto* gravity = std::get_if<sim::SetGravity>(&input)) return vector_text(gravity->gravity, "m/s²");
  if (const auto* dt = std::get_if<sim::SetDt>(&input)) return seconds_text(dt->dt);
  return "";
}

Json input_body(const sim::Command& input) {
  return std::visit(
      [](const auto& one) -> Json {
        if constexpr (requires { one.box.id; }) {
          return one.box.id;
        } else if constexpr (requires { one.id; }) {
          return one.id;
        } else {
          return nullptr;
        }
      },
      input);
}

}  // namespace

Json exact_json(double value) {
  if (std::isnan(value)) return nullptr;
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  return value;
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json short_json(double value) {
  if (!std::isfinite(value)) return nullptr;
  return parse_exact(significant(value, kDigits)).value_or(value);
}

Json head_json(const replay::LogReader& log) {
  const replay::LogHeader& header = log.header();
  const sim::SceneDef& scene = header.scene;
  const replay::LogCondition& condition = log.condition();
  Json gaps = Json::array();
  for (const replay::StepGap& gap : replay::step_gaps(log)) gaps.push_back({gap.first, gap.last, gap.why});
  Json channels = Json::array();
  constexpr std::array kScopes = {"step", "bodies", "pairs"};
  for (const std::size_t c : replay::channel_columns(header)) {
    const replay::Channel& channel = header.declared.channels[c];
    channels.push_back({{"name", printable(channel.name)},
                        {"unit", printable(channel.unit)},
                        {"of", kScopes[static_cast<std::size_t>(channel.type.scope)]}});
  }
  return {{"channels", channels},
          {"path", printable(log.name())},
          {"name", printable(scene.name)},
          {"title", printable(scene.title)},
          {"method", header.method + ' ' + std::to_string(header.method_version)},
          {"engine", header.engine ? Json(printable(to_string(*header.engine))) : Json(nullptr)},
          {"ours", !header.engine},
          {"blames", !header.engine},
          {"counts_collisions", !header.engine && scene.world.method == sim::Method::kThesis},
          {"summary", printable(condition.summary(log.last_step()))},
          {"finished", condition.finished},
          {"sound", condition.sound()},
          {"cut_short", printable(header.declared.cut_short)},
          {"first", log.first_state()},
          {"last", log.last_step()},
          {"dt", scene.world.dt},
          {"ground", scene.world.ground},
          {"camera", {{"position", vector_json(scene.camera.position)}, {"target", vector_json(scene.camera.target)}}},
          {"axes", header.axes().ours() ? Json(nullptr) : Json(printable(to_string(header.axes())))},
          {"gaps", gaps}};
}

Json bodies_json(const replay::ViewedBodies& table) {
  Json ids = Json::array(), sizes = Json::array(), fixed = Json::array(), textures = Json::array();
  Json origins = Json::array();
  for (const replay::ViewedBody& body : table.bodies()) {
    ids.push_back(body.id);
    for (const double edge : {body.size.x(), body.size.y(), body.size.z()}) sizes.push_back(short_json(edge));
    fixed.push_back(body.is_static ? 1 : 0);
    textures.push_back(static_cast<int>(body.texture));
    origins.push_back(static_cast<int>(body.origin.kind));
    for (const std::uint32_t place : {body.origin.table, body.origin.row, body.origin.column}) origins.push_back(place);
  }
  Json names = Json::object(), shape_of = Json::object(), shapes = Json::array();
  std::map<const replay::Shape*, std::size_t> known;
  for (std::size_t row = 0; row < table.bodies().size(); ++row) {
    const sim::BodyId id = table.bodies()[row].id;
    if (const std::string name = table.infos().name(id); !name.empty()) names[std::to_string(row)] = printable(name);
    const replay::Shape* shape = table.infos().shape(id);
    if (shape == nullptr) continue;
    const auto [place, is_new] = known.try_emplace(shape, known.size());
    if (is_new) shapes.push_back(shape_json(*shape));
    shape_of[std::to_string(row)] = place->second;
  }
  return {{"name", names}, {"shape", shape_of}, {"shapes", shapes},    {"version", table.version()}, {"id", ids},
          {"size", sizes}, {"static", fixed},   {"texture", textures}, {"origin", origins}};
}

Json timeline_json(std::span<const replay::TimelineRow> rows) {
  using Row = replay::TimelineRow;
  Json read = Json::array(), step = Json::array(), time = Json::array();
  for (const Row& row : rows) {
    read.push_back(row.read ? 1 : 0);
    step.push_back(row.step);
    time.push_back(short_json(row.time));
  }
  return {{"step", step},
          {"time", time},
          {"read", read},
          {"kinetic", column(rows, &Row::kinetic)},
          {"potential", column(rows, &Row::potential)},
          {"inputs", column(rows, &Row::inputs)},
          {"contacts", column(rows, &Row::contacts)},
          {"bodies", column(rows, &Row::bodies)},
          {"sleeping", column(rows, &Row::frozen)},
          {"lost", column(rows, &Row::not_finite)},
          {"speed", column(rows, &Row::speed_max)},
          {"speed_body", column(rows, &Row::speed_body)},
          {"height", column(rows, &Row::height_max)},
          {"overlap", column(rows, &Row::overlap)},
          {"channels", channels_json(rows)},
          {"bounds", bounds_json(rows)}};
}

Json inputs_json(std::span<const replay::TimelineInput> inputs) {
  Json rows = Json::array();
  for (const replay::TimelineInput& one : inputs) {
    rows.push_back({{"step", one.step},
                    {"kind", sim::name_of(one.input)},
                    {"body", input_body(one.input)},
                    {"text", input_text(one.input)}});
  }
  return rows;
}

Json history_json(std::uint64_t from, std::span<const replay::BodyMoment> history) {
  Json json = {{"next", history.empty() ? from : history.back().step + 1}};
  for (const char* name : {"step", "x", "y", "z", "speed", "spin", "asleep"}) json[name] = Json::array();
  for (const replay::BodyMoment& moment : history) {
    json["step"].push_back(moment.step);
    const auto add = [&](const char* name, double value) {
      json[name].push_back(moment.shown ? exact_json(value) : Json(nullptr));
    };
    add("x", moment.position.x());
    add("y", moment.position.y());
    add("z", moment.position.z());
    add("speed", moment.speed);
    add("spin", moment.spin);
    add("asleep", moment.frozen ? 1 : 0);
  }
  return json;
}

Json contact_rows_json(std::span<const replay::ContactPoint> points) {
  Json rows = Json::array();
  for (const replay::ContactPoint& point : points) {
    Json row = {point.a, point.b.value_or(0)};
    for (const sim::Vec3& v : {point.at, point.normal}) {
      for (int c = 0; c < 3; ++c) row.push_back(short_json(v[c]));
    }
    row.push_back(short_json(point.depth));
    row.push_back(short_json(point.impulse));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace tumble::tools
