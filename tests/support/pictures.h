#pragma once

#include <cstdint>
#include <functional>

#include "tumble/render/image.h"
#include "tumble/render/renderer.h"
#include "tumble/render/snapshot.h"

/// Small scenes to draw, and pictures compared.
namespace tumble::test {

/// A crate on the ground, a white cube on it and a brick beside it, seen from 8 m; nothing moves.
render::Snapshot three_boxes();

/// Draws at 160 × 120; a failure is a failure of the test, and gives an empty image.
render::Image draw(const render::Snapshot& snapshot, const render::Effects& effects = {},
                   render::Stage stage = render::Stage::kFinal, int samples = 1);

/// Effects from a list; the list must be right.
render::Effects effects(const char* list);

/// How two pictures of one size differ.
struct PictureDifference {
  std::uint64_t pixels = 0;    ///< that differ at all
  std::uint64_t far_off = 0;   ///< by more than 8 levels in a channel
  std::uint64_t brighter = 0;  ///< in a channel of the second
  std::uint64_t darker = 0;
};
PictureDifference difference(const render::Image& a, const render::Image& b);

/// Pixels that fulfil a condition on their red, green and blue.
using PixelCondition = std::function<bool(int r, int g, int b)>;
std::uint64_t count_pixels(const render::Image& image, const PixelCondition& condition);

}  // namespace tumble::test
