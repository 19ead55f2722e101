#include "replay/stream/stream_contacts.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <set>

#include "replay/format/little_endian.h"

namespace tumble::replay {
namespace {

using Pair = std::pair<std::uint64_t, std::uint64_t>;

/// Whether points say all of a contact.
bool is_all_points(const StreamContact& contact) { return contact.part == 0 && !contact.points.empty(); }

const char* channel_of(const StreamContact& contact) { return contact.b == 0 ? kGroundContacts : kPairContacts; }

template <class Number>
void append(std::string& bytes, Number number) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(Number));
  store(reinterpret_cast<std::byte*>(bytes.data()) + at, number);
}

}  // namespace

std::vector<EngineContact> contacts_of(const StreamStep& step, const EngineAxes& axes) {
  std::vector<EngineContact> contacts;
  for (const StreamContact& contact : step.contacts) {
    const sim::Vec3 normal = axes.direction(contact.normal);
    for (const StreamPoint& point : contact.points) {
      contacts.push_back({contact.a, contact.b, axes.length(point.position), normal, point.depth * axes.metres,
                          point.impulse * axes.metres});
    }
  }
  std::ranges::stable_sort(contacts, {}, [](const EngineContact& c) { return std::pair(c.a, c.b); });
  return contacts;
}

std::map<std::pair<std::string, ChannelKey>, std::string> contacts_told(const StreamStep& step,
                                                                        const EngineAxes& axes) {
  std::map<std::pair<std::string, ChannelKey>, std::string> values;
  std::set<Pair> pairs;
  for (const StreamContact& contact : step.contacts) {
    if (!is_all_points(contact)) pairs.emplace(contact.a, contact.b);
  }
  if (pairs.empty()) return values;
  for (const StreamContact& contact : step.contacts) {
    if (!pairs.contains({contact.a, contact.b})) continue;
    std::string& bytes = values[{channel_of(contact), ChannelKey{contact.a, contact.b}}];
    append(bytes, contact.part);
    append(bytes, static_cast<std::uint32_t>(contact.points.size()));
    if (!contact.points.empty()) continue;
    const sim::Vec3 normal = axes.direction(contact.normal);
    for (int k = 0; k < 3; ++k) append(bytes, std::bit_cast<std::uint64_t>(normal[k]));
  }
  return values;
}

void add_contact_channels(const StreamStep& step, std::map<std::string, ChannelType>& channels) {
  for (const StreamContact& contact : step.contacts) {
    if (is_all_points(contact)) continue;
    const ChannelScope scope = contact.b == 0 ? ChannelScope::kBody : ChannelScope::kPair;
    channels.try_emplace(channel_of(contact), ChannelType{ChannelKind::kBytes, scope});
  }
}

}  // namespace tumble::replay
