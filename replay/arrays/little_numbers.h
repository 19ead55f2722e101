#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace tumble::replay {

/// The little-endian number of `count` bytes, at most 8, at byte `at`, which must be there.
inline std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

/// Whether `count` bytes from byte `at` on are there.
inline bool holds(std::string_view bytes, std::uint64_t at, std::uint64_t count) {
  return at <= bytes.size() && count <= bytes.size() - at;
}

}  // namespace tumble::replay
