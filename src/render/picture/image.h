#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tumble::render {

inline constexpr int kSizeMin = 16;    ///< pixels, least width and height of a picture that is drawn
inline constexpr int kSizeMax = 4096;  ///< pixels, greatest width and height of a picture that is drawn or read

/// A picture: red, green, blue, 8 bits per channel, rows from the top, without padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< width × height × 3

  [[nodiscard]] static Image blank(int width, int height) {
    return {width, height,
            std::vector<std::uint8_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3)};
  }
  [[nodiscard]] std::size_t at(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3;
  }
  friend bool operator==(const Image&, const Image&) = default;
};

}  // namespace tumble::render
