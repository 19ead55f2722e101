#include "replay/measure/measure_options.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>
#include <utility>

namespace tumble::replay {
namespace {

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
  const auto* const name = std::ranges::find(sim::kOriginNames, word.substr(0, colon));
  if (name == sim::kOriginNames.end()) return std::nullopt;
  BodyChoice::Table table{static_cast<sim::Origin::Kind>(name - sim::kOriginNames.begin()), std::nullopt};
  if (colon == std::string_view::npos) return table;
  table.index = parse_number<std::uint32_t>(word.substr(colon + 1));
  return table.index ? std::optional(table) : std::nullopt;
}

std::vector<sim::BodyId> ids_of(const std::string& name, const BodyTable& named) {
  std::vector<sim::BodyId> ids;
  for (const auto& [id, info] : named.bodies()) {
    if (!name.empty() && info.name == name) ids.push_back(id);
  }
  return ids;
}

}  // namespace

bool BodyChoice::Ids::holds(const sim::BoxDef& box) const { return first <= box.id && box.id <= last; }

bool BodyChoice::Table::holds(const sim::BoxDef& box) const {
  return kind == box.origin.kind && (!index || *index == box.origin.table);
}

bool BodyChoice::holds(const sim::BoxDef& box) const {
  const auto has_box = [&](const auto& part) { return part.holds(box); };
  return all() || std::ranges::any_of(ids, has_box) || std::ranges::any_of(tables, has_box);
}

ChoiceWatch::ChoiceWatch(BodyChoice choice)
    : choice_(std::move(choice)), ids_(choice_.ids.size()), tables_(choice_.tables.size()) {}

void ChoiceWatch::add(const sim::BoxDef& box) {
  for (std::size_t k = 0; k < ids_.size(); ++k) ids_[k] = ids_[k] || choice_.ids[k].holds(box);
  for (std::size_t k = 0; k < tables_.size(); ++k) tables_[k] = tables_[k] || choice_.tables[k].holds(box);
}

std::vector<std::string> ChoiceWatch::missing() const {
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < ids_.size(); ++k) {
    const bool one = choice_.ids[k].first == choice_.ids[k].last;
    if (!ids_[k]) parts.push_back((one ? "body " : "bodies ") + to_string(BodyChoice{{choice_.ids[k]}, {}}));
  }
  for (std::size_t k = 0; k < tables_.size(); ++k) {
    if (!tables_[k]) parts.push_back(to_string(BodyChoice{{}, {choice_.tables[k]}}));
  }
  return parts;
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

Result<BodyChoice> parse_bodies(const std::string& text, const BodyTable& named) {
  BodyChoice choice;
  if (text == "all") return choice;
  const auto take = [&](const std::string& word) -> Result<bool> {
    const std::vector<sim::BodyId> ids = ids_of(word, named);
    const std::optional<BodyChoice::Ids> as_ids = parse_ids(word);
    for (const sim::BodyId id : ids) {
      if (as_ids && !(as_ids->first == id && as_ids->last == id)) {
        const std::string own = std::to_string(id);
        std::string message = "bodies: found \"";
        message.append(word).append("\", the name of body ").append(own);
        message.append(" and an id or a range of ids too; wanted ").append(own).append("-").append(own);
        return bad_input(message + " for that body, or ranges, as 2-2, for the others");
      }
      choice.ids.push_back({id, id});
    }
    return !ids.empty();
  };
  Result<bool> whole = take(text);  // a name may have commas
  if (!whole.ok()) return whole.error();
  std::string others;
  for (std::size_t begin = 0; !*whole && begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    begin = end + 1;
    const Result<bool> is_name = take(word);
    if (!is_name.ok()) return is_name.error();
    if (!*is_name) others += (others.empty() ? "" : ",") + word;
  }
  if (others.empty() && !choice.ids.empty()) return choice;
  Result<BodyChoice> rest = parse_bodies(others);
  if (!rest.ok()) {
    const auto has_name = [](const auto& entry) { return !entry.second.name.empty(); };
    const bool any = std::ranges::any_of(named.bodies(), has_name);
    return any ? bad_input(rest.error().message + "; or names of bodies, which 'tumble dump' shows") : rest;
  }
  choice.ids.insert(choice.ids.end(), rest->ids.begin(), rest->ids.end());
  choice.tables = rest->tables;
  return choice;
}

Result<sim::BodyId> parse_body(const std::string& text, const BodyTable& named) {
  const std::vector<sim::BodyId> ids = ids_of(text, named);
  const std::optional<sim::BodyId> id = parse_number<sim::BodyId>(text);
  if (id && *id > 0 && *id <= sim::kBodyIdMax && (ids.empty() || ids.front() == *id)) return *id;
  if (ids.size() == 1 && !id) return ids.front();
  if (ids.size() > 1) {
    return bad_input("found \"" + text + "\", the name of " + std::to_string(ids.size()) +
                     " bodies, wanted the id of one of them: " + std::to_string(ids[0]) + ", " +
                     std::to_string(ids[1]) + (ids.size() > 2 ? " …" : ""));
  }
  if (!ids.empty() && id) {
    return bad_input("found \"" + text + "\", the id of a body and the name of body " + std::to_string(ids.front()) +
                     ", wanted another id");
  }
  return bad_input("found \"" + text + "\", wanted the id of a body, or its name, which 'tumble dump' shows");
}

std::string to_string(const BodyChoice& choice) {
  if (choice.all()) return "all";
  std::string text;
  const auto add = [&](const std::string& word) { text += (text.empty() ? "" : ",") + word; };
  for (const BodyChoice::Ids& range : choice.ids) {
    add(std::to_string(range.first) + (range.first == range.last ? "" : "-" + std::to_string(range.last)));
  }
  for (const BodyChoice::Table& table : choice.tables) {
    add(std::string(name_of(table.kind)) + (table.index ? ":" + std::to_string(*table.index) : ""));
  }
  return text;
}

}  // namespace tumble::replay
