#include "tumble/golden/expected_extras.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "replay/diff/channel_difference.h"
#include "src/base/text.h"
#include "tumble/replay/divergence.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {
namespace {

// Limit for the values of one golden before compression, bytes; hashes are kept of every state.
constexpr std::size_t kValuesBytes = 200'000;
constexpr std::size_t kRowBytes = 8;
constexpr std::size_t kNamesShown = 12;
constexpr const char* kContacts = "contacts";
constexpr const char* kChannelPrefix = "channel.";

std::size_t bytes_of(const replay::ChannelValues& values) {
  std::size_t bytes = values.size() * kRowBytes;
  for (const std::string& text : values.bytes) bytes += text.size();
  return bytes;
}

/// Whole numbers below this are doubles to the bit.
constexpr double kWholeMax = 9007199254740992.0;  // 2^53

std::uint64_t canonical_bits(const replay::ChannelValues& values, std::size_t row, replay::ChannelKind kind) {
  const double number = replay::number_of(values.value(row, kind));
  const bool is_integer = kind == replay::ChannelKind::kInt64 || kind == replay::ChannelKind::kUint64;
  if (is_integer && std::fabs(number) >= kWholeMax) return values.bits[row];
  return std::bit_cast<std::uint64_t>(number);
}

void add_text(Hasher& hasher, const std::string& text) {
  hasher.add(std::uint64_t{text.size()});
  hasher.add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

std::uint32_t hash_of_contacts(const replay::Extras& extras) {
  if (extras.contacts.empty()) return 0;
  replay::Extras contacts;
  contacts.contacts = extras.contacts;
  return static_cast<std::uint32_t>(replay::hash_of(contacts).low);
}

std::string kind_text(const replay::ChannelType& type) {
  return std::string(name_of(type.kind)) + " of scope " + name_of(type.scope);
}

}  // namespace

std::uint32_t hash_of_values(const replay::ChannelValues& values, replay::ChannelKind kind) {
  if (values.empty()) return 0;
  Hasher hasher;
  for (std::size_t i = 0; i < values.size(); ++i) {
    hasher.add(values.keys[i].a);
    hasher.add(values.keys[i].b);
    if (is_number(kind)) {
      hasher.add(canonical_bits(values, i, kind));
    } else {
      add_text(hasher, values.bytes[i]);
    }
  }
  return static_cast<std::uint32_t>(hasher.digest().low);
}

ExtrasKeeper::ExtrasKeeper(const std::vector<replay::Channel>& channels) {
  for (const replay::Channel& channel : channels) {
    extras_.channels.emplace_back();
    extras_.channels.back().channel = channel;
  }
}

void ExtrasKeeper::add(const replay::StepRecord& record) {
  for (std::size_t i = 0; i < extras_.channels.size(); ++i) {
    ExpectedChannel& channel = extras_.channels[i];
    const replay::ChannelValues& values = record.extras.values(i);
    channel.hashes.push_back(hash_of_values(values, channel.channel.type.kind));
    if (values.empty() || record.step % stride_ != 0) continue;
    bytes_ += bytes_of(values);
    channel.values.push_back({record.step, values});
  }
  any_contact_ = any_contact_ || !record.extras.contacts.empty();
  extras_.contact_hashes.push_back(hash_of_contacts(record.extras));
  while (bytes_ > kValuesBytes) thin_out();
}

/// Keeps the values of every other step that has any. Ends where one step is too large: then none are kept.
void ExtrasKeeper::thin_out() {
  stride_ *= 2;
  bytes_ = 0;
  const bool one_is_too_large = stride_ > extras_.contact_hashes.size();
  for (ExpectedChannel& channel : extras_.channels) {
    std::erase_if(channel.values, [&](const KeptValues& kept) { return one_is_too_large || kept.step % stride_ != 0; });
    for (const KeptValues& kept : channel.values) bytes_ += bytes_of(kept.values);
  }
}

ExpectedExtras ExtrasKeeper::finish() {
  if (!any_contact_) extras_.contact_hashes.clear();
  return std::move(extras_);
}

ExtrasComparer::ExtrasComparer(const ExpectedExtras& expected, const std::vector<replay::Channel>& channels)
    : expected_(expected) {
  for (const ExpectedChannel& channel : expected.channels) {
    const auto found = std::ranges::find(channels, channel.channel.name, &replay::Channel::name);
    const bool is_there = found != channels.end();
    pairs_.push_back({&channel, is_there ? std::optional<std::size_t>(found - channels.begin()) : std::nullopt,
                      is_there ? *found : channel.channel});
  }
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const bool is_known = std::ranges::any_of(
        expected.channels, [&](const ExpectedChannel& known) { return known.channel.name == channels[i].name; });
    if (!is_known) pairs_.push_back({nullptr, i, channels[i]});
  }
  std::ranges::sort(pairs_, {}, [](const Pair& pair) { return pair.channel.name; });
}

std::vector<std::string> ExtrasComparer::differing(const replay::StepRecord& record) const {
  std::vector<std::string> fields;
  for (const Pair& pair : pairs_) {
    std::uint32_t expected = 0, actual = 0;
    if (pair.expected != nullptr && record.step < pair.expected->hashes.size()) {
      expected = pair.expected->hashes[record.step];
    }
    if (pair.actual) actual = hash_of_values(record.extras.values(*pair.actual), pair.channel.type.kind);
    const bool same_type = pair.expected == nullptr || comparable(pair.expected->channel.type, pair.channel.type);
    if (expected != actual || !same_type) fields.push_back(kChannelPrefix + pair.channel.name);
  }
  const std::vector<std::uint32_t>& contacts = expected_.contact_hashes;
  const std::uint32_t expected = record.step < contacts.size() ? contacts[record.step] : 0;
  if (expected != hash_of_contacts(record.extras)) fields.emplace_back(kContacts);
  return fields;
}

std::string ExtrasComparer::detail(const std::string& field, const replay::StepRecord& record,
                                   const replay::BodyTable& names) const {
  if (field == kContacts) {
    return "at step " + std::to_string(record.step) + ", " + count_text(record.extras.contacts.size(), "contact") +
           ": one at least has another value, or there were others";
  }
  const auto pair =
      std::ranges::find_if(pairs_, [&](const Pair& each) { return kChannelPrefix + each.channel.name == field; });
  if (pair == pairs_.end()) return "";
  if (pair->expected == nullptr) return field + ": the golden has no such channel";
  if (!pair->actual) return field + ": the session has no such channel";
  const replay::Channel& before = pair->expected->channel;
  if (!comparable(before.type, pair->channel.type)) {
    return field + ": expected " + kind_text(before.type) + ", actual " + kind_text(pair->channel.type);
  }
  const auto kept = std::ranges::find(pair->expected->values, record.step, &KeptValues::step);
  const bool none_expected = record.step < pair->expected->hashes.size() && pair->expected->hashes[record.step] == 0;
  if (kept == pair->expected->values.end() && !none_expected) return "";
  replay::StepRecord wanted;
  wanted.step = record.step;
  if (!none_expected) wanted.extras.channels = {kept->values};
  replay::ChannelMatch match;
  match.contacts = false;
  match.compared = {{before.name, before.type, pair->channel.type.kind, before.unit, 0, *pair->actual}};
  const std::optional<replay::Divergence> found = first_extra_difference(match, wanted, record, {});
  if (!found) return "";
  std::string of;
  if (found->body) of = " of " + names.text(*found->body);
  if (found->pair) {
    constexpr std::size_t kWord = 5;  // bytes of "body "
    const auto text = [&](sim::BodyId id) { return names.text(id).substr(kWord); };
    of = " of the pair " + text(found->pair->first) + " and " +
         (found->pair->second == 0 ? "the world" : text(found->pair->second));
  }
  std::string text = "at step " + std::to_string(record.step) + ", " + field + of + ": expected " +
                     replay::to_string(found->expected) + ", actual " + replay::to_string(found->actual);
  if (!before.unit.empty()) text += " " + before.unit;
  if (found->ulps) text += " (" + count_text(*found->ulps, "ULP") + " apart)";
  return text;
}

std::vector<std::string> ExtrasComparer::lost() const {
  std::vector<std::string> sentences;
  for (const Pair& pair : pairs_) {
    const std::string field = kChannelPrefix + pair.channel.name;
    const bool is_input = pair.channel.name.starts_with("input.");
    if (pair.expected == nullptr && is_input) sentences.push_back(field + ": the golden has no such input");
    if (pair.expected == nullptr) continue;
    if (!pair.actual) {
      sentences.push_back(field + ": the session has no such channel");
    } else if (const replay::ChannelType& before = pair.expected->channel.type;
               !comparable(before, pair.channel.type)) {
      sentences.push_back(field + ": expected " + kind_text(before) + ", actual " + kind_text(pair.channel.type));
    }
  }
  return sentences;
}

std::vector<std::string> ExtrasComparer::compared() const {
  std::vector<std::string> parts;
  if (!pairs_.empty()) {
    std::string text = count_text(pairs_.size(), "channel") + " (";
    for (std::size_t i = 0; i < std::min(kNamesShown, pairs_.size()); ++i) {
      text += (i == 0 ? "" : ", ") + pairs_[i].channel.name;
    }
    parts.push_back(text + (pairs_.size() > kNamesShown ? ", …)" : ")"));
  }
  if (!expected_.contact_hashes.empty()) parts.emplace_back("contacts of the engine");
  return parts;
}

}  // namespace tumble::golden
