#include "replay/diff/input_difference.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "src/model/command_fields.h"

namespace tumble::replay {
namespace {

/// The values of an input that change what happens, by name, its body first; the chain covers the same ones (chain.cc).
class Fields {
 public:
  explicit Fields(const sim::Command& command) { sim::for_each_effect(command, *this); }

  void operator()(sim::field::Id tag, sim::BodyId id) {
    body_ = id;
    add(decltype(tag)::kName, id);
  }
  void operator()(auto tag, double value) { add(tag.kName, value); }
  void operator()(auto tag, bool value) { add(tag.kName, std::uint64_t{value}); }
  void operator()(auto tag, const sim::Vec3& v) {
    const std::string name = tag.kName;
    add(name + ".x", v.x());
    add(name + ".y", v.y());
    add(name + ".z", v.z());
  }
  void operator()(auto tag, const sim::Quat& q) {
    const std::string name = tag.kName;
    add(name + ".w", q.w);
    add(name + ".x", q.x);
    add(name + ".y", q.y);
    add(name + ".z", q.z);
  }

  [[nodiscard]] const std::vector<std::pair<std::string, FieldValue>>& list() const { return list_; }
  [[nodiscard]] const std::optional<sim::BodyId>& body() const { return body_; }

 private:
  void add(const std::string& name, FieldValue value) { list_.emplace_back(name, std::move(value)); }

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
