#include "tools/output/extras_output.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "replay/arrays/pair_cell.h"
#include "replay/diff/channel_difference.h"
#include "replay/diff/difference_report.h"
#include "replay/export/table/channel_cells.h"
#include "src/base/text.h"

namespace tumble::tools {
namespace {

using replay::ChannelKind;
using replay::ChannelScope;

std::string full_text(const replay::ChannelValue& value, ChannelKind kind) {
  if (kind == ChannelKind::kBytes) return hex_digits(std::get<std::string>(value));
  return to_string(value, kind);
}

/// Calls visit(channel, values) for the channels of a scope that have values.
template <class Visit>
void for_each_channel(const Told& told, const replay::Extras& extras, ChannelScope scope, Visit visit) {
  for (const std::size_t i : told.listed) {
    const replay::Channel& channel = told.declared.channels[i];
    const replay::ChannelValues& values = extras.values(i);
    if (channel.type.scope == scope && !values.empty()) visit(channel, values);
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

bool fits_cell(const std::string& text) { return replay::text_cell(text) == text; }

std::string column_of(const replay::Channel& channel) { return channel_column(channel) + unit_in_column(channel); }

}  // namespace

Told told_by(const replay::LogHeader& header, replay::BodyTable bodies) {
  return {header.axes(), header.declared, std::move(bodies), listed_order(header.declared.channels)};
}

Json channel_json(const replay::ChannelValue& value, ChannelKind kind) {
  if (const auto* number = std::get_if<double>(&value)) return number_json(*number);
  if (const auto* number = std::get_if<float>(&value)) return number_json(*number);
  if (const auto* number = std::get_if<std::int64_t>(&value)) return *number;
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return *number;
  return full_text(value, kind);
}

void add_body_extras(const Told& told, const replay::Extras& extras, sim::BodyId id, Json& json) {
  if (const std::string name = told.bodies.name(id); !name.empty()) json["name"] = name;
  if (const replay::Shape* shape = told.bodies.shape(id)) json["shape"] = to_string(*shape);
  for_each_channel(told, extras, ChannelScope::kBody,
                   [&](const replay::Channel& channel, const replay::ChannelValues& values) {
                     const ChannelKind kind = channel.type.kind;
                     const std::optional<std::size_t> row = row_of(values, id);
                     if (row) json["channels"][channel.name] = channel_json(values.value(*row, kind), kind);
                   });
}

void add_step_extras(const Told& told, const replay::Extras& extras, Json& json) {
  for_each_channel(told, extras, ChannelScope::kWorld,
                   [&](const replay::Channel& channel, const replay::ChannelValues& values) {
                     json["world"][channel.name] = channel_json(values.value(0, channel.type.kind), channel.type.kind);
                   });
  for_each_channel(told, extras, ChannelScope::kPair,
                   [&](const replay::Channel& channel, const replay::ChannelValues& values) {
                     for (std::size_t i = 0; i < values.size(); ++i) {
                       const ChannelKind kind = channel.type.kind;
                       json["pairs"].push_back({{"channel", channel.name},
                                                {"a", values.keys[i].a},
                                                {"b", values.keys[i].b},
                                                {"value", channel_json(values.value(i, kind), kind)}});
                     }
                   });
  const replay::EngineAxes& axes = told.axes;
  for (const replay::EngineContact& contact : extras.contacts) {
    json["contacts"].push_back({{"a", contact.a},
                                {"b", contact.b},
                                {"position", triple_json(axes.their_length(contact.position))},
                                {"normal", triple_json(axes.their_direction(contact.normal))},
                                {"depth", number_json(axes.their_metres(contact.depth))},
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

TableExtras::TableExtras(const Told& told) : told_(told) {
  for (const auto& [id, body] : told.bodies.bodies()) {
    if (body.name.empty()) continue;
    named_ = true;
    escaped_ = escaped_ || !fits_cell(body.name);
  }
  for (const replay::Channel& channel : told.declared.channels) {  // of texts to come nothing is known
    escaped_ = escaped_ || !is_number(channel.type.kind) || !fits_cell(column_of(channel));
  }
}

std::string TableExtras::as_cell(const std::string& text) const { return escaped_ ? replay::text_cell(text) : text; }

std::string TableExtras::head() const {
  std::string head = named_ ? ",name" : "";
  for (const replay::Channel& channel : told_.declared.channels) head += ',' + as_cell(column_of(channel));
  return head;
}

void TableExtras::append_value(const replay::ChannelValues& values, const replay::ChannelType& type, sim::BodyId id,
                               std::string& line) const {
  const auto at = std::ranges::lower_bound(values.keys, replay::ChannelKey{id, 0});
  if (at == values.keys.end() || at->a != id) return;
  const auto row = static_cast<std::size_t>(at - values.keys.begin());
  if (type.scope == ChannelScope::kPair) {
    line += as_cell(replay::pair_cell(values, type.kind, row));
    return;
  }
  const replay::ChannelValue value = values.value(row, type.kind);
  const auto* text = std::get_if<std::string>(&value);
  if (text == nullptr) {
    line += value_cell(value, type.kind);
  } else {
    line += as_cell(type.kind == ChannelKind::kBytes ? hex_digits(*text) : *text);
  }
}

void TableExtras::append_cells(const replay::Extras& extras, sim::BodyId id, std::string& line) const {
  if (named_) {
    const std::string name = told_.bodies.name(id);
    line += ',' + (name.empty() ? name : as_cell(name));
  }
  for (std::size_t i = 0; i < told_.declared.channels.size(); ++i) {
    const replay::ChannelType& type = told_.declared.channels[i].type;
    line += ',';
    append_value(extras.values(i), type, type.scope == ChannelScope::kWorld ? 0 : id, line);
  }
}

std::vector<std::string> TableExtras::units_left_out() const {
  std::vector<std::string> names;
  for (const std::size_t i : told_.listed) {
    const replay::Channel& channel = told_.declared.channels[i];
    if (!replay::fits_column(channel.unit)) names.push_back("channel " + printable(channel.name));
  }
  return names;
}

std::vector<std::string> TableExtras::left_out_of(const replay::Extras& extras,
                                                  const std::vector<sim::BodyId>& bodies) const {
  std::vector<std::string> parts;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) parts.emplace_back(what);
  };
  add(extras.contacts.size(), "contacts");
  add(extras.notes.size(), "notes");
  add(extras.snapshots.size(), "snapshots");
  add(extras.superseded.size(), "superseded steps");
  const std::vector<replay::Channel>& channels = told_.declared.channels;
  for (const std::size_t i : told_.listed) {
    if (channels[i].type.scope == ChannelScope::kWorld) continue;
    const auto has_row = [&](const replay::ChannelKey& key) { return std::ranges::binary_search(bodies, key.a); };
    if (!std::ranges::all_of(extras.values(i).keys, has_row)) {
      parts.push_back("values of channel " + printable(channels[i].name) + " whose body has no row");
    }
  }
  if (bodies.empty() && extras.in_chain()) parts.emplace_back("channels of a step without bodies");
  return parts;
}

void add_extra_rows(const Told& told, std::uint64_t step, const replay::Extras& extras, sim::BodyId body,
                    LongTable& table) {
  const auto& [axes, declared, bodies, listed] = told;
  for (const std::size_t i : listed) {
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
    const std::string other = contact.b == 0 ? "the ground" : bodies.text(contact.b);
    table.add({std::to_string(step), "contact", printable(bodies.text(contact.a) + " and " + other),
               "depth " + rounded(axes.their_metres(contact.depth), axes.unit()) + ", impulse " +
                   rounded(contact.impulse, "N s")});
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
  const replay::ChannelMatch match =
      match_channels(a.header(), b.header(), {}, replay::are_two_engines(a.header(), b.header()));
  for (const replay::ExtraRow& row : extras_side_by_side(match, in_a, in_b)) {
    const auto count = [](std::size_t n) { return Json(count_text(n, "value")); };
    std::string name = row.name;
    if (row.first && row.first->body) name += ", " + a.bodies().text(*row.first->body);
    if (row.first && row.first->pair) {
      const auto& [one, other] = *row.first->pair;
      name += ", pair " + a.bodies().text(one) + " and " + (other == 0 ? "the ground" : a.bodies().text(other));
    }
    std::optional<replay::Divergence> first = row.first;
    if (first) first = in_axes(common_axes(a.header(), b.header()), *std::move(first));
    if (first && first->field != row.name) name += ", " + first->field;
    rows.push_back({{"name", name},
                    {"a", first ? value_json(first->expected) : count(row.in_a)},
                    {"b", first ? value_json(first->actual) : count(row.in_b)},
                    {"same", !first}});
  }
}

bool add_left_out(const replay::LogReader& log_a, const replay::LogReader& log_b, Json& step) {
  const replay::LogHeader &a = log_a.header(), &b = log_b.header();
  step["notes"] = replay::notes_on_wholeness(log_a, log_b);
  const bool two_engines = replay::are_two_engines(a, b);
  Json parts = replay::match_channels(a, b, {}, two_engines).passed_over;
  for (const replay::LogHeader* header : {&a, &b}) {
    if (!header->table) continue;
    for (const std::string& column : header->table->passed_over) {
      const std::string text = "column " + column + ": the import passed over it";
      if (std::ranges::find(parts, Json(text)) == parts.end()) parts.push_back(text);
    }
  }
  step["not_compared"] = parts;
  const replay::OnlyInOne only_in = two_engines ? replay::OnlyInOne() : replay::only_in_one(a, b);
  step["only_in"] = only_in_json(only_in);
  return only_in.empty();
}

void print_left_out(const Json& step, const Sides& sides) {
  for (const Json& note : step["notes"]) std::cout << "  note: " << printable(note.get<std::string>()) << '\n';
  for (const auto& [side, name] : {std::pair("a", sides.expected), std::pair("b", sides.actual)}) {
    for (const Json& part : step["only_in"][side])
      std::cout << "  only in " << name << ": " << printable(part.get<std::string>()) << '\n';
  }
  for (const Json& part : step["not_compared"])
    std::cout << "  not compared: " << printable(part.get<std::string>()) << '\n';
}

}  // namespace tumble::tools
