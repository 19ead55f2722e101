#include "replay/diff/world_difference.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "replay/diff/parameters.h"
#include "replay/format/little_endian.h"
#include "tumble/replay/body_states.h"

namespace tumble::replay {
namespace {

FieldValue property_value(double value) { return value; }
FieldValue property_value(bool value) { return std::uint64_t{value}; }
FieldValue property_value(std::uint8_t value) { return std::uint64_t{value}; }
FieldValue property_value(std::uint16_t value) { return std::uint64_t{value}; }
FieldValue property_value(std::uint32_t value) { return std::uint64_t{value}; }
FieldValue property_value(std::uint64_t value) { return value; }
FieldValue property_value(sim::Method value) { return std::string(name_of(value)); }

bool equal_bits(double a, double b) { return bits_of(a) == bits_of(b); }
template <class Value>
bool equal_bits(Value a, Value b) {
  return a == b;
}

class WorldWalk {
 public:
  WorldWalk(const sim::WorldState& expected, const sim::WorldState& actual) : expected_(expected), actual_(actual) {}

  std::optional<Divergence> run(const WorldParts& parts) {
    if (parts.built) compare_parameters();
    if (!found_ && (parts.visible || parts.built)) compare_ids();
    if (!found_ && expected_.bodies.id != actual_.bodies.id) return std::nullopt;  // rows cannot be matched
    if (parts.built) compare_built();
    if (parts.visible && !found_) compare_visible();
    if (parts.hidden) compare_hidden();
    return std::move(found_);
  }

 private:
  void set(std::string field, FieldValue expected, FieldValue actual) {
    found_.emplace();
    found_->step = expected_.step;
    found_->phase = "start";
    found_->field = std::move(field);
    found_->expected = std::move(expected);
    found_->actual = std::move(actual);
    const auto* a = std::get_if<double>(&found_->expected);
    const auto* b = std::get_if<double>(&found_->actual);
    if (a != nullptr && b != nullptr) found_->ulps = ulps_between(*a, *b);
  }

  template <class Value>
  void value(const char* field, Value a, Value b) {
    if (!found_ && !equal_bits(a, b)) set(field, property_value(a), property_value(b));
  }

  /// The hash of a state does not tell the two zeros of gravity apart, so neither does this comparison.
  void compare_parameters() {
    sim::WorldDef a = expected_.def, b = actual_.def;
    a.gravity = sim::plus_zero(a.gravity);
    b.gravity = sim::plus_zero(b.gravity);
    std::vector<FieldValue> values;
    for_each_parameter(a, [&](const char*, const auto& v) { values.push_back(property_value(v)); });
    std::size_t next = 0;
    for_each_parameter(b, [&](const char* name, const auto& v) {
      const FieldValue& wanted = values[next++];
      if (!found_ && !same_bits(wanted, property_value(v))) set(name, wanted, property_value(v));
    });
  }

  void compare_ids() {
    BodyStates a, b;
    a.id = expected_.bodies.id;
    b.id = actual_.bodies.id;
    if (a.id == b.id) return;
    const std::size_t shorter = std::min(a.id.size(), b.id.size());
    std::size_t i = 0;
    while (i < shorter && a.id[i] == b.id[i]) ++i;
    const auto text = [i](const std::vector<sim::BodyId>& ids) {
      return i < ids.size() ? FieldValue(std::uint64_t{ids[i]}) : FieldValue(std::string("no such body"));
    };
    set("id", text(a.id), text(b.id));
    found_->body = std::min(i < a.id.size() ? a.id[i] : sim::kBodyIdMax, i < b.id.size() ? b.id[i] : sim::kBodyIdMax);
  }

  /// A column with a row a body: the first row that differs.
  template <class Value>
  void column(const char* field, const std::vector<Value>& a, const std::vector<Value>& b) {
    if (found_) return;
    const std::size_t rows = std::min({a.size(), b.size(), expected_.bodies.size()});
    for (std::size_t i = 0; i < rows; ++i) {
      if (equal_bits(a[i], b[i])) continue;
      set(field, property_value(a[i]), property_value(b[i]));
      found_->body = expected_.bodies.id[i];
      return;
    }
  }
  void column(const std::string& field, const sim::Vec3Column& a, const sim::Vec3Column& b) {
    column((field + ".x").c_str(), a.x, b.x);
    column((field + ".y").c_str(), a.y, b.y);
    column((field + ".z").c_str(), a.z, b.z);
  }

  void compare_built() {
    const sim::Bodies &a = expected_.bodies, &b = actual_.bodies;
    column("static", a.is_static, b.is_static);
    column("half_extent", a.half_extent, b.half_extent);
    column("mass", a.mass, b.mass);
    column("inverse_mass", a.inverse_mass, b.inverse_mass);
    column("inertia", a.inertia, b.inertia);
    column("inverse_inertia", a.inverse_inertia, b.inverse_inertia);
    column("friction", a.friction, b.friction);
    column("friction_dynamic", a.friction_dynamic, b.friction_dynamic);
    column("restitution", a.restitution, b.restitution);
  }

  void compare_visible() {
    BodyStates a, b;
    copy_visible(expected_.bodies, a);
    copy_visible(actual_.bodies, b);
    if (same_bits(a, b)) return;
    found_ = first_difference(a, b);
    if (!found_) return;
    found_->step = expected_.step;
    found_->phase = "start";
  }

  /// A list of any length: its size, then the first entry that differs.
  template <class Value>
  void list(const std::string& field, const std::vector<Value>& a, const std::vector<Value>& b) {
    value((field + " count").c_str(), std::uint64_t{a.size()}, std::uint64_t{b.size()});
    for (std::size_t i = 0; i < a.size() && !found_; ++i) {
      if (!equal_bits(a[i], b[i])) set(field + ' ' + std::to_string(i), property_value(a[i]), property_value(b[i]));
    }
  }

  void compare_hidden() {
    column("low_energy_time", expected_.bodies.low_energy_time, actual_.bodies.low_energy_time);
    const auto& [step_a, def_a, bodies_a, pairs_a, objects_a, memory_a] = expected_;
    const auto& [step_b, def_b, bodies_b, pairs_b, objects_b, memory_b] = actual_;
    list("pairs.a", pairs_a.a, pairs_b.a);
    list("pairs.b", pairs_a.b, pairs_b.b);
    list("pairs.planes", pairs_a.planes, pairs_b.planes);
    list("contact_objects.body", objects_a.body, objects_b.body);
    list("contact_objects.object", objects_a.object, objects_b.object);
    list("contact_memory.a", memory_a.a, memory_b.a);
    list("contact_memory.b", memory_a.b, memory_b.b);
    list("contact_memory.count", memory_a.count, memory_b.count);
    list("contact_memory.feature", memory_a.feature, memory_b.feature);
    list("contact_memory.friction.x", memory_a.friction.x, memory_b.friction.x);
    list("contact_memory.friction.y", memory_a.friction.y, memory_b.friction.y);
    list("contact_memory.friction.z", memory_a.friction.z, memory_b.friction.z);
    list("contact_memory.twist", memory_a.twist, memory_b.twist);
    list("contact_memory.impulse", memory_a.impulse, memory_b.impulse);
  }

  const sim::WorldState& expected_;
  const sim::WorldState& actual_;
  std::optional<Divergence> found_;
};

}  // namespace

std::optional<Divergence> world_difference(const sim::WorldState& expected, const sim::WorldState& actual,
                                           const WorldParts& parts) {
  return WorldWalk(expected, actual).run(parts);
}

}  // namespace tumble::replay
