#include "tumble/replay/field_value.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include "replay/codec/state_keys.h"

namespace tumble::replay {

std::string to_string(const FieldValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<std::uint64_t>(&value)) return std::to_string(*number);
  if (std::holds_alternative<std::monostate>(value)) return "not there";
  std::array<char, 40> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), std::get<double>(value),
                                 std::chars_format::general, 17);
  return {digits.data(), end.ptr};
}

bool same_bits(const FieldValue& a, const FieldValue& b) {
  const auto* x = std::get_if<double>(&a);
  const auto* y = std::get_if<double>(&b);
  return x != nullptr && y != nullptr ? bits_of(*x) == bits_of(*y) : a == b;
}

// Read as an integer, the bits of a positive double grow with its value, one for each representable double; those of a
// negative one shrink. ordered() turns the negative half around, so the distance of two keys counts the doubles
// between.
std::optional<std::uint64_t> ulps_between(double a, double b) {
  if (a != a || b != b) return std::nullopt;
  const std::uint64_t key_a = codec1::ordered(bits_of(a));
  const std::uint64_t key_b = codec1::ordered(bits_of(b));
  return key_a > key_b ? key_a - key_b : key_b - key_a;
}

std::optional<std::uint64_t> ulps32_between(double a, double b) {
  constexpr double kMax = std::numeric_limits<float>::max();
  if (!(std::fabs(a) <= kMax && std::fabs(b) <= kMax)) return std::nullopt;
  const auto key = [](double value) {  // ascending with the value; the negative ones mirrored
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(value));
    return (bits >> 31) != 0 ? ~bits : bits | 0x80000000U;
  };
  const std::uint32_t key_a = key(a), key_b = key(b);
  if (key_a == key_b && bits_of(a) != bits_of(b)) return ulps_between(a, b);  // apart by less than a float
  return key_a > key_b ? key_a - key_b : key_b - key_a;
}

}  // namespace tumble::replay
