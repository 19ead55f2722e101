#include "replay/diff/channel_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "replay/format/chain.h"
#include "replay/format/little_endian.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr const char* kChannelField = "channel.";

FieldValue shown_value(const ChannelValue& value, ChannelKind kind) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* number = std::get_if<float>(&value)) return double{*number};
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return *number;
  return to_string(value, kind);
}

/// One channel of one step in both logs.
struct ComparedChannel {
  const SharedChannel& channel;
  const ChannelValues& a;
  const ChannelValues& b;
};

bool same_value_at(const ComparedChannel& both, std::size_t i, std::size_t j) {
  const ChannelKind kind = both.channel.type.kind, kind_b = both.channel.kind_b;
  if (kind != kind_b) return to_string(both.a.value(i, kind), kind) == to_string(both.b.value(j, kind_b), kind_b);
  return is_number(kind) ? both.a.bits[i] == both.b.bits[j] : both.a.bytes[i] == both.b.bytes[j];
}

/// How far two numbers are apart; NaN where one is none.
double distance_at(const ComparedChannel& both, std::size_t i, std::size_t j) {
  return distance_between(both.a.value(i, both.channel.type.kind), both.b.value(j, both.channel.kind_b));
}

bool excused(const ComparedChannel& both, std::size_t i, std::size_t j, const Tolerances& tolerances) {
  if (!is_number(both.channel.type.kind) || tolerances.fields.empty()) return false;
  return tolerances.excuses(kChannelField + both.channel.name, 0, distance_at(both, i, j));
}

Divergence value_difference(const ComparedChannel& both, const ChannelKey& key, const std::optional<std::size_t>& i,
                            const std::optional<std::size_t>& j) {
  const auto& [name, type, kind_b, unit, in_a, in_b] = both.channel;
  const auto text = [](const ChannelValues& values, ChannelKind kind, const std::optional<std::size_t>& row) {
    return row ? shown_value(values.value(*row, kind), kind) : FieldValue(std::string("no value"));
  };
  Divergence found =
      make_divergence(0, "channels", kChannelField + name, text(both.a, type.kind, i), text(both.b, kind_b, j));
  const auto *x = std::get_if<double>(&found.expected), *y = std::get_if<double>(&found.actual);
  const bool singles = type.kind == ChannelKind::kFloat32 && kind_b == type.kind && x != nullptr && y != nullptr;
  if (singles) found.ulps = ulps32_between(*x, *y);
  if (type.scope == ChannelScope::kBody) found.body = key.a;
  if (type.scope == ChannelScope::kPair) found.pair = {key.a, key.b};
  if (!unit.empty()) found.note = "in " + unit;
  return found;
}

/// The first row of a channel that differs, by key.
std::optional<Divergence> difference_in(const ComparedChannel& both, const Tolerances& tolerances) {
  std::size_t i = 0, j = 0;
  while (i < both.a.size() || j < both.b.size()) {
    if (j == both.b.size() || (i < both.a.size() && both.a.keys[i] < both.b.keys[j])) {
      return value_difference(both, both.a.keys[i], i, std::nullopt);
    }
    if (i == both.a.size() || both.b.keys[j] < both.a.keys[i]) {
      return value_difference(both, both.b.keys[j], std::nullopt, j);
    }
    if (!same_value_at(both, i, j) && !excused(both, i, j, tolerances)) {
      return value_difference(both, both.a.keys[i], i, j);
    }
    ++i;
    ++j;
  }
  return std::nullopt;
}

template <class Visit>
void for_each_compared(const ChannelMatch& match, const StepRecord& expected, const StepRecord& actual, Visit visit) {
  for (const SharedChannel& channel : match.compared) {
    visit(ComparedChannel{channel, expected.extras.values(channel.in_a), actual.extras.values(channel.in_b)});
  }
}

/// What equal values of a channel leave open: whether their kinds and units mean the same.
std::vector<std::string> reservations(const Channel& a, const Channel& b) {
  std::vector<std::string> parts;
  const auto unit = [](const Channel& channel) { return channel.unit.empty() ? "none" : channel.unit; };
  if (a.type.kind != b.type.kind) {
    parts.push_back("channel " + a.name + ": its kind, " + name_of(a.type.kind) + " in the first log and " +
                    name_of(b.type.kind) + " in the second; values were compared as numbers");
  }
  if (a.unit != b.unit) {
    parts.push_back("channel " + a.name + ": its unit, " + unit(a) + " in the first log and " + unit(b) +
                    " in the second");
  }
  return parts;
}

bool compares_across_engines(const std::string& name, const Tolerances& tolerances) {
  return tolerances.fields.contains(kChannelField + name);
}

/// "angle, seed"; empty where none differs.
std::string differing_channels(const ChannelMatch& match, const StepRecord& expected, const StepRecord& actual,
                               const Tolerances& tolerances) {
  std::vector<std::string> names;
  for_each_compared(match, expected, actual, [&](const ComparedChannel& both) {
    if (difference_in(both, tolerances)) names.push_back(both.channel.name);
  });
  std::ranges::sort(names, natural_less);
  return joined(names, ", ");
}

}  // namespace

bool are_two_engines(const LogHeader& a, const LogHeader& b) {
  const auto engine = [](const LogHeader& header) { return header.engine.value_or(EngineName()).name; };
  return engine(a) != engine(b);
}

std::optional<Divergence> contact_difference(const std::vector<EngineContact>& a, const std::vector<EngineContact>& b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (a[i].a != b[i].a || a[i].b != b[i].b) break;
    const auto in_a = numbers_of(a[i]), in_b = numbers_of(b[i]);
    for (std::size_t c = 0; c < in_a.size(); ++c) {
      if (bits_of(in_a[c]) == bits_of(in_b[c])) continue;
      Divergence found = make_divergence(0, "contacts", std::string("contact.") + kContactNumbers[c], in_a[c], in_b[c]);
      found.pair = {a[i].a, a[i].b};
      return found;
    }
  }
  const auto pair_of = [](const EngineContact& c) { return std::pair(c.a, c.b); };
  const auto [in_a, in_b] = std::ranges::mismatch(a, b, {}, pair_of, pair_of);
  if (in_a == a.end() && in_b == b.end()) return std::nullopt;
  Divergence found = make_divergence(0, "contacts", "contacts", std::uint64_t{a.size()}, std::uint64_t{b.size()});
  const bool from_a = in_b == b.end() || (in_a != a.end() && pair_of(*in_a) < pair_of(*in_b));
  found.pair = from_a ? pair_of(*in_a) : pair_of(*in_b);
  found.note = std::string("only ") + (from_a ? "the first" : "the second") + " log has this contact";
  return found;
}

ChannelMatch match_channels(const LogHeader& a, const LogHeader& b, const Tolerances& tolerances, bool two_engines) {
  ChannelMatch match;
  match.contacts = !two_engines;
  const Declared &in_a = a.declared, &in_b = b.declared;
  for (std::size_t i = 0; i < in_a.channels.size(); ++i) {
    const Channel& channel = in_a.channels[i];
    const std::size_t j = in_b.find(channel.name);
    const std::string named = "channel " + channel.name + ": ";
    if (j == in_b.channels.size()) {
      match.passed_over.push_back(named + "only the first log has it");
    } else if (!comparable(channel.type, in_b.channels[j].type)) {
      const auto type_text = [](const ChannelType& type) {
        return std::string(name_of(type.kind)) + " of scope " + name_of(type.scope);
      };
      const std::string type_a = type_text(channel.type), type_b = type_text(in_b.channels[j].type);
      std::string types = named + type_a;
      types.append(" in the first log, ").append(type_b).append(" in the second");
      match.passed_over.push_back(std::move(types));
      if (!two_engines) {
        match.other_kinds.push_back(make_divergence(0, "start", kChannelField + channel.name, type_a, type_b));
        match.other_kinds.back().note = "values of other kinds are not compared";
      }
    } else if (two_engines && !compares_across_engines(channel.name, tolerances)) {
      match.passed_over.push_back(named + "the logs are of two engines; a tolerance compares it");
    } else {
      match.compared.push_back({channel.name, channel.type, in_b.channels[j].type.kind, channel.unit, i, j});
      for (std::string& part : reservations(channel, in_b.channels[j])) match.passed_over.push_back(std::move(part));
      match.equal = match.equal && i == j && channel.type == in_b.channels[j].type;
    }
  }
  for (const Channel& channel : in_b.channels) {
    if (in_a.find(channel.name) != in_a.channels.size()) continue;
    match.passed_over.push_back("channel " + channel.name + ": only the second log has it");
  }
  match.equal = match.equal && match.passed_over.empty() && match.contacts;
  std::ranges::stable_sort(match.passed_over, natural_less);
  return match;
}

std::vector<std::string> names_of(const ChannelMatch& match) {
  std::vector<std::string> names;
  for (const SharedChannel& channel : match.compared) names.push_back(channel.name);
  std::ranges::sort(names, natural_less);
  return names;
}

void leave_out_channels(const ChannelMatch& match, const StepRecord& expected, StepRecord& actual) {
  if (match.equal) return;
  std::vector<ChannelValues> values = expected.extras.channels;
  for (const SharedChannel& channel : match.compared) {
    if (channel.in_a >= values.size()) values.resize(channel.in_a + 1);
    values[channel.in_a] = actual.extras.values(channel.in_b);
  }
  actual.extras.channels = std::move(values);
  if (!match.contacts) actual.extras.contacts = expected.extras.contacts;
}

bool same_step(const ChannelMatch& match, const StepRecord& expected, const StepRecord& actual) {
  if (match.equal) return chain_next({}, expected) == chain_next({}, actual);
  StepRecord compared = actual;
  leave_out_channels(match, expected, compared);
  return chain_next({}, expected) == chain_next({}, compared);
}

std::optional<Divergence> first_extra_difference(const ChannelMatch& match, const StepRecord& expected,
                                                 const StepRecord& actual, const Tolerances& tolerances) {
  std::optional<Divergence> first;
  for_each_compared(match, expected, actual, [&](const ComparedChannel& both) {
    if (!first) first = difference_in(both, tolerances);
  });
  if (!first && match.contacts && tolerances.exact()) {
    first = contact_difference(expected.extras.contacts, actual.extras.contacts);
  }
  if (first) first->step = expected.step;
  return first;
}

double channel_distance(const SharedChannel& channel, const StepRecord& a, const StepRecord& b) {
  const ComparedChannel both = {channel, a.extras.values(channel.in_a), b.extras.values(channel.in_b)};
  const ChannelKind kind = channel.type.kind;
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double largest = 0;
  std::size_t i = 0, j = 0;
  while (i < both.a.size() || j < both.b.size()) {
    const bool only_a = j == both.b.size() || (i < both.a.size() && both.a.keys[i] < both.b.keys[j]);
    const bool only_b = !only_a && (i == both.a.size() || both.b.keys[j] < both.a.keys[i]);
    double distance = kFar;
    if (!only_a && !only_b) {
      distance = same_value_at(both, i, j) ? 0 : 1;
      if (distance > 0 && is_number(kind)) {
        distance = distance_at(both, i, j);
        // Two zeros of other sign differ all the same.
        if (distance == 0) distance = std::numeric_limits<double>::denorm_min();
        if (std::isnan(distance)) distance = kFar;
      }
    }
    largest = is_number(kind) ? std::max(largest, distance) : largest + (distance > 0 ? 1 : 0);
    if (!only_b) ++i;
    if (!only_a) ++j;
  }
  return largest;
}

std::vector<ExtraRow> extras_side_by_side(const ChannelMatch& match, const StepRecord& a, const StepRecord& b) {
  std::vector<ExtraRow> rows;
  for (const Divergence& other : match.other_kinds) rows.push_back({other.field, 0, 0, other});
  for_each_compared(match, a, b, [&](const ComparedChannel& both) {
    rows.push_back({kChannelField + both.channel.name, both.a.size(), both.b.size(), difference_in(both, {})});
  });
  std::ranges::stable_sort(rows, natural_less, &ExtraRow::name);
  const std::vector<EngineContact>&in_a = a.extras.contacts, &in_b = b.extras.contacts;
  if (match.contacts && !(in_a.empty() && in_b.empty())) {
    rows.push_back({"contacts", in_a.size(), in_b.size(), contact_difference(in_a, in_b)});
  }
  return rows;
}

void add_extra_difference(const ChannelMatch& match, const StepRecord& expected, const StepRecord& actual,
                          const Tolerances& tolerances, std::optional<Divergence>& first) {
  std::optional<Divergence> extra = first_extra_difference(match, expected, actual, tolerances);
  if (!extra) return;
  const bool by_energy = first && first->phase == "step" && !first->body && first->field != "state_hash";
  if (!first || by_energy) {
    first = std::move(extra);
    return;
  }
  const std::string names = differing_channels(match, expected, actual, tolerances);
  if (names.empty()) return;
  first->note += (first->note.empty() ? "" : "; ") + std::string("channels that differ in this step too: ") + names;
}

std::vector<std::string> left_out(const ChannelMatch& match, const DerivedValues& derived, bool imported,
                                  const Tolerances& tolerances) {
  std::vector<std::string> parts = match.passed_over;
  if (derived.velocity) parts.emplace_back("velocities: the import derived them from positions");
  if (derived.spin) parts.emplace_back("spins: the import derived them from orientations");
  if (!imported || (match.contacts && tolerances.exact())) return parts;
  parts.push_back(match.contacts ? "contacts of the engine: tolerances leave them out" : match.contacts_why);
  return parts;
}

}  // namespace tumble::replay
