#include "src/scenes/overrides.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "src/scenes/parse_toml.h"
#include "tumble/sim/scene.h"

namespace tumble::scenes {
namespace {

constexpr std::size_t kPathMax = 6;  // parts of a --set key

struct Exclusion {
  std::string_view key;
  std::string_view other;
};
constexpr Exclusion kExclusions[] = {
    {"steps", "seconds"},    {"seconds", "steps"},       {"mass", "density"},     {"density", "mass"},
    {"orientation", "axis"}, {"orientation", "degrees"}, {"axis", "orientation"}, {"degrees", "orientation"},
    {"step", "time"},        {"time", "step"},
};

Error argument_error(std::string_view argument, std::string_view message) {
  return bad_input("--set " + shortened(argument) + ": " + std::string(message));
}

bool is_bare_key(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

// A bare word is taken as a text: --set world.method=layered needs no quotes within the shell's own.
bool is_bare_word(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return is_bare_key({&c, 1}) || c == '.' || c == '/' || c == ' ';
  });
}

std::optional<std::size_t> as_index(std::string_view part) {
  if (part.empty() || part.size() > 9) return std::nullopt;
  std::size_t value = 0;
  for (char c : part) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + static_cast<std::size_t>(c - '0');
  }
  return value;
}

std::vector<std::string_view> split_path(std::string_view path) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t dot = path.find('.');
    parts.push_back(path.substr(0, dot));
    if (dot == std::string_view::npos || parts.size() > kPathMax) return parts;
    path.remove_prefix(dot + 1);
  }
}

// A table { value = … } that holds the argument's value and carries the argument's text as its source.
std::optional<toml::table> parse_value(std::string_view text, const std::string& source) {
  Problem ignored("");
  std::optional<toml::table> parsed = parse_toml("value = " + std::string(text), source, ignored);
  if (parsed && parsed->size() == 1 && parsed->contains("value")) return parsed;
  if (!is_bare_word(text)) return std::nullopt;
  return parse_toml("value = \"" + std::string(text) + "\"", source, ignored);
}

// Moves the value out of such a table; its source goes with it.
void insert_value(toml::table& table, std::string_view key, toml::table& parsed) {
  parsed.get("value")->visit([&](auto& node) { table.insert_or_assign(key, std::move(node)); });
}

void remove_excluded(toml::table& table, std::string_view key) {
  for (const Exclusion& exclusion : kExclusions) {
    if (exclusion.key != key) continue;
    const toml::node* other = table.get(exclusion.other);
    if (other && !Place(other->source()).is_override()) table.erase(exclusion.other);
  }
}

// One step along the path of a key: into the table `part` of `table`, made if it is not there, or into the element of
// an array of tables that the next part counts (the first one if it does not count).
struct Walk {
  toml::table* table;
  std::size_t next = 0;  // part
};
Result<Walk> descend(Walk walk, const std::vector<std::string_view>& parts, const std::string& source) {
  const std::string_view part = parts[walk.next++];
  if (!walk.table->contains(part)) {
    toml::table empty = *parse_value("{}", source);
    insert_value(*walk.table, part, empty);
  }
  toml::node* node = walk.table->get(part);
  if (toml::table* inner = node->as_table()) return Walk{inner, walk.next};

  const std::string name = "[[" + std::string(part) + "]]";
  toml::array* array = node->as_array();
  if (!array || !array->is_array_of_tables()) {
    return bad_input("found no table " + in_quotes(part) + ", wanted one to set a key in");
  }
  const std::optional<std::size_t> index = as_index(parts[walk.next]);
  if (index) ++walk.next;
  const std::size_t wanted = index.value_or(1);
  if (walk.next == parts.size()) return bad_input("found a table, wanted a key of " + name + " after its number");
  if (wanted < 1 || wanted > array->size()) {
    return bad_input("found number " + std::to_string(wanted) + ", wanted 1 to " + std::to_string(array->size()) +
                     ": the scene has that many " + name);
  }
  return Walk{array->get(wanted - 1)->as_table(), walk.next};
}

// The kinds of tables that come as arrays: a key in one that the scene does not have makes no sense.
bool is_array_name(std::string_view name) {
  return std::find(sim::kOriginNames.begin(), sim::kOriginNames.end(), name) != sim::kOriginNames.end();
}

}  // namespace

Status apply_override(toml::table& root, std::string_view argument) {
  const std::string source = "--set " + shortened(argument);
  const std::size_t equals = argument.find('=');
  if (equals == std::string_view::npos) {
    return argument_error(argument, "found no \"=\", wanted key=value, such as world.dt=0.01");
  }
  const std::vector<std::string_view> parts = split_path(argument.substr(0, equals));
  if (parts.size() > kPathMax || !std::all_of(parts.begin(), parts.end(), is_bare_key)) {
    return argument_error(argument, "found a strange key, wanted words with dots between, such as grid.2.rows");
  }
  std::optional<toml::table> value = parse_value(argument.substr(equals + 1), source);
  if (!value)
    return argument_error(argument, "found a value that is not TOML, wanted one such as 7, 0.5, [1, 2, 3] or a word");

  if (parts.size() > 1 && is_array_name(parts[0]) && !root.contains(parts[0])) {
    return argument_error(argument,
                          "found no [[" + std::string(parts[0]) + "]] in the scene, wanted one to set a key in");
  }
  Walk walk{&root};
  while (walk.next + 1 < parts.size()) {
    Result<Walk> deeper = descend(walk, parts, source);
    if (!deeper) return argument_error(argument, deeper.error().message);
    walk = *deeper;
  }
  remove_excluded(*walk.table, parts.back());
  insert_value(*walk.table, parts.back(), *value);
  return {};
}

}  // namespace tumble::scenes
