#include "tumble/replay/channel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "replay/format/limits.h"
#include "src/base/check.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::array<const char*, 6> kKindNames = {"float64", "float32", "int64", "uint64", "bytes", "text"};
constexpr std::array<const char*, 3> kScopeNames = {"world", "body", "pair"};
constexpr std::size_t kBytesShown = 16;

bool is_text(const std::string& text) { return printable(text) == text; }

std::string float_text(float value) {
  if (!std::isfinite(value)) return exact_bits(value);
  std::array<char, 40> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value);
  return {digits.data(), end.ptr};
}

struct Whole {
  bool is_negative = false;
  std::uint64_t size = 0;
};

std::optional<Whole> whole_of(const ChannelValue& value) {
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return Whole{false, *number};
  const auto* number = std::get_if<std::int64_t>(&value);
  if (number == nullptr) return std::nullopt;
  const auto bits = static_cast<std::uint64_t>(*number);
  return Whole{*number < 0, *number < 0 ? 0 - bits : bits};
}

std::string hex_text(const std::string& bytes) {
  std::string text = count_text(bytes.size(), "byte");
  if (!bytes.empty()) text += ' ' + hex_digits(std::string_view(bytes).substr(0, kBytesShown));
  return bytes.size() > kBytesShown ? text + "…" : text;
}

}  // namespace

const char* name_of(ChannelKind kind) {
  const auto index = static_cast<std::size_t>(kind);
  return index < kKindNames.size() ? kKindNames[index] : "unknown kind";
}

const char* name_of(ChannelScope scope) {
  const auto index = static_cast<std::size_t>(scope);
  return index < kScopeNames.size() ? kScopeNames[index] : "unknown scope";
}

std::vector<std::size_t> listed_order(const std::vector<Channel>& channels) {
  return natural_order(channels, &Channel::name);
}

Status check_channels(const std::vector<Channel>& channels) {
  if (channels.size() > kChannelsMax) {
    return bad_input("found " + std::to_string(channels.size()) + " channels, wanted at most " +
                     std::to_string(kChannelsMax));
  }
  std::vector<std::string> names;
  for (const Channel& channel : channels) {
    const std::string named = "channel " + in_quotes(channel.name) + ": ";
    if (channel.name.empty() || channel.name.size() > kColumnNameBytesMax || !is_text(channel.name) ||
        channel.name.find('=') != std::string::npos) {
      return bad_input(named + "wanted a name of 1 to " + std::to_string(kColumnNameBytesMax) +
                       " bytes of text, without '=' and control characters");
    }
    if (channel.unit.size() > kColumnNameBytesMax || !is_text(channel.unit)) {
      return bad_input(named + "wanted a unit of at most " + std::to_string(kColumnNameBytesMax) + " bytes of text");
    }
    if (channel.type.kind > ChannelKind::kText || channel.type.scope > ChannelScope::kPair) {
      return bad_input(named + "found kind " + std::to_string(static_cast<unsigned>(channel.type.kind)) +
                       " and scope " + std::to_string(static_cast<unsigned>(channel.type.scope)) +
                       ", which this program does not know");
    }
    names.push_back(channel.name);
  }
  std::ranges::sort(names);
  const auto twice = std::ranges::adjacent_find(names);
  if (twice == names.end()) return {};
  return bad_input("channel " + in_quotes(*twice) + ": found twice, wanted names that differ");
}

ChannelKind kind_of(const ChannelValue& value) {
  return std::holds_alternative<std::string>(value) ? ChannelKind::kText : static_cast<ChannelKind>(value.index());
}

std::string to_string(const ChannelValue& value, ChannelKind kind) {
  if (const auto* number = std::get_if<double>(&value)) return exact_bits(*number);
  if (const auto* number = std::get_if<float>(&value)) return float_text(*number);
  if (const auto* number = std::get_if<std::int64_t>(&value)) return std::to_string(*number);
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return std::to_string(*number);
  const std::string& bytes = std::get<std::string>(value);
  return kind == ChannelKind::kBytes ? hex_text(bytes) : bytes;
}

double number_of(const ChannelValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* number = std::get_if<float>(&value)) return *number;
  if (const auto* number = std::get_if<std::int64_t>(&value)) return static_cast<double>(*number);
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return static_cast<double>(*number);
  return std::numeric_limits<double>::quiet_NaN();
}

double distance_between(const ChannelValue& a, const ChannelValue& b) {
  const std::optional<Whole> x = whole_of(a), y = whole_of(b);
  if (!x || !y) return std::fabs(number_of(a) - number_of(b));
  if (x->is_negative == y->is_negative) {
    return static_cast<double>(std::max(x->size, y->size) - std::min(x->size, y->size));
  }
  const std::uint64_t sum = x->size + y->size;
  if (sum >= x->size) return static_cast<double>(sum);
  // 2^64 and more: its half, in which a 1 for the bit that is lost rounds as the sum would.
  return 2 * static_cast<double>(1ULL << 63U | sum >> 1U | (sum & 1U));
}

bool is_rounded(const ChannelValue& value) {
  const std::optional<Whole> whole = whole_of(value);
  if (!whole || whole->size == 0) return false;
  const int digits = static_cast<int>(std::bit_width(whole->size)) - std::countr_zero(whole->size);
  return digits > std::numeric_limits<double>::digits;
}

ChannelValue ChannelValues::value(std::size_t row, ChannelKind kind) const {
  SIM_CHECK(row < size(), row, size());
  switch (kind) {
    case ChannelKind::kFloat64:
      return std::bit_cast<double>(bits[row]);
    case ChannelKind::kFloat32:
      return std::bit_cast<float>(static_cast<std::uint32_t>(bits[row]));
    case ChannelKind::kInt64:
      return static_cast<std::int64_t>(bits[row]);
    case ChannelKind::kUint64:
      return bits[row];
    case ChannelKind::kBytes:
    case ChannelKind::kText:
      break;
  }
  return bytes[row];
}

void ChannelValues::clear() {
  keys.clear();
  bits.clear();
  bytes.clear();
}

void ChannelValues::add(const ChannelKey& key, const ChannelValue& value) {
  SIM_CHECK(keys.empty() || keys.back() < key, keys.size(), key.a, key.b);
  keys.push_back(key);
  if (const auto* text = std::get_if<std::string>(&value)) {
    bytes.push_back(*text);
  } else if (const auto* wide = std::get_if<double>(&value)) {
    bits.push_back(std::bit_cast<std::uint64_t>(*wide));
  } else if (const auto* narrow = std::get_if<float>(&value)) {
    bits.push_back(std::bit_cast<std::uint32_t>(*narrow));
  } else if (const auto* number = std::get_if<std::int64_t>(&value)) {
    bits.push_back(static_cast<std::uint64_t>(*number));
  } else {
    bits.push_back(std::get<std::uint64_t>(value));
  }
}

}  // namespace tumble::replay
