#include "tools/output/metrics_output.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "replay/measure/metric_list.h"
#include "tools/output/axes_output.h"

namespace tumble::tools {
namespace {

// `lost` counts bodies that are not finite, so the count is told although it is within no bound.
bool is_told(const replay::MetricRow& metric) { return metric.name == std::string_view("lost"); }

Json value_json(const replay::MetricRow& metric, const replay::EngineAxes& axes, const replay::Metrics& metrics) {
  const std::optional<double> value = is_told(metric) ? metric.counted(metrics) : metric.value_in(axes, metrics);
  if (!value) return nullptr;
  if (std::isfinite(*value) && metric.counts()) return static_cast<std::uint64_t>(*value);
  return number_json(*value);
}

std::string value_text(const replay::MetricRow& metric, const replay::EngineAxes& axes,
                       const replay::Metrics& metrics) {
  const std::optional<double> value = is_told(metric) ? metric.counted(metrics) : metric.value_in(axes, metrics);
  if (!value) return metric.nothing;
  if (!std::isfinite(*value)) return std::isnan(*value) ? "not a number" : exact(*value);
  if (metric.counts()) return std::to_string(static_cast<std::uint64_t>(*value));
  return metric.unit == std::string_view("s") ? seconds_text(*value) : rounded(*value, metric.unit_in(axes));
}

constexpr std::array kStatistics = {replay::ChannelStatistic::kMin, replay::ChannelStatistic::kMax,
                                    replay::ChannelStatistic::kMean, replay::ChannelStatistic::kLast,
                                    replay::ChannelStatistic::kChangeMax};

std::vector<std::size_t> listed_order(const replay::Metrics& metrics) {
  return natural_order(metrics.channels,
                       [](const replay::ChannelMetrics& one) -> const std::string& { return one.channel.name; });
}

/// By name: kind, scope, unit, number of values and changes, and the statistics; null without a value.
Json channels_json(const replay::Metrics& metrics) {
  Json json = Json::object();
  for (const std::size_t c : listed_order(metrics)) {
    const replay::ChannelMetrics& channel = metrics.channels[c];
    Json& row = json[channel.channel.name];
    row = {{"kind", name_of(channel.channel.type.kind)},
           {"scope", name_of(channel.channel.type.scope)},
           {"unit", channel.channel.unit},
           {"values", channel.values},
           {"changes", channel.changes}};
    for (const replay::ChannelStatistic statistic : kStatistics) {
      const std::optional<double> value = channel.value(statistic);
      row[name_of(statistic)] = value ? number_json(*value) : Json(nullptr);
    }
  }
  return json;
}

void add_channels(const replay::Metrics& metrics, Listing& out) {
  if (!metrics.channels.empty()) out.section("channels");
  for (const std::size_t c : listed_order(metrics)) {
    const replay::ChannelMetrics& channel = metrics.channels[c];
    std::string text = count_text(channel.values, "value") + ", " + count_text(channel.changes, "change");
    if (const auto min = channel.value(replay::ChannelStatistic::kMin)) {
      text += ", " + exact(*min) + " to " + exact(*channel.value(replay::ChannelStatistic::kMax));
      if (!channel.channel.unit.empty()) text += " " + printable(channel.channel.unit);
    }
    out.add("  " + printable(channel.channel.name), text);
  }
}

Json not_finite_json(const std::optional<replay::NotFinite>& found, const replay::EngineAxes& axes) {
  if (!found) return nullptr;
  const replay::NotFinite lost = in_axes(axes, *found);
  return {{"body", lost.body},
          {"step", lost.step},
          {"field", lost.field},
          {"value", number_json(lost.value)},
          {"bodies", lost.bodies}};
}

/// The columns of a channel in a series: one without a name, or several.
std::vector<std::string> parts_of(const replay::Channel& channel) {
  if (!is_number(channel.type.kind)) return {"changes"};
  if (channel.type.scope == replay::ChannelScope::kWorld) return {""};
  return {"min", "max", "mean"};
}

/// "channel.NAME.max (rad)"; "channel.NAME (rad)" of a channel that has one part without a name.
std::string series_column(const replay::Channel& channel, const std::string& part) {
  const std::string name = "channel." + channel.name + (part.empty() ? "" : '.' + part);
  const bool has_unit = !channel.unit.empty() && part != "changes";
  return has_unit ? name + " (" + channel.unit + ')' : name;
}

/// A name as spreadsheets read it: in quotes where it holds a comma, a quote or a line end (RFC 4180).
std::string quoted_name(const std::string& name) {
  if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
  std::string out = "\"";
  for (const char c : name) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

/// Their cells in one row, each behind a comma; empty where the state has no value.
std::string channel_cells(const replay::Channel& channel, const replay::ChannelRow& row) {
  if (!is_number(channel.type.kind)) return ',' + std::to_string(row.changes);
  const bool is_world = channel.type.scope == replay::ChannelScope::kWorld;
  std::string cells;
  for (const double value : {row.min, row.max, row.mean()}) {
    cells += ',' + (row.values == 0 ? "" : exact(value));
    if (is_world) break;
  }
  return cells;
}

/// "body 7 (crate) in step 12, at 1e+06 0 3 m"
std::string first_lost_text(const replay::FirstLost& lost, const replay::EngineAxes& axes,
                            const replay::BodyTable& bodies) {
  const std::string text = printable(bodies.text(lost.body)) + " in step " + std::to_string(lost.step);
  if (!lost.place) return text + ", whose state has it no more although no input removed it";
  const sim::Vec3 place = axes.their_length(*lost.place);
  std::string at = ", at";
  for (int k = 0; k < 3; ++k) at += ' ' + significant(place[k], 6);
  return text + at + ' ' + axes.unit();
}

Json first_lost_json(const std::optional<replay::FirstLost>& lost, const replay::EngineAxes& axes) {
  if (!lost) return nullptr;
  Json json = {{"body", lost->body}, {"step", lost->step}, {"position", nullptr}};
  if (!lost->place) return json;
  const sim::Vec3 place = axes.their_length(*lost->place);
  json["position"] = {number_json(place.x()), number_json(place.y()), number_json(place.z())};
  return json;
}

}  // namespace

Json metrics_json(const std::string& log, const replay::EngineAxes& axes, const replay::Metrics& metrics) {
  Json json;
  json["log"] = log;
  json["bodies"] = metrics.bodies;
  json["steps"] = metrics.steps;
  for (const replay::MetricRow& metric : replay::metric_list()) {
    json[metric.group][metric.name] = value_json(metric, axes, metrics);
  }
  json["channels"] = channels_json(metrics);
  json["partings"] = Json::array();
  for (const replay::Parting& parting : metrics.partings) {
    json["partings"].push_back({{"beyond", parting.beyond},
                                {"parted", parting.parted},
                                {"time", parting.time},
                                {"step", parting.step},
                                {"body", parting.body == 0 ? Json(nullptr) : Json(parting.body)}});
  }
  json["final_hash"] = to_string(metrics.final_hash);
  json["axes"] = axes_json(axes);
  json["first_lost"] = first_lost_json(metrics.first_lost, axes);
  json["not_finite"] = not_finite_json(metrics.not_finite.any, axes);
  return json;
}

void print_metrics(const std::string& log, const replay::EngineAxes& axes, const replay::BodyTable& bodies,
                   const replay::Metrics& metrics) {
  Listing out;
  out.add("log", log);
  if (!axes.ours()) out.add("axes", to_string(axes));
  out.add("bodies", std::to_string(metrics.bodies));
  out.add("steps", std::to_string(metrics.steps));
  std::string_view group;
  std::size_t width = 0;
  for (const replay::MetricRow& metric : replay::metric_list()) {
    width = std::max(width, columns(value_text(metric, axes, metrics)));
  }
  for (const replay::MetricRow& metric : replay::metric_list()) {
    if (group != metric.group) out.section(metric.group);
    group = metric.group;
    out.add(std::string("  ") + metric.label, padded(value_text(metric, axes, metrics), width + 2) + metric.name);
  }
  add_channels(metrics, out);
  if (!metrics.partings.empty()) out.section("parting from the other session");
  for (const replay::Parting& parting : metrics.partings) {
    const std::string step = ", step " + std::to_string(parting.step);
    out.add("  beyond " + rounded(parting.beyond, "m"),
            parting.parted ? rounded(parting.time, "s") + step + ", body " + std::to_string(parting.body)
                           : "never, up to " + rounded(parting.time, "s") + step);
  }
  out.section("");
  if (metrics.first_lost) out.add("first lost", first_lost_text(*metrics.first_lost, axes, bodies));
  if (metrics.not_finite.any) out.add("not finite", to_string(*metrics.not_finite.any, axes));
  out.add("final hash", to_string(metrics.final_hash));
  out.print();
}

Status SeriesFile::open(const std::string& path, const std::vector<replay::Channel>& channels) {
  Result<files::OutputFile> file = files::OutputFile::create(path);
  if (!file.ok()) return Error{file.error().kind, "--series: " + file.error().message};
  file_ = *std::move(file);
  channels_ = channels;
  std::string line =
      "step,time,kinetic,potential,inputs,removed,gain,lateral_max,lateral_rms,column_spread,drift_max,tilt_max,"
      "top_drop_max,lost,ground_penetration_max,frozen_fraction";
  for (const replay::Channel& channel : channels_) {
    for (const std::string& part : parts_of(channel)) line += ',' + quoted_name(series_column(channel, part));
  }
  return file_->write(line + '\n');
}

void SeriesFile::add(const replay::SeriesRow& row) {
  const replay::StateMeasures& state = row.state;
  std::string line = std::to_string(row.step);
  const auto add_over = [&line](std::size_t bodies, double value) { line += ',' + (bodies > 0 ? exact(value) : ""); };
  for (const double value : {row.time, row.kinetic, row.potential, row.inputs}) line += ',' + exact(value);
  line += ',' + (row.removed ? exact(*row.removed) : "") + ',' + exact(row.gain);
  for (const double value : {state.lateral_max, state.lateral_rms}) add_over(state.of_start, value);
  line += ',' + (state.column_spread ? exact(*state.column_spread) : "");
  for (const double value : {state.drift_max, state.tilt_max, state.top_drop_max}) add_over(state.of_start, value);
  line += ',' + std::to_string(row.lost);
  for (const double value : {state.ground_penetration_max, state.frozen_fraction}) add_over(state.bodies, value);
  for (std::size_t c = 0; c < channels_.size(); ++c) line += channel_cells(channels_[c], row.channels[c]);
  line += '\n';
  if (written_.ok()) written_ = file_->write(line);
}

Status SeriesFile::close() {
  if (written_.ok()) written_ = file_->commit();
  return written_.ok() ? written_ : Status(Error{written_.error().kind, "--series: " + written_.error().message});
}

}  // namespace tumble::tools
