#include "python/binding/values.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "python/binding/arrays.h"
#include "python/binding/raise.h"
#include "src/base/text.h"
#include "src/model/command_fields.h"

namespace tumble::python {
namespace {

namespace field = sim::field;
namespace role = sim::role;

py::object to_object(sim::BodyId value) { return py::int_(value); }
py::object to_object(double value) { return py::float_(value); }
py::object to_object(bool value) { return py::bool_(value); }
py::object to_object(const sim::Vec3& value) { return tuple_of(value); }
py::object to_object(const sim::Quat& value) { return tuple_of(value); }
py::object to_object(sim::Texture value) { return py::str(name_of(value)); }
py::object to_object(const sim::Origin& value) {
  return py::make_tuple(name_of(value.kind), value.table, value.row, value.column);
}

void from_object(const py::handle& object, const char* name, sim::BodyId& value) { value = whole_of(object, name); }
void from_object(const py::handle& object, const char* name, double& value) { value = double_of(object, name); }
void from_object(const py::handle& object, const char* name, bool& value) { value = flag_of(object, name); }
void from_object(const py::handle& object, const char* name, sim::Vec3& value) { value = vec3_of(object, name); }
void from_object(const py::handle& object, const char* name, sim::Quat& value) { value = quat_of(object, name); }
void from_object(const py::handle& object, const char* name, sim::Texture& value) {
  const std::string word = text_of(object, name);
  constexpr const auto& kNames = sim::kTextureNames;
  const auto* const found = std::ranges::find(kNames, std::string_view(word));
  if (found == kNames.end()) {
    raise(
        bad_input(std::string(name) + ": " + found_wanted(in_quotes(word), list_text({kNames.begin(), kNames.end()}))));
  }
  value = static_cast<sim::Texture>(found - kNames.begin());
}
void from_object(const py::handle& /*object*/, const char* /*name*/, sim::Origin& /*value*/) {}  // the origin is ours

/// Visits the fields of a struct, those of its parts among them.
template <class Struct, class Visit>
void for_each_leaf(Struct& part, const Visit& visit) {
  sim::for_each_field(part, [&](auto tag, auto& value) {
    if constexpr (std::derived_from<decltype(tag), role::Part>) {
      for_each_leaf(value, visit);
    } else {
      visit(decltype(tag)::kName, value);
    }
  });
}

template <class Struct>
void fill_dict(const Struct& part, py::dict& fields) {
  for_each_leaf(part, [&](const char* name, const auto& value) { fields[name] = to_object(value); });
}

/// Fails for a key that is not among `known`.
void refuse_unknown(const py::dict& fields, const std::string& of, const std::vector<std::string_view>& known) {
  for (const auto& [key, value] : fields) {
    const std::string name = text_of(key, "key");
    if (name == "origin" || std::ranges::find(known, std::string_view(name)) != known.end()) continue;  // ours
    const std::string_view nearest = nearest_word(name, known);
    std::string what = of + ": " + found_wanted(in_quotes(name), list_text(known));
    if (!nearest.empty()) what.append("; did you mean ").append(nearest).append("?");
    raise(bad_input(what));
  }
}

template <class Struct>
void fill_struct(const py::dict& fields, const std::string& of, Struct& part, std::vector<std::string_view> known) {
  for_each_leaf(part, [&](const char* name, auto& value) {
    if (std::string_view(name) != "origin") known.emplace_back(name);
    if (fields.contains(name)) from_object(fields[name], name, value);
  });
  refuse_unknown(fields, of, known);
}

template <std::size_t kIndex = 0>
sim::Command command_at(std::size_t index) {
  if constexpr (kIndex + 1 < std::variant_size_v<sim::Command>) {
    if (index != kIndex) return command_at<kIndex + 1>(index);
  }
  return std::variant_alternative_t<kIndex, sim::Command>{};
}

constexpr std::array kShapeKinds = {"sphere", "capsule", "cylinder", "hull", "mesh"};

}  // namespace

py::dict dict_of(const sim::Command& command) {
  py::dict fields;
  fields["kind"] = sim::name_of(command);
  std::visit([&](const auto& input) { fill_dict(input, fields); }, command);
  return fields;
}

py::dict dict_of(const sim::BoxDef& box) {
  py::dict fields;
  fill_dict(box, fields);
  return fields;
}

py::dict dict_of(const replay::LogSummary& summary) {
  py::dict fields;
  fields["steps"] = summary.steps;
  fields["bytes"] = summary.bytes;
  fields["final_hash"] = to_string(summary.final_hash);
  fields["chain"] = to_string(summary.chain);
  return fields;
}

sim::Command command_of(const py::dict& fields) {
  const std::string kind = fields.contains("kind") ? text_of(fields["kind"], "kind") : "";
  const auto* const found = std::ranges::find(sim::kCommandNames, std::string_view(kind));
  if (found == sim::kCommandNames.end()) {
    raise(bad_input("input: kind: " +
                    found_wanted(in_quotes(kind), list_text({sim::kCommandNames.begin(), sim::kCommandNames.end()}))));
  }
  sim::Command command = command_at(static_cast<std::size_t>(found - sim::kCommandNames.begin()));
  std::visit([&](auto& input) { fill_struct(fields, kind, input, {"kind"}); }, command);
  return command;
}

sim::BoxDef box_of(const py::dict& fields) {
  sim::BoxDef box;
  fill_struct(fields, "body", box, {"name", "shape"});
  return box;
}

py::dict dict_of(const replay::Shape& shape) {
  py::dict fields;
  fields["kind"] = kShapeKinds.at(static_cast<std::size_t>(shape.kind) - 1);
  if (!shape.points.empty()) {
    std::vector<double> points;
    for (const sim::Vec3& point : shape.points) points.insert(points.end(), point.data(), point.data() + 3);
    fields["points"] = array_of(std::move(points), {static_cast<py::ssize_t>(shape.points.size()), 3});
    if (!shape.triangles.empty()) {
      fields["triangles"] = array_of(shape.triangles, {static_cast<py::ssize_t>(shape.triangles.size() / 3), 3});
    }
    return fields;
  }
  fields["radius"] = shape.radius;
  if (shape.kind == replay::Shape::Kind::kSphere) return fields;
  fields["axis"] = py::str(std::string(1, "xyz"[std::min<std::size_t>(shape.axis, 2)]));
  fields["half_length"] = shape.half_length;
  return fields;
}

replay::Shape shape_of(const py::dict& fields) {
  refuse_unknown(fields, "shape", {"kind", "radius", "axis", "half_length", "points", "triangles"});
  replay::Shape shape;
  const std::string kind = fields.contains("kind") ? text_of(fields["kind"], "shape: kind") : "";
  const auto* const found = std::ranges::find(kShapeKinds, std::string_view(kind));
  if (found == kShapeKinds.end()) {
    raise(bad_input("shape: kind: " +
                    found_wanted(in_quotes(kind), list_text({kShapeKinds.begin(), kShapeKinds.end()}))));
  }
  shape.kind = static_cast<replay::Shape::Kind>(found - kShapeKinds.begin() + 1);
  if (fields.contains("radius")) shape.radius = double_of(fields["radius"], "shape: radius");
  if (fields.contains("half_length")) shape.half_length = double_of(fields["half_length"], "shape: half_length");
  if (fields.contains("axis")) {
    const std::string axis = text_of(fields["axis"], "shape: axis");
    const std::size_t at = std::string_view("xyz").find(axis);
    if (axis.size() != 1 || at == std::string_view::npos) {
      raise(bad_input("shape: axis: " + found_wanted(in_quotes(axis), "x, y or z")));
    }
    shape.axis = static_cast<std::uint8_t>(at);
  }
  if (fields.contains("points")) {
    const std::vector<double> points = doubles_of(fields["points"], "shape: points", py::len(fields["points"]), 3);
    for (std::size_t i = 0; i < points.size(); i += 3)
      shape.points.emplace_back(points[i], points[i + 1], points[i + 2]);
  }
  if (fields.contains("triangles")) {
    for (const py::handle& triangle : fields["triangles"]) {
      if (py::len(triangle) != 3) raise(bad_input("shape: triangles: wanted three indices each"));
      for (const py::handle& corner : triangle) {
        const std::uint64_t index = whole_of(corner, "shape: triangles");
        if (index > UINT32_MAX) raise(bad_input("shape: triangles: found an index of no point"));
        shape.triangles.push_back(static_cast<std::uint32_t>(index));
      }
    }
  }
  return shape;
}

}  // namespace tumble::python
