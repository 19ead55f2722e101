#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

/// Stores and loads numbers as little-endian bytes on every machine.
namespace tumble::replay {

template <std::unsigned_integral T>
T to_little(T value) {
  if constexpr (std::endian::native == std::endian::little || sizeof(T) == 1) return value;
  T swapped = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i) swapped = static_cast<T>((swapped << 8) | ((value >> (8 * i)) & 0xff));
  return swapped;
}

template <std::unsigned_integral T>
void store(std::byte* at, T value) {
  const T little = to_little(value);
  std::memcpy(at, &little, sizeof(T));
}

template <std::unsigned_integral T>
T load(const std::byte* at) {
  T little = 0;
  std::memcpy(&little, at, sizeof(T));
  return to_little(little);
}

inline std::uint64_t bits_of(double value) { return std::bit_cast<std::uint64_t>(value); }
inline double double_of(std::uint64_t bits) { return std::bit_cast<double>(bits); }

}  // namespace tumble::replay
