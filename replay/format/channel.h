#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "tumble/sim/ids.h"
#include "tumble/sim/result.h"

/// Channels: named values that an engine logs beside the states of its bodies, such as joint angles, controls and
/// random seeds.
namespace tumble::replay {

enum class ChannelKind : std::uint8_t {
  kFloat64 = 0,
  kFloat32 = 1,
  kInt64 = 2,
  kUint64 = 3,
  kBytes = 4,  ///< any bytes
  kText = 5    ///< UTF-8
};

/// The owner of a value.
enum class ChannelScope : std::uint8_t {
  kWorld = 0,  ///< the step as a whole: at most one value a step
  kBody = 1,   ///< at most one value a body and step
  kPair = 2    ///< at most one value a pair of bodies and step; (a, b) and (b, a) are two pairs
};

/// Kind and scope of the values of a channel.
struct ChannelType {
  ChannelKind kind = ChannelKind::kFloat64;
  ChannelScope scope = ChannelScope::kWorld;
  friend bool operator==(const ChannelType&, const ChannelType&) = default;
};

struct Channel {
  std::string name;  ///< 1 … 200 bytes of text without '=' and control characters; unique in a log
  ChannelType type;
  std::string unit = {};  ///< for people; empty without one
  friend bool operator==(const Channel&, const Channel&) = default;
};

/// "float64", "float32", "int64", "uint64", "bytes", "text"; "world", "body", "pair".
const char* name_of(ChannelKind kind);
const char* name_of(ChannelScope scope);

/// Whether values are numbers, which can have tolerances, ULPs and bounds.
inline bool is_number(ChannelKind kind) { return kind < ChannelKind::kBytes; }

/// Whether values of two channels can be compared: one scope, and one kind or numbers of both.
inline bool comparable(const ChannelType& a, const ChannelType& b) {
  return a.scope == b.scope && (a.kind == b.kind || (is_number(a.kind) && is_number(b.kind)));
}

/// The places of channels in the order in which lists for people have them: by natural_less() of their names. A log
/// has them by bytes.
std::vector<std::size_t> listed_order(const std::vector<Channel>& channels);

/// Errors (kBadInput): too many channels, a name or a unit that no log can keep, two channels of one name.
Status check_channels(const std::vector<Channel>& channels);

/// The owner of a value: none, a body `a`, or a pair.
struct ChannelKey {
  sim::BodyId a = 0;
  sim::BodyId b = 0;
  friend auto operator<=>(const ChannelKey&, const ChannelKey&) = default;
};

/// A value of a channel. kBytes and kText: std::string.
using ChannelValue = std::variant<double, float, std::int64_t, std::uint64_t, std::string>;

/// The kind whose values have this type; kText for std::string.
ChannelKind kind_of(const ChannelValue& value);

/// Exact: floats and doubles with the fewest digits that read back, "nan(0x…)" with all bits; the first bytes of bytes
/// in hexadecimal with their number; text as it is.
std::string to_string(const ChannelValue& value, ChannelKind kind);

/// The value as a number; NaN for bytes and text.
double number_of(const ChannelValue& value);

/// How far two numbers are apart: of two whole numbers their exact distance, rounded once to the nearest double. NaN
/// where one is none.
double distance_between(const ChannelValue& a, const ChannelValue& b);

/// Whether number_of() is another number: a whole number beyond 2^53 that no double is.
bool is_rounded(const ChannelValue& value);

/// The values of one channel in one step: one row each, by ascending key.
struct ChannelValues {
  std::vector<ChannelKey> keys;
  std::vector<std::uint64_t> bits;  ///< of numbers; a float in the low half
  std::vector<std::string> bytes;   ///< of bytes and text

  [[nodiscard]] std::size_t size() const { return keys.size(); }
  [[nodiscard]] bool empty() const { return keys.empty(); }
  [[nodiscard]] ChannelValue value(std::size_t row, ChannelKind kind) const;
  void clear();
  /// Adds a row, whose key must come after the last one's.
  void add(const ChannelKey& key, const ChannelValue& value);
  friend bool operator==(const ChannelValues&, const ChannelValues&) = default;
};

}  // namespace tumble::replay
