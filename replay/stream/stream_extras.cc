#include "replay/stream/stream_extras.h"

#include <algorithm>
#include <bit>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "replay/format/limits.h"
#include "replay/format/step_values.h"
#include "replay/stream/stream_contacts.h"
#include "replay/stream/stream_cursor.h"
#include "replay/stream/stream_names.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

// TumbleRecType of tumble_recorder.h.
enum Type : std::uint8_t { kF32 = 0, kF64 = 1, kI32 = 2, kI64 = 3, kU32 = 4, kU64 = 5, kBytes = 6, kText = 7 };

/// A value of more numbers is one of bytes: nobody reads so many channels.
constexpr std::uint32_t kCountMax = 128;

ChannelKind kind_of(const StreamChannel& channel, std::uint32_t count) {
  if (channel.type == kText) return ChannelKind::kText;
  if (channel.type == kBytes || count > kCountMax) return ChannelKind::kBytes;
  if (channel.type == kF32) return ChannelKind::kFloat32;
  if (channel.type == kF64) return ChannelKind::kFloat64;
  return channel.type == kI32 || channel.type == kI64 ? ChannelKind::kInt64 : ChannelKind::kUint64;
}

/// The channel of number k of a value: "qpos[3]", or "seed" where values have one number.
std::string name_of_number(const std::string& name, std::uint32_t k, std::uint32_t count) {
  return count == 1 ? name : name + '[' + std::to_string(k) + ']';
}

/// One step has at most so many inputs of one name and body; further ones join the last.
constexpr std::size_t kInputsMax = 64;

ChannelType told_type(std::string_view name) {
  const bool of_world = name.starts_with(std::string(kToldPrefix) + "gravity");
  return {ChannelKind::kFloat64, of_world ? ChannelScope::kWorld : ChannelScope::kBody};
}

/// A name as a channel may have it, with at most `bytes_max` bytes.
std::string name_for_channel(const std::string& name, std::size_t bytes_max) {
  std::string kept = name_for_log(name, bytes_max);
  std::ranges::replace(kept, '=', '?');
  return kept;
}

/// "input.kick", "input.kick of a body"; number n of them has "#n" behind it.
std::string name_of_input(const StreamNamedInput& input, std::size_t number) {
  const std::string behind = number == 1 ? "" : '#' + std::to_string(number);
  return name_for_channel("input." + input.name + (input.body == 0 ? "" : " of a body"),
                          kStreamNameBytesMax - behind.size()) +
         behind;
}

/// The names of the channels of the inputs of one step, in their order. Two inputs of one body have two names, also
/// where one of them is called "kick#2".
class InputNames {
 public:
  std::string name(const StreamNamedInput& input) {
    std::string name;
    for (std::size_t number = 1; number <= kInputsMax; ++number) {
      name = name_of_input(input, number);
      if (used_.emplace(name, input.body).second) break;
    }
    return name;
  }

 private:
  std::set<std::pair<std::string, std::uint64_t>> used_;
};

ChannelValue read_number(StreamCursor& in, std::uint8_t type) {
  switch (type) {
    case kF32:
      return std::bit_cast<float>(in.number<std::uint32_t>());
    case kF64:
      return in.float64();
    case kI32:
      return static_cast<std::int64_t>(static_cast<std::int32_t>(in.number<std::uint32_t>()));
    case kI64:
      return static_cast<std::int64_t>(in.number<std::uint64_t>());
    case kU32:
      return static_cast<std::uint64_t>(in.number<std::uint32_t>());
    default:
      return in.number<std::uint64_t>();
  }
}

}  // namespace

void StreamExtras::survey_channels(const StreamStep& step) {
  for (const StreamChannel& channel : step.channels) found_.try_emplace(channel.number, Found{channel, 1});
}

void StreamExtras::survey_told(const ToldValues& told) {
  for (const auto& [key, value] : told) told_.insert(key.first);
}

void StreamExtras::survey(const StreamStep& step) {
  survey_channels(step);
  contacts_.add(step.step, contacts_of(step, {}));
  for (const StreamContact& contact : step.contacts) {
    if (contact.points.empty()) contacts_.without_points(step.step, contact.a, contact.b);
  }
  add_contact_channels(step, contact_channels_);
  for (const StreamValue& value : step.values) {
    const auto found = found_.find(value.channel);
    if (found != found_.end() && value.type < kBytes) found->second.count = std::max(found->second.count, value.count);
  }
  InputNames names;
  for (const StreamInput& input : step.inputs) {
    const auto* named = std::get_if<StreamNamedInput>(&input);
    if (named == nullptr) continue;
    const ChannelScope scope = named->body == 0 ? ChannelScope::kWorld : ChannelScope::kBody;
    const std::string name = names.name(*named);
    const bool is_new = named_inputs_.try_emplace(name, ChannelType{ChannelKind::kBytes, scope}).second;
    if (is_new && name.find(named->name) == std::string::npos) note_renamed("input", named->name, name);
  }
}

void StreamExtras::note_renamed(const char* what, const std::string& name, const std::string& now) {
  const bool reads_alike = in_quotes(name) == in_quotes(now);  // each byte that is no text reads as ?
  notes_.push_back(std::string(what) + " " + (reads_alike ? "of bytes that are no text" : in_quotes(name)) +
                   " is logged as channel " + in_quotes(now) + ", for a log has each name once, in at most " +
                   std::to_string(kStreamNameBytesMax) + " bytes of text without '='");
}

std::uint32_t StreamExtras::parts_of(const Found& found) {
  return is_number(kind_of(found.channel, found.count)) ? std::max(found.count, 1U) : 1;
}

/// Gives a channel whose name a log cannot have, or has already, another one.
void StreamExtras::rename(Found& found, std::set<std::string>& taken) {
  const std::string theirs = found.channel.name;
  const std::uint32_t parts = parts_of(found);
  const std::size_t room = kStreamNameBytesMax - (parts == 1 ? 0 : std::to_string(parts - 1).size() + 2);
  const auto is_taken = [&](const std::string& name) {
    for (std::uint32_t k = 0; k < parts; ++k) {
      if (taken.contains(name_of_number(name, k, parts))) return true;
    }
    return false;
  };
  std::string name = name_for_channel(theirs, room);
  for (std::uint32_t n = 2; is_taken(name); ++n) {
    const std::string behind = '#' + std::to_string(n);
    name = name_for_channel(theirs, room - behind.size()) + behind;
  }
  for (std::uint32_t k = 0; k < parts; ++k) taken.insert(name_of_number(name, k, parts));
  if (name != theirs) note_renamed("channel", theirs, name);
  found.channel.name = name;
}

Status StreamExtras::add_rows(const StreamValue& value, std::vector<Row>& rows) const {
  const auto found = found_.find(value.channel);
  if (found == found_.end() || found->second.channel.type != value.type) {
    return bad_input("found a value of channel " + std::to_string(value.channel) + ", which was not declared so");
  }
  const auto& [channel, count] = found->second;
  const ChannelKey key = {value.a, value.b};
  if (value.type >= kBytes || count > kCountMax) {
    rows.push_back({channel.name, key, value.bytes});
    return {};
  }
  StreamCursor in(std::as_bytes(std::span(value.bytes)));
  for (std::uint32_t k = 0; k < value.count; ++k) {
    rows.push_back({name_of_number(channel.name, k, count), key, read_number(in, value.type)});
  }
  return {};
}

Result<std::vector<StreamExtras::Row>> StreamExtras::rows_of(const StreamStep& step, const EngineAxes& axes) const {
  std::vector<Row> rows;
  InputNames names;
  std::map<std::pair<std::string, sim::BodyId>, std::string> inputs;
  for (const StreamInput& input : step.inputs) {
    const auto* named = std::get_if<StreamNamedInput>(&input);
    if (named != nullptr) inputs[{names.name(*named), named->body}] += named->bytes;
  }
  const auto contacts = contacts_told(step, axes);
  rows.reserve(inputs.size() + step.values.size() + contacts.size());
  for (const auto& [key, bytes] : contacts) rows.push_back({key.first, key.second, bytes});
  for (const auto& [key, bytes] : inputs) rows.push_back({key.first, {key.second, 0}, bytes});
  for (const StreamValue& value : step.values) {
    if (Status ok = add_rows(value, rows); !ok.ok()) return ok.error();
  }
  return rows;
}

/// A log has room for kChannelsMax channels: while there are more, those with the most numbers a value become one of
/// bytes each.
void StreamExtras::fit() {
  std::size_t channels = named_inputs_.size() + told_.size() + contact_channels_.size();
  for (const auto& [number, found] : found_) channels += parts_of(found);
  std::size_t joined = 0;
  while (channels > kChannelsMax) {
    const auto by_parts = [](const auto& a, const auto& b) { return parts_of(a.second) < parts_of(b.second); };
    const auto most = std::ranges::max_element(found_, by_parts);
    if (most == found_.end() || parts_of(most->second) == 1) break;  // the log refuses them
    channels -= parts_of(most->second) - 1;
    most->second.count = kCountMax + 1;
    ++joined;
  }
  if (joined == 0) return;
  notes_.push_back(count_text(joined, "channel") + " of several numbers a value " + (joined == 1 ? "is" : "are") +
                   " logged as bytes, for a log has at most " + std::to_string(kChannelsMax) +
                   " channels of one number");
}

std::vector<std::string> StreamExtras::notes() const {
  std::vector<std::string> all = notes_;
  if (const std::string lost = contacts_.not_finite(); !lost.empty()) all.push_back(lost + "; `check` fails for it");
  for (std::string odd : {contacts_.no_direction(), contacts_.pointless()}) {
    if (!odd.empty()) all.push_back(std::move(odd));
  }
  return all;
}

Result<Declared> StreamExtras::declare(const StreamStep& start, const EngineAxes& axes, const ToldValues& told) {
  Declared declared;
  std::set<std::string> taken;
  for (std::string& name : told_names()) taken.insert(std::move(name));
  fit();
  taken.insert(told_.begin(), told_.end());
  taken.insert({kPairContacts, kGroundContacts});
  for (const auto& [name, type] : named_inputs_) taken.insert(name);
  for (auto& [number, found] : found_) {
    rename(found, taken);
    const auto& [channel, count] = found;
    const ChannelType type = {kind_of(channel, count), static_cast<ChannelScope>(channel.scope)};
    const std::uint32_t parts = parts_of(found);
    for (std::uint32_t k = 0; k < parts; ++k) {
      declared.channels.push_back({name_of_number(channel.name, k, parts), type, {}});
    }
  }
  for (const auto& [name, type] : named_inputs_) declared.channels.push_back({name, type, {}});
  for (const auto& [name, type] : contact_channels_) declared.channels.push_back({name, type, {}});
  for (const std::string& name : told_) declared.channels.push_back({name, told_type(name), {}});
  std::ranges::sort(declared.channels, {}, &Channel::name);
  for (std::size_t i = 0; i < declared.channels.size(); ++i) index_[declared.channels[i].name] = i;

  StepValues values(declared.channels);
  const Result<std::vector<Row>> rows = rows_of(start, axes);
  if (!rows.ok()) return rows.error();
  for (const Row& row : *rows) {
    if (Status ok = values.set(index_.at(row.channel), row.value, row.key); !ok.ok()) return ok.error();
  }
  for (const auto& [key, value] : told) {
    if (Status ok = values.set(index_.at(key.first), value, {key.second, 0}); !ok.ok()) return ok.error();
  }
  if (!rows->empty() || !told.empty()) values.move_to(declared.start);
  declared.start.notes = start.notes;
  declared.start.contacts = contacts_of(start, axes);
  return declared;
}

Status StreamExtras::tell(EngineLog& log, const StreamStep& step, const EngineAxes& axes,
                          const ToldValues& told) const {
  for (const auto& [key, value] : told) {
    if (Status ok = log.set_value(index_.at(key.first), value, {key.second, 0}); !ok.ok()) return ok;
  }
  const Result<std::vector<Row>> rows = rows_of(step, axes);
  if (!rows.ok()) return rows.error();
  for (const Row& row : *rows) {
    if (Status ok = log.set_value(index_.at(row.channel), row.value, row.key); !ok.ok()) return ok;
  }
  for (const EngineContact& contact : contacts_of(step, axes)) {
    if (Status ok = log.add_contact(contact); !ok.ok()) return ok;
  }
  for (const std::string& note : step.notes) {
    if (Status ok = log.add_note(note); !ok.ok()) return ok;
  }
  return {};
}

}  // namespace tumble::replay
