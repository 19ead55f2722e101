#include "tests/support/pictures.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace tumble::test {

using render::BoxLook;
using render::Image;

render::Snapshot three_boxes() {
  render::Snapshot snapshot;
  BoxLook box;
  box.half_extent = {0.5, 0.5, 0.5};
  box.id = 1;
  box.centre = {0, 0, 0.5};
  snapshot.boxes.push_back(box);
  box.id = 2;
  box.centre = {0.2, 0.1, 1.5};
  box.texture = sim::Texture::kWhite;
  snapshot.boxes.push_back(box);
  box.id = 3;
  box.centre = {1.4, 0, 0.5};
  box.texture = sim::Texture::kBrick;
  snapshot.boxes.push_back(box);
  snapshot.camera = {{3, -7, 3}, {0.5, 0, 0.9}, 40, 7.9, 1};
  snapshot.light = {{6, -6, 12}, {0, 0, 0}};
  return snapshot;
}

Image draw(const render::Snapshot& snapshot, const render::Effects& effects, render::Stage stage, int samples) {
  const Result<std::unique_ptr<render::Renderer>> renderer = render::Renderer::create({160, 120, samples, effects});
  if (!renderer.ok()) {
    ADD_FAILURE() << renderer.error().message;
    return {};
  }
  Result<Image> image = (*renderer)->draw(snapshot, stage);
  if (image.ok()) return *std::move(image);
  ADD_FAILURE() << image.error().message;
  return {};
}

render::Effects effects(const char* list) {
  const Result<render::Effects> parsed = render::parse_effects(list);
  EXPECT_TRUE(parsed.ok()) << list;
  return parsed.ok() ? *parsed : render::Effects{};
}

PictureDifference difference(const Image& a, const Image& b) {
  PictureDifference found;
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  if (a.rgb.size() != b.rgb.size()) return found;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    bool differs = false, far = false, up = false, down = false;
    for (std::size_t k = i; k < i + 3; ++k) {
      const int step = int{b.rgb[k]} - int{a.rgb[k]};
      differs = differs || step != 0;
      far = far || std::abs(step) > 8;
      up = up || step > 0;
      down = down || step < 0;
    }
    found.pixels += differs ? 1U : 0U;
    found.far_off += far ? 1U : 0U;
    found.brighter += up ? 1U : 0U;
    found.darker += down ? 1U : 0U;
  }
  return found;
}

std::uint64_t count_pixels(const Image& image, const PixelCondition& condition) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
    count += condition(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]) ? 1U : 0U;
  }
  return count;
}

}  // namespace tumble::test
