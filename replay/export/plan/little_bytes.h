#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace tumble::replay {

/// Appends the little-endian number in `count` bytes; zeros beyond the eighth.
inline void append_little(std::uint64_t value, std::size_t count, std::string& bytes) {
  for (std::size_t i = 0; i < count; ++i) {
    bytes += static_cast<char>(static_cast<unsigned char>(i < 8 ? value >> (8 * i) : 0));
  }
}

}  // namespace tumble::replay
