#include "replay/log/told_values.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::array<std::string_view, 37> kToldNames = {"mass",
                                                         "friction",
                                                         "restitution",
                                                         "radius",
                                                         "length",
                                                         "size.x",
                                                         "size.y",
                                                         "size.z",
                                                         "gravity.x",
                                                         "gravity.y",
                                                         "gravity.z",
                                                         "position.x",
                                                         "position.y",
                                                         "position.z",
                                                         "velocity.x",
                                                         "velocity.y",
                                                         "velocity.z",
                                                         "spin.x",
                                                         "spin.y",
                                                         "spin.z",
                                                         "orientation.w",
                                                         "orientation.x",
                                                         "orientation.y",
                                                         "orientation.z",
                                                         "set_velocity.x",
                                                         "set_velocity.y",
                                                         "set_velocity.z",
                                                         "set_spin.x",
                                                         "set_spin.y",
                                                         "set_spin.z",
                                                         "push.x",
                                                         "push.y",
                                                         "push.z",
                                                         "state.orientation.w",
                                                         "state.orientation.x",
                                                         "state.orientation.y",
                                                         "state.orientation.z"};

/// Whether an engine may mean a value: what it means is its own affair, unless it is none at all.
bool is_possible(std::string_view name, double value) {
  // A finite number of an orientation: its length is not 1.
  if (!std::isfinite(value) || name.find("orientation.") != std::string_view::npos) return false;
  const bool is_signed = name.find('.') != std::string_view::npos && !name.starts_with("size.");
  return is_signed || value >= 0;
}

std::string sentence(const std::string& name, sim::BodyId body, std::uint64_t step, double value) {
  const std::string owner = body == 0 ? "the world" : "body " + std::to_string(body);
  return owner + " was told " + name + " " + number_text(value) + " at step " + std::to_string(step) + " (channel " +
         std::string(kToldPrefix) + name + ")";
}

std::string and_more(std::uint64_t count) {
  return count > 1 ? ", and " + count_text(count - 1, "more such value") : "";
}

}  // namespace

bool is_told_name(std::string_view name) {
  if (!name.starts_with(kToldPrefix)) return false;
  name.remove_prefix(kToldPrefix.size());
  return std::ranges::find(kToldNames, name.substr(0, name.find('#'))) != kToldNames.end();
}

std::vector<std::string> told_names() {
  std::vector<std::string> names;
  names.reserve(kToldNames.size());
  for (const std::string_view name : kToldNames) names.push_back(std::string(kToldPrefix).append(name));
  return names;
}

ToldWatch::ToldWatch(const LogHeader& header) {
  if (!header.engine) return;
  for (std::size_t i = 0; i < header.declared.channels.size(); ++i) {
    const Channel& channel = header.declared.channels[i];
    if (is_told_name(channel.name) && channel.type.kind == ChannelKind::kFloat64) {
      channels_.emplace_back(i, channel.name.substr(kToldPrefix.size()));
    }
  }
}

void ToldWatch::add(std::uint64_t step, const Extras& extras) {
  for (const auto& [index, told_name] : channels_) {
    const ChannelValues& values = extras.values(index);
    const std::string& name = told_name;  // clang lets no lambda see a structured binding
    for (std::size_t row = 0; row < values.size(); ++row) {
      const double value = number_of(values.value(row, ChannelKind::kFloat64));
      const auto count = [&](Found& found) {
        if (found.count++ == 0) found.text = sentence(name, values.keys[row].a, step, value);
      };
      count(all_);
      if (!is_possible(name, value)) count(impossible_);
    }
  }
}

std::string ToldWatch::impossible() const {
  if (impossible_.count == 0) return "";
  return std::string(kToldImpossible) + ": " + impossible_.text + and_more(impossible_.count);
}

std::string ToldWatch::note() const {
  if (all_.count == 0) return "";
  return std::string(kToldNote) + ": " + all_.text + and_more(all_.count);
}

}  // namespace tumble::replay
