#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tumble/sim/scene.h"

/// Computes the textures of the materials. Reads no files and uses + − × ÷, sqrt and floor only, so that the texels are
/// equal on all machines.
namespace tumble::render {

/// The layers of the texture array: those of sim::Texture, then the ground.
inline constexpr int kGroundLayer = 5;
inline constexpr int kLayerCount = 6;

/// Texels along each edge of the finest level. Each further level has half as many, down to 1.
inline constexpr int kTexelsPerEdge = 256;
inline constexpr int kLevelCount = 9;

/// One level of a layer: RGBA, 8 bits per channel, colours sRGB-encoded, alpha the specular mask.
using Texels = std::vector<std::uint8_t>;

/// All levels of a layer, finest first. A coarser texel is the mean, in linear light, of four.
std::array<Texels, kLevelCount> make_levels(int layer);

}  // namespace tumble::render
