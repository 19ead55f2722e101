#include "replay/diff/world_difference.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "replay/diff/parameters.h"
#include "replay/format/little_endian.h"
#include "tumble/replay/body_states.h"

namespace tumble::replay {
namespace {

bool equal_bits(double a, double b) { return bits_of(a) == bits_of(b); }
template <class Value>
bool equal_bits(Value a, Value b) {
  return a == b;
}

class WorldWalk {
 public:
  WorldWalk(const sim::WorldState& expected, const sim::WorldState& actual) : expected_(expected), actual_(actual) {}

  std::optional<Divergence> run(const WorldParts& parts) {
    compare_parameters();
    if (!found_) set(different_ids(expected_.bodies.id, actual_.bodies.id));
    if (expected_.bodies.id != actual_.bodies.id) return std::move(found_);  // rows cannot be matched
    compare_built();
    if (parts.visible && !found_) compare_visible();
    if (parts.hidden) compare_hidden();
    return std::move(found_);
  }

 private:
  void set(std::string field, FieldValue expected, FieldValue actual) {
    found_ = make_divergence(expected_.step, "start", std::move(field), std::move(expected), std::move(actual));
  }
  void set(std::optional<Divergence> found) {
    found_ = std::move(found);
    if (!found_) return;
    found_->step = expected_.step;
    found_->phase = "start";
  }

  template <class Value>
  void value(const char* field, Value a, Value b) {
    if (!found_ && !equal_bits(a, b)) set(field, field_value(a), field_value(b));
  }

  void compare_parameters() {
    const NamedValues a = parameters_of(expected_.def), b = parameters_of(actual_.def);
    for (std::size_t k = 0; k < a.size() && !found_; ++k) {
      if (!same_bits(a[k].second, b[k].second)) set(a[k].first, a[k].second, b[k].second);
    }
  }

  /// A column with a row a body: the first row that differs.
  template <class Value>
  void column(const char* field, const std::vector<Value>& a, const std::vector<Value>& b) {
    if (found_) return;
    const std::size_t rows = std::min({a.size(), b.size(), expected_.bodies.size()});
    for (std::size_t i = 0; i < rows; ++i) {
      if (equal_bits(a[i], b[i])) continue;
      set(field, field_value(a[i]), field_value(b[i]));
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
    if (same_visible_bits(expected_.bodies, actual_.bodies)) return;
    BodyStates a, b;
    copy_visible(expected_.bodies, a);
    copy_visible(actual_.bodies, b);
    set(first_difference(a, b));
  }

  /// A list of any length: its size, then the first entry that differs.
  template <class Value>
  void list(const std::string& field, const std::vector<Value>& a, const std::vector<Value>& b) {
    value((field + " count").c_str(), std::uint64_t{a.size()}, std::uint64_t{b.size()});
    for (std::size_t i = 0; i < a.size() && !found_; ++i) {
      if (!equal_bits(a[i], b[i])) set(field + ' ' + std::to_string(i), field_value(a[i]), field_value(b[i]));
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

std::optional<Divergence> keyframe_difference(const sim::WorldState& expected, const Hash128& expected_hash,
                                              const sim::WorldState& actual, const Hash128& actual_hash,
                                              const WorldParts& parts) {
  std::optional<Divergence> found = world_difference(expected, actual, parts);
  if (found || !parts.visible || !parts.hidden || expected_hash == actual_hash) return found;
  return make_divergence(expected.step, "start", "continuation_hash", to_string(expected_hash), to_string(actual_hash));
}

}  // namespace tumble::replay
