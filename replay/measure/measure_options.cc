#include "replay/measure/measure_options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string_view>

namespace tumble::replay {
namespace {

// In the order of sim::Origin::Kind.
constexpr std::array<std::string_view, 7> kTables = {"box", "grid", "tower", "pyramid", "wall", "pile", "input"};

template <class T>
std::optional<T> parse_number(std::string_view text) {
  T value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<BodyChoice::Ids> parse_ids(std::string_view word) {
  const std::size_t dash = word.find('-');
  const auto first = parse_number<sim::BodyId>(word.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parse_number<sim::BodyId>(word.substr(dash + 1));
  if (!first || !last || *first > *last) return std::nullopt;
  return BodyChoice::Ids{*first, *last};
}

std::optional<BodyChoice::Table> parse_table(std::string_view word) {
  const std::size_t colon = word.find(':');
  const auto* const name = std::ranges::find(kTables, word.substr(0, colon));
  if (name == kTables.end()) return std::nullopt;
  BodyChoice::Table table{static_cast<sim::Origin::Kind>(name - kTables.begin()), std::nullopt};
  if (colon == std::string_view::npos) return table;
  table.index = parse_number<std::uint32_t>(word.substr(colon + 1));
  return table.index ? std::optional(table) : std::nullopt;
}

}  // namespace

bool BodyChoice::holds(const sim::BoxDef& box) const {
  const auto in_ids = [&](const Ids& range) { return range.first <= box.id && box.id <= range.last; };
  const auto in_table = [&](const Table& table) {
    return table.kind == box.origin.kind && (!table.index || *table.index == box.origin.table);
  };
  return all() || std::ranges::any_of(ids, in_ids) || std::ranges::any_of(tables, in_table);
}

Result<BodyChoice> parse_bodies(const std::string& text) {
  BodyChoice choice;
  if (text == "all") return choice;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view word = std::string_view(text).substr(begin, end - begin);
    if (const auto ids = parse_ids(word)) {
      choice.ids.push_back(*ids);
    } else if (const auto table = parse_table(word)) {
      choice.tables.push_back(*table);
    } else {
      return bad_input("bodies: found \"" + std::string(word) +
                       "\", wanted all, or ids (7), ranges (3-9) and tables (grid, grid:1, box, tower, pyramid, wall, "
                       "pile, input) joined by commas");
    }
    begin = end + 1;
  }
  return choice;
}

std::string to_string(const BodyChoice& choice) {
  if (choice.all()) return "all";
  std::string text;
  const auto add = [&](const std::string& word) { text += (text.empty() ? "" : ",") + word; };
  for (const BodyChoice::Ids& range : choice.ids) {
    add(std::to_string(range.first) + (range.first == range.last ? "" : "-" + std::to_string(range.last)));
  }
  for (const BodyChoice::Table& table : choice.tables) {
    add(std::string(kTables[static_cast<std::size_t>(table.kind)]) +
        (table.index ? ":" + std::to_string(*table.index) : ""));
  }
  return text;
}

}  // namespace tumble::replay
