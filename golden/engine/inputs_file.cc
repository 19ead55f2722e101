#include "golden/engine/inputs_file.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "src/base/text.h"
#include "src/model/command_fields.h"

namespace tumble::golden {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr const char* kAxes = "z up, right-handed, m, s, kg, rad";

/// A number; the text of its bits where JSON has none for it.
Json number(double value) {
  const std::string text = exact_bits(value);
  return text.find('(') == std::string::npos ? Json(value) : Json(text);
}

template <class Value>
Json value_json(const Value& value) {
  if constexpr (std::is_same_v<Value, sim::Quat>) {
    return {number(value.w), number(value.x), number(value.y), number(value.z)};
  } else if constexpr (std::is_same_v<Value, sim::Vec3>) {
    return {number(value.x()), number(value.y()), number(value.z())};
  } else if constexpr (std::is_same_v<Value, double>) {
    return number(value);
  } else {
    return value;
  }
}

std::string line_of(std::uint64_t step, const sim::Command& command) {
  Json line = {{"step", step}, {"kind", sim::name_of(command)}};
  sim::for_each_effect(command, [&](auto tag, const auto& value) { line[decltype(tag)::kName] = value_json(value); });
  return line.dump() + '\n';
}

std::string first_line(double dt, std::uint64_t steps) {
  const Json line = {{"tumble_inputs", kVersion}, {"dt", dt}, {"steps", steps}, {"axes", kAxes}};
  return line.dump() + '\n';
}

bool sets_dt(const replay::StepRecord& record) {
  for (const sim::Command& command : record.inputs) {
    if (std::holds_alternative<sim::SetDt>(command)) return true;
  }
  return false;
}

}  // namespace

Result<std::string> inputs_text(replay::LogReader& log) {
  std::string text;
  double dt = log.header().scene.world.dt;
  for (std::uint64_t k = log.first_state() + 1; k <= log.last_step(); ++k) {
    if (log.lost_at(k) != nullptr) continue;
    const Result<const replay::StepRecord*> read = log.read_hashes(k);
    if (!read.ok()) return read.error();
    const replay::StepRecord& record = **read;
    if (k == log.first_state() + 1) {
      dt = record.dt;
      text = first_line(dt, log.step_count());
    }
    if (record.dt != dt && !sets_dt(record)) text += line_of(k, sim::SetDt{record.dt});
    for (const sim::Command& command : record.inputs) text += line_of(k, command);
    dt = record.dt;
  }
  return text.empty() ? first_line(dt, 0) : text;
}

}  // namespace tumble::golden
