#pragma once

#include <cstdint>

#include "src/render/picture/image.h"

namespace tumble::render {

/// Levels (of 255) that a channel may be off before its pixel counts as far off: what another version of the driver
/// does to a pixel here and there; what a defect does to hundreds.
inline constexpr int kFarOffLevels = 8;

/// How two pictures of one size differ.
struct ImageDifference {
  std::uint64_t pixels = 0;   ///< that differ at all
  std::uint64_t far_off = 0;  ///< of these, in a channel by more than kFarOffLevels
  int largest = 0;            ///< levels, of any channel
  [[nodiscard]] bool equal() const { return pixels == 0; }
};

/// Precondition: both have the same width and height.
ImageDifference difference_of(const Image& expected, const Image& actual);

/// The expected picture dimmed to a quarter, and over it what differs: pixels that are far off from yellow to red by
/// how much, others that differ in blue. Readable without colour vision: the farther off, the brighter against the
/// rest.
Image difference_map(const Image& expected, const Image& actual);

}  // namespace tumble::render
