#include "src/render/scene/materials.h"

#include <array>

#include "src/render/scene/material_texels.h"

namespace tumble::render {
namespace {

// 0 … 1 from an id and what it is for.
float pick(std::uint64_t id, std::uint64_t purpose) {
  std::uint64_t h = (id * 4 + purpose) * 0x9E3779B97F4A7C15U;
  h = (h ^ (h >> 30U)) * 0xBF58476D1CE4E5B9U;
  h = (h ^ (h >> 27U)) * 0x94D049BB133111EBU;
  return static_cast<float>((h ^ (h >> 31U)) >> 40U) / 16777215.0F;
}

// How much brightness and warmth vary, by texture: bricks of one wall differ most, white not at all.
struct Spread {
  float brightness, warmth;
};
constexpr std::array<Spread, 5> kSpreads = {{{0.10F, 0.03F}, {0.26F, 0.08F}, {0.18F, 0.05F}, {0.10F, 0.01F}, {0, 0}}};

}  // namespace

Result<Materials> Materials::create(const Gl& gl) {
  Materials made;
  made.texture_ = GlObject::make(gl, GlObject::Kind::kTexture);
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, made.texture_.id());
  std::array<Texels, kLevelCount> all;  // each level: layer after layer
  for (int layer = 0; layer < kLayerCount; ++layer) {
    const std::array<Texels, kLevelCount> levels = make_levels(layer);
    for (std::size_t k = 0; k < kLevelCount; ++k) all[k].insert(all[k].end(), levels[k].begin(), levels[k].end());
  }
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int level = 0; level < kLevelCount; ++level) {
    const int edge = kTexelsPerEdge >> level;
    gl.TexImage3D(GL_TEXTURE_2D_ARRAY, level, GL_SRGB8_ALPHA8, edge, edge, kLayerCount, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  all[static_cast<std::size_t>(level)].data());
  }
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, kLevelCount - 1);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl.TexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
  const Status made_well = check_gl(gl, "making the materials");
  if (!made_well.ok()) return made_well.error();
  return made;
}

void Materials::bind_texture(const Gl& gl, int unit) const {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  gl.BindTexture(GL_TEXTURE_2D_ARRAY, texture_.id());
}

Variation variation_of(const BoxLook& box) {
  const Spread spread = kSpreads[static_cast<std::size_t>(box.texture)];
  const float brightness = 1 + spread.brightness * (pick(box.id, 0) * 2 - 1);
  const float warmth = spread.warmth * (pick(box.id, 1) * 2 - 1);
  return {{box.tint.r * brightness * (1 + warmth), box.tint.g * brightness, box.tint.b * brightness * (1 - warmth)},
          pick(box.id, 2),
          pick(box.id, 3)};
}

}  // namespace tumble::render
