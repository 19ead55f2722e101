#pragma once

#include <cstdint>

#include "tumble/render/image.h"

namespace tumble::render {

/// Levels (of 255) by which a channel may differ before its pixel counts as far off. Another version of the driver
/// changes single pixels by more, a defect changes hundreds.
inline constexpr int kFarOffLevels = 8;

/// How two pictures of one size differ.
struct ImageDifference {
  std::uint64_t pixels = 0;   ///< pixels that differ
  std::uint64_t far_off = 0;  ///< pixels with a channel that differs by more than kFarOffLevels
  int largest = 0;            ///< levels, the largest difference of a channel
  [[nodiscard]] bool equal() const { return pixels == 0; }
};

/// Compares two pictures. Precondition (SIM_CHECK): equal width and height.
ImageDifference difference_of(const Image& expected, const Image& actual);

/// The expected picture, dimmed to a quarter, with the differing pixels in colour: yellow to red where far off, by the
/// size of the difference, else blue. Readable without colour vision, because larger differences are brighter.
/// Precondition (SIM_CHECK): equal width and height.
Image difference_map(const Image& expected, const Image& actual);

}  // namespace tumble::render
