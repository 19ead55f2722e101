#include "tools/output/extras_output.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "replay/diff/channel_difference.h"
#include "tools/output/divergence_output.h"

namespace tumble::tools {
namespace {

using replay::ChannelKind;
using replay::ChannelScope;

std::string hex_of(const std::string& bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

std::string full_text(const replay::ChannelValue& value, ChannelKind kind) {
  if (kind == ChannelKind::kBytes) return hex_of(std::get<std::string>(value));
  return to_string(value, kind);
}

/// Calls visit(channel, values) for the channels of a scope that have values.
template <class Visit>
void for_each_channel(const replay::Declared& declared, const replay::Extras& extras, ChannelScope scope, Visit visit) {
  for (std::size_t i = 0; i < declared.channels.size(); ++i) {
    const replay::ChannelValues& values = extras.values(i);
    if (declared.channels[i].type.scope == scope && !values.empty()) visit(declared.channels[i], values);
  }
}

/// The row of a body; none where it has no value.
std::optional<std::size_t> row_of(const replay::ChannelValues& values, sim::BodyId id) {
  const replay::ChannelKey key = {id, 0};
  const auto at = std::ranges::lower_bound(values.keys, key);
  if (at == values.keys.end() || *at != key) return std::nullopt;
  return static_cast<std::size_t>(at - values.keys.begin());
}

Json triple_json(const sim::Vec3& v) { return {number_json(v.x()), number_json(v.y()), number_json(v.z())}; }

bool any_named(const replay::BodyTable& bodies) {
  return std::ranges::any_of(bodies.bodies(), [](const auto& entry) { return !entry.second.name.empty(); });
}

/// Text in a cell of a table, which has no quotes.
std::string cell_text(std::string text) {
  std::ranges::replace(text, ',', ';');
  return printable(text);
}

}  // namespace

Json channel_json(const replay::ChannelValue& value, ChannelKind kind) {
  if (const auto* number = std::get_if<double>(&value)) return number_json(*number);
  if (const auto* number = std::get_if<float>(&value)) return number_json(*number);
  if (const auto* number = std::get_if<std::int64_t>(&value)) return *number;
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return *number;
  return full_text(value, kind);
}

void add_body_extras(const replay::Declared& declared, const replay::BodyTable& bodies, const replay::Extras& extras,
                     sim::BodyId id, Json& json) {
  if (const std::string name = bodies.name(id); !name.empty()) json["name"] = name;
  if (const replay::Shape* shape = bodies.shape(id)) json["shape"] = to_string(*shape);
  for_each_channel(
      declared, extras, ChannelScope::kBody, [&](const replay::Channel& channel, const replay::ChannelValues& values) {
        const std::optional<std::size_t> row = row_of(values, id);
        if (!row) return;
        json["channels"][channel.name] = channel_json(values.value(*row, channel.type.kind), channel.type.kind);
      });
}

void add_step_extras(const replay::Declared& declared, const replay::Extras& extras, Json& json) {
  for_each_channel(declared, extras, ChannelScope::kWorld,
                   [&](const replay::Channel& channel, const replay::ChannelValues& values) {
                     json["world"][channel.name] = channel_json(values.value(0, channel.type.kind), channel.type.kind);
                   });
  for_each_channel(
      declared, extras, ChannelScope::kPair, [&](const replay::Channel& channel, const replay::ChannelValues& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
          json["pairs"].push_back({{"channel", channel.name},
                                   {"a", values.keys[i].a},
                                   {"b", values.keys[i].b},
                                   {"value", channel_json(values.value(i, channel.type.kind), channel.type.kind)}});
        }
      });
  for (const replay::EngineContact& contact : extras.contacts) {
    json["contacts"].push_back({{"a", contact.a},
                                {"b", contact.b},
                                {"position", triple_json(contact.position)},
                                {"normal", triple_json(contact.normal)},
                                {"depth", number_json(contact.depth)},
                                {"impulse", number_json(contact.impulse)}});
  }
  for (const std::string& note : extras.notes) json["notes"].push_back(note);
  for (const replay::EngineSnapshot& snapshot : extras.snapshots) {
    json["snapshots"].push_back(snapshot.bytes.size());
    json["snapshot_names"].push_back(snapshot.name);
  }
  for (const replay::Superseded& before : extras.superseded) {
    json["superseded"].push_back({{"same_inputs", before.same_inputs}, {"difference", before.difference}});
  }
}

std::vector<std::string> extra_columns(const replay::Declared& declared, const replay::BodyTable& bodies) {
  std::vector<std::string> names;
  if (any_named(bodies)) names.emplace_back("name");
  for (const replay::Channel& channel : declared.channels) {
    if (channel.type.scope == ChannelScope::kPair) continue;
    names.push_back((channel.type.scope == ChannelScope::kBody ? "channel." : "world.") + cell_text(channel.name));
  }
  return names;
}

std::vector<std::string> extra_cells(const replay::Declared& declared, const replay::BodyTable& bodies,
                                     const replay::Extras& extras, sim::BodyId id) {
  std::vector<std::string> cells;
  if (any_named(bodies)) cells.push_back(cell_text(bodies.name(id)));
  for (std::size_t i = 0; i < declared.channels.size(); ++i) {
    const auto& [name, type, unit] = declared.channels[i];
    if (type.scope == ChannelScope::kPair) continue;
    const replay::ChannelValues& values = extras.values(i);
    const std::optional<std::size_t> row = row_of(values, type.scope == ChannelScope::kBody ? id : 0);
    cells.push_back(row ? cell_text(full_text(values.value(*row, type.kind), type.kind)) : "");
  }
  return cells;
}

void add_extra_rows(const replay::Declared& declared, const replay::BodyTable& bodies, std::uint64_t step,
                    const replay::Extras& extras, sim::BodyId body, Table& table) {
  for (std::size_t i = 0; i < declared.channels.size(); ++i) {
    const auto& [name, type, unit] = declared.channels[i];
    const replay::ChannelValues& values = extras.values(i);
    for (std::size_t row = 0; row < values.size(); ++row) {
      const replay::ChannelKey& key = values.keys[row];
      if (body != 0 && key.a != body && key.b != body) continue;
      std::string of = type.scope == ChannelScope::kWorld ? "world" : bodies.text(key.a);
      if (type.scope == ChannelScope::kPair) of += " and " + bodies.text(key.b);
      std::string value = to_string(values.value(row, type.kind), type.kind);
      if (!unit.empty()) value += " " + unit;
      table.add({std::to_string(step), printable(name), printable(of), printable(value)});
    }
  }
  for (const replay::EngineContact& contact : extras.contacts) {
    if (body != 0 && contact.a != body && contact.b != body) continue;
    const std::string other = contact.b == 0 ? "the world" : bodies.text(contact.b);
    table.add({std::to_string(step), "contact", printable(bodies.text(contact.a) + " and " + other),
               "depth " + rounded(contact.depth, "m") + ", impulse " + rounded(contact.impulse, "N s")});
  }
  if (body != 0) return;
  for (const std::string& note : extras.notes) table.add({std::to_string(step), "note", "", printable(note)});
  for (const replay::EngineSnapshot& snapshot : extras.snapshots) {
    table.add({std::to_string(step), "snapshot", printable(snapshot.name), bytes_text(snapshot.bytes.size())});
  }
  for (const replay::Superseded& before : extras.superseded) {
    const std::string found = before.difference.empty() ? "the same" : before.difference;
    table.add(
        {std::to_string(step), "superseded", before.same_inputs ? "equal inputs" : "other inputs", printable(found)});
  }
}

void add_extra_differences(replay::LogReader& a, replay::LogReader& b, const replay::StepRecord& in_a,
                           const replay::StepRecord& in_b, Json& rows) {
  const auto engine = [](const replay::LogReader& log) {
    return log.header().engine.value_or(replay::EngineName()).name;
  };
  const replay::ChannelMatch match = match_channels(a.header(), b.header(), {}, engine(a) != engine(b));
  for (const replay::ExtraRow& row : extras_side_by_side(match, in_a, in_b)) {
    const auto count = [](std::size_t n) { return Json(count_text(n, "value")); };
    std::string name = row.name;
    if (row.first && row.first->body) name += ", " + a.bodies().text(*row.first->body);
    if (row.first && row.first->pair) name += ", pair";
    rows.push_back({{"name", name},
                    {"a", row.first ? value_json(row.first->expected) : count(row.in_a)},
                    {"b", row.first ? value_json(row.first->actual) : count(row.in_b)},
                    {"same", !row.first}});
  }
}

}  // namespace tumble::tools
