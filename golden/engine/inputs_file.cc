#include "golden/engine/inputs_file.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

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

/// The name that the engine gave an input, whose channel is "input.NAME", "input.NAME of a body" or one of these with
/// "#2" behind it; empty for a channel of something else.
std::string input_of(const replay::Channel& channel) {
  constexpr std::string_view kBefore = "input.", kBehind = " of a body";
  std::string_view name = channel.name;
  const bool of_pair = channel.type.scope == replay::ChannelScope::kPair;
  if (!name.starts_with(kBefore) || channel.type.kind != replay::ChannelKind::kBytes || of_pair) return "";
  name.remove_prefix(kBefore.size());
  const std::size_t mark = name.rfind('#');
  const bool counted = mark != std::string_view::npos && mark + 1 < name.size() &&
                       name.find_first_not_of("0123456789", mark + 1) == std::string_view::npos;
  if (counted) name = name.substr(0, mark);
  if (channel.type.scope == replay::ChannelScope::kBody && name.ends_with(kBehind)) {
    name.remove_suffix(kBehind.size());
  }
  return std::string(name);
}

/// The inputs that the recorder got by their names, which a log keeps as channels: by name and body, several of one
/// name and body in their order.
std::string named_inputs(std::uint64_t step, const std::vector<replay::Channel>& channels,
                         const replay::Extras& extras) {
  struct Input {
    std::string name;
    std::uint64_t body = 0;
    std::size_t name_length = 0;  // of its channel: "#10" comes behind "#9"
    std::size_t channel = 0;
    std::string bytes;
  };
  std::vector<Input> inputs;
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::string name = input_of(channels[c]);
    const replay::ChannelValues& values = extras.values(c);
    for (std::size_t i = 0; i < values.size() && !name.empty(); ++i) {
      inputs.push_back({name, values.keys[i].a, channels[c].name.size(), c, values.bytes[i]});
    }
  }
  std::ranges::sort(inputs, {}, [](const Input& input) {
    return std::tie(input.name, input.body, input.name_length, input.channel);
  });
  std::string text;
  for (const Input& input : inputs) {
    Json line = {{"step", step}, {"kind", "input"}, {"name", input.name}};
    if (input.body != 0) line["id"] = input.body;
    line["hex"] = hex_digits(input.bytes);
    text += line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  }
  return text;
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
  const replay::Declared& declared = log.header().declared;
  double dt = log.header().scene.world.dt;
  for (std::uint64_t k = log.first_state() + 1; k <= log.last_step(); ++k) {
    if (log.lost_at(k) != nullptr) continue;
    const Result<const replay::StepRecord*> read = log.read_hashes(k);
    if (!read.ok()) return read.error();
    const replay::StepRecord& record = **read;
    if (k == log.first_state() + 1) {
      dt = record.dt;
      text = first_line(dt, log.step_count()) + named_inputs(log.first_state(), declared.channels, declared.start);
    }
    if (record.dt != dt && !sets_dt(record)) text += line_of(k, sim::SetDt{record.dt});
    for (const sim::Command& command : record.inputs) text += line_of(k, command);
    text += named_inputs(k, declared.channels, record.extras);
    dt = record.dt;
  }
  return text.empty() ? first_line(dt, 0) : text;
}

}  // namespace tumble::golden
