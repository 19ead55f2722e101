#include "tools/view/body_json.h"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "tools/output/divergence_output.h"
#include "tools/view/view_json.h"
#include "tumble/replay/body_states.h"

namespace tumble::tools {

namespace {

/// pairs: the number of values of pairs, also of those beyond kPairsShown.
Json channels_of_body(const replay::StepRecord& record, sim::BodyId id, const std::vector<replay::Channel>& channels,
                      std::size_t& pairs) {
  Json own = Json::array();
  std::size_t column = 0;  // by index in channel_columns()
  for (const std::size_t c : listed_order(channels)) {
    const auto& [kind, scope] = channels[c].type;
    const Json index = is_number(kind) ? Json(column++) : Json(nullptr);
    if (scope == replay::ChannelScope::kWorld) continue;
    const replay::ChannelValues& values = record.extras.values(c);
    const bool of_pairs = scope == replay::ChannelScope::kPair;
    for (std::size_t row = 0; row < values.size(); ++row) {
      const auto& [a, b] = values.keys[row];
      if (a != id && !(of_pairs && b == id)) continue;
      if (of_pairs && ++pairs > kPairsShown) continue;
      own.push_back({{"field", printable(channels[c].name)},
                     {"value", printable(to_string(values.value(row, kind), kind) + ' ' + channels[c].unit)},
                     {"channel", index},
                     {"with", of_pairs ? Json(a == id ? b : a) : Json(nullptr)}});
    }
  }
  return own;
}

}  // namespace

Json channel_history_json(std::uint64_t from, std::span<const replay::ChannelMoment> history) {
  Json json = {
      {"next", history.empty() ? from : history.back().step + 1}, {"step", Json::array()}, {"value", Json::array()}};
  for (const replay::ChannelMoment& moment : history) {
    json["step"].push_back(moment.step);
    json["value"].push_back(exact_json(moment.value));
  }
  return json;
}

Json body_json(const replay::StepRecord& record, sim::BodyId id, const std::vector<replay::Channel>& channels) {
  const replay::BodyStates& states = record.states;
  const auto found = std::ranges::lower_bound(states.id, id);
  if (found == states.id.end() || *found != id) return nullptr;
  const auto row = static_cast<std::size_t>(found - states.id.begin());
  const replay::ConstColumns columns = replay::columns_of(states);
  Json fields = Json::array();
  for (const std::size_t c : replay::kFieldOrder) {
    const double value = (*columns[c])[row];
    fields.push_back({{"field", replay::kColumnNames[c]}, {"value", number_json(value)}, {"hex", hex_text(value)}});
  }
  std::size_t pairs = 0;
  const Json own = channels_of_body(record, id, channels, pairs);
  return {{"id", id},         {"step", record.step}, {"frozen", states.frozen[row] != 0},
          {"fields", fields}, {"channels", own},     {"pairs", pairs}};
}

}  // namespace tumble::tools
