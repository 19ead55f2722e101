#include "tools/metrics_output.h"

#include <cerrno>
#include <cstring>
#include <optional>

namespace tumble::tools {
namespace {

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

}  // namespace

Json metrics_json(const std::string& log, const replay::Metrics& metrics) {
  const auto& [lateral_max, lateral_rms, column_spread] = metrics.symmetry;
  const replay::EnergyMetrics& energy = metrics.energy;
  const replay::StackingMetrics& stacking = metrics.stacking;
  Json json;
  json["log"] = log;
  json["bodies"] = metrics.bodies;
  json["steps"] = metrics.steps;
  json["symmetry"] = {
      {"lateral_max", lateral_max}, {"lateral_rms", lateral_rms}, {"column_spread", or_null(column_spread)}};
  json["energy"] = {{"initial", energy.initial},   {"final", energy.final},
                    {"gain_max", energy.gain_max}, {"gain_ratio", or_null(energy.gain_ratio)},
                    {"removed", energy.removed},   {"inputs", energy.inputs}};
  json["stacking"] = {
      {"drift_max", stacking.drift_max},         {"tilt_max", stacking.tilt_max},
      {"top_drop_max", stacking.top_drop_max},   {"lost", stacking.lost},
      {"overlap_max", stacking.overlap_max},     {"ground_penetration_max", stacking.ground_penetration_max},
      {"kinetic_end", stacking.kinetic_end},     {"frozen_fraction", stacking.frozen_fraction},
      {"rest_time", or_null(stacking.rest_time)}};
  json["final_hash"] = to_string(metrics.final_hash);
  return json;
}

void print_metrics(const std::string& log, const replay::Metrics& metrics) {
  const auto& [lateral_max, lateral_rms, column_spread] = metrics.symmetry;
  const replay::EnergyMetrics& energy = metrics.energy;
  const replay::StackingMetrics& stacking = metrics.stacking;
  Listing out;
  out.add("log", log);
  out.add("bodies", std::to_string(metrics.bodies));
  out.add("steps", std::to_string(metrics.steps));
  out.section("symmetry");
  out.add("  lateral error, largest", rounded(lateral_max, "m"));
  out.add("  lateral error, rms", rounded(lateral_rms, "m"));
  out.add("  column spread", column_spread ? rounded(*column_spread, "m") : "no grid");
  out.section("energy");
  out.add("  at the start", rounded(energy.initial, "J"));
  out.add("  at the end", rounded(energy.final, "J"));
  const std::string ratio = energy.gain_ratio ? " (" + rounded(*energy.gain_ratio, "") + " of the start's)" : "";
  out.add("  largest gain", rounded(energy.gain_max, "J") + ratio);
  out.add("  removed", rounded(energy.removed, "J"));
  out.add("  put in by inputs", rounded(energy.inputs, "J"));
  out.section("stacking");
  out.add("  drift, largest", rounded(stacking.drift_max, "m"));
  out.add("  tilt, largest", rounded(stacking.tilt_max, "degrees"));
  out.add("  drop, largest", rounded(stacking.top_drop_max, "m"));
  out.add("  bodies lost", std::to_string(stacking.lost));
  out.add("  deepest overlap", rounded(stacking.overlap_max, "m"));
  out.add("  deepest in the ground", rounded(stacking.ground_penetration_max, "m"));
  out.add("  kinetic energy left", rounded(stacking.kinetic_end, "J"));
  out.add("  frozen at the end", rounded(stacking.frozen_fraction * 100, "%"));
  out.add("  at rest from", stacking.rest_time ? seconds_text(*stacking.rest_time) : "never");
  out.section("");
  out.add("final hash", to_string(metrics.final_hash));
  out.print();
}

Status SeriesFile::open(const std::string& path) {
  path_ = path;
  errno = 0;
  file_.open(path, std::ios::binary | std::ios::trunc);
  if (!file_) return bad_input("--series: " + path + ": cannot be written: " + std::strerror(errno));
  file_ << "step,time,kinetic,potential,inputs,removed,gain,lateral_max,lateral_rms,column_spread,drift_max,tilt_max,"
           "top_drop_max,lost,ground_penetration_max,frozen_fraction\n";
  return {};
}

void SeriesFile::add(const replay::SeriesRow& row) {
  const replay::StateMeasures& state = row.state;
  std::string line = std::to_string(row.step);
  for (const double value : {row.time, row.kinetic, row.potential, row.inputs, row.removed, row.gain, state.lateral_max,
                             state.lateral_rms}) {
    line += ',' + exact(value);
  }
  line += ',' + (state.column_spread ? exact(*state.column_spread) : "");
  for (const double value : {state.drift_max, state.tilt_max, state.top_drop_max}) line += ',' + exact(value);
  line += ',' + std::to_string(row.lost) + ',' + exact(state.ground_penetration_max) + ',' +
          exact(state.frozen_fraction) + '\n';
  file_ << line;
}

Status SeriesFile::close() {
  file_.close();
  if (file_) return {};
  return cannot_finish("--series: " + path_ + ": could not be written to its end (full disk?)");
}

}  // namespace tumble::tools
