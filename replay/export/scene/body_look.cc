#include "replay/export/scene/body_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "src/render/scene/material_texels.h"
#include "src/render/scene/materials.h"

namespace tumble::replay {
namespace {

double encoded(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

double decoded(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

/// The only texel of the coarsest level, in linear light.
Colour4 mean_of(int layer) {
  static const std::array<Colour4, render::kLayerCount> kMeans = [] {
    std::array<Colour4, render::kLayerCount> means;
    for (int i = 0; i < render::kLayerCount; ++i) {
      const render::Texels texel = render::make_levels(i).back();
      means[static_cast<std::size_t>(i)] = {decoded(texel[0] / 255.0), decoded(texel[1] / 255.0),
                                            decoded(texel[2] / 255.0)};
    }
    return means;
  }();
  return kMeans[static_cast<std::size_t>(layer)];
}

Colour4 shown(const Colour4& mean, const Colour4& tint) {
  return {encoded(mean.r * tint.r), encoded(mean.g * tint.g), encoded(mean.b * tint.b)};
}

}  // namespace

Colour4 tint_of(const ExportBody& body) {
  render::BoxLook look;
  look.id = body.box.id;
  look.texture = body.box.material.texture;
  const render::Colour tint = render::variation_of(look).tint;
  const auto part = [](float c) { return std::clamp(static_cast<double>(c), 0.0, 1.0); };
  return {part(tint.r), part(tint.g), part(tint.b)};
}

Colour4 colour_of(const ExportBody& body) {
  return shown(mean_of(static_cast<int>(body.box.material.texture)), tint_of(body));
}

Colour4 ground_colour() { return shown(mean_of(render::kGroundLayer), {}); }

}  // namespace tumble::replay
