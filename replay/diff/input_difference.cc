#include "replay/diff/input_difference.h"

#include <algorithm>
#include <cstdint>
#include <variant>

#include "replay/diff/parameters.h"
#include "src/model/command_fields.h"

namespace tumble::replay {
namespace {

/// The body that an input acts on.
std::optional<sim::BodyId> body_of(const NamedValues& values) {
  const auto id = std::ranges::find(values, sim::field::Id::kName, &NamedValues::value_type::first);
  return id == values.end() ? std::nullopt : std::optional(std::get<std::uint64_t>(id->second));
}

std::string names_of(std::span<const sim::Command> inputs) {
  std::string names;
  for (const sim::Command& input : inputs) {
    names += (names.empty() ? "" : ", ") + std::string(sim::name_of(input));
    if (const sim::BodyId body = body_of(values_of(input)).value_or(0); body != 0)
      names += " body " + std::to_string(body);
  }
  return names.empty() ? "none" : names;
}

/// Compares the values that change what happens; the chain covers the same ones (chain.cc).
std::optional<InputDifference> first_difference(const sim::Command& expected, const sim::Command& actual) {
  const NamedValues a = values_of(expected), b = values_of(actual);
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const auto& [name, value] = a[i];
    if (same_bits(value, b[i].second)) continue;
    InputDifference found{std::string(sim::name_of(expected)) + "." + name, {}, value, b[i].second};
    if (body_of(a) == body_of(b)) found.body = body_of(a);
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
