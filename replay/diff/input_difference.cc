#include "replay/diff/input_difference.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace tumble::replay {
namespace {

/// The fields of an input by name, its body first: those that the chain hashes (chain.cc).
class Fields {
 public:
  explicit Fields(const sim::Command& command) { std::visit(*this, command); }

  void operator()(const sim::Throw& c) {
    const sim::BoxDef& box = c.box;
    add_body(box.id);
    add("size", box.size);
    add("mass", box.mass);
    add("static", std::uint64_t{box.is_static});
    add("position", box.position);
    add("orientation.w", box.orientation.w);
    add("orientation.x", box.orientation.x);
    add("orientation.y", box.orientation.y);
    add("orientation.z", box.orientation.z);
    add("velocity", box.velocity);
    add("spin", box.spin);
    add("friction", box.material.friction);
    add("friction_dynamic", box.material.friction_dynamic);
    add("restitution", box.material.restitution);
    add("frozen", std::uint64_t{box.frozen});
  }
  void operator()(const sim::Push& c) {
    add_body(c.id);
    add("impulse", c.impulse);
    add("at_centre", std::uint64_t{c.at_centre});
    if (!c.at_centre) add("at", c.at);
  }
  void operator()(const sim::Remove& c) { add_body(c.id); }
  void operator()(const sim::Wake& c) { add_body(c.id); }
  void operator()(const sim::SetVelocity& c) {
    add_body(c.id);
    add("velocity", c.velocity);
    add("spin", c.spin);
  }
  void operator()(const sim::SetGravity& c) { add("gravity", c.gravity); }
  void operator()(const sim::SetDt& c) { add("dt", c.dt); }

  [[nodiscard]] const std::vector<std::pair<std::string, FieldValue>>& list() const { return list_; }
  [[nodiscard]] const std::optional<sim::BodyId>& body() const { return body_; }

 private:
  void add_body(sim::BodyId id) {
    body_ = id;
    add("id", std::uint64_t{id});
  }
  void add(const std::string& name, FieldValue value) { list_.emplace_back(name, std::move(value)); }
  void add(const std::string& name, const sim::Vec3& v) {
    add(name + ".x", v.x());
    add(name + ".y", v.y());
    add(name + ".z", v.z());
  }

  std::vector<std::pair<std::string, FieldValue>> list_;
  std::optional<sim::BodyId> body_;
};

std::string names_of(std::span<const sim::Command> inputs) {
  std::string names;
  for (const sim::Command& input : inputs) names += (names.empty() ? "" : ", ") + std::string(sim::name_of(input));
  return names.empty() ? "none" : names;
}

std::optional<InputDifference> first_difference(const sim::Command& expected, const sim::Command& actual) {
  const Fields a(expected), b(actual);
  for (std::size_t i = 0; i < std::min(a.list().size(), b.list().size()); ++i) {
    const auto& [name, value] = a.list()[i];
    if (same_bits(value, b.list()[i].second)) continue;
    InputDifference found{std::string(sim::name_of(expected)) + "." + name, {}, value, b.list()[i].second};
    if (a.body() == b.body()) found.body = a.body();
    return found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<InputDifference> first_difference(std::span<const sim::Command> expected,
                                                std::span<const sim::Command> actual) {
  const bool same_kinds = std::ranges::equal(expected, actual, {}, &sim::Command::index, &sim::Command::index);
  if (!same_kinds) return InputDifference{"inputs", {}, names_of(expected), names_of(actual)};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (auto found = first_difference(expected[i], actual[i])) return found;
  }
  return std::nullopt;
}

}  // namespace tumble::replay
