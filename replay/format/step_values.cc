#include "replay/format/step_values.h"

#include <algorithm>
#include <string>

#include "replay/format/limits.h"
#include "src/base/text.h"

namespace tumble::replay {

Status StepValues::set(std::size_t channel, const ChannelValue& value, const ChannelKey& key) {
  if (channel >= channels_.size()) {
    return bad_input("found a value of channel " + std::to_string(channel) + ", wanted one of the " +
                     count_text(channels_.size(), "channel") + " that were declared");
  }
  const auto& [name, type, unit] = channels_[channel];
  const std::string named = "channel " + in_quotes(name) + ": ";
  const ChannelKind kind = kind_of(value);
  const bool fits = kind == type.kind || (kind == ChannelKind::kText && type.kind == ChannelKind::kBytes);
  if (!fits) return bad_input(named + "found a " + name_of(kind) + ", wanted a " + name_of(type.kind));
  const bool has_a = key.a != 0, has_b = key.b != 0;
  if (has_a != (type.scope != ChannelScope::kWorld) || has_b != (type.scope == ChannelScope::kPair)) {
    return bad_input(named + "found a value of bodies " + std::to_string(key.a) + " and " + std::to_string(key.b) +
                     ", wanted one of scope " + name_of(type.scope));
  }
  if (const auto* text = std::get_if<std::string>(&value); text != nullptr && text->size() > kValueBytesMax) {
    return bad_input(named + "found " + bytes_text(text->size()) + ", wanted at most " + bytes_text(kValueBytesMax));
  }
  if (!values_[channel].emplace(key, value).second) {
    return bad_input(named + "found a second value in one step" +
                     (has_a ? " for body " + std::to_string(key.a) : std::string()));
  }
  return {};
}

void StepValues::move_to(Extras& extras) {
  extras.channels.resize(channels_.size());
  for (std::size_t i = 0; i < values_.size(); ++i) {
    for (const auto& [key, value] : values_[i]) extras.channels[i].add(key, value);
    values_[i].clear();
  }
}

bool StepValues::empty() const {
  return std::ranges::all_of(values_, [](const auto& values) { return values.empty(); });
}

}  // namespace tumble::replay
