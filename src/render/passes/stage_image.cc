#include "src/render/passes/stage_image.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tumble::render {
namespace {

std::uint8_t to_byte(double x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0, 1.0) * 255)); }

// GL's rows go upwards, an image's downwards.
template <class Pixel>
Image flipped(const RenderTarget& target, const Pixel& pixel_at) {
  Image image = Image::blank(target.width(), target.height());
  std::size_t from = 0;
  for (int y = image.height - 1; y >= 0; --y) {
    for (int x = 0; x < image.width; ++x, ++from) {
      const std::size_t to = image.at(x, y);
      for (std::size_t k = 0; k < 3; ++k) image.rgb[to + k] = pixel_at(from, k);
    }
  }
  return image;
}

std::size_t pixel_count(const RenderTarget& target) {
  return static_cast<std::size_t>(target.width()) * static_cast<std::size_t>(target.height());
}

template <class T>
std::vector<T> read(const Gl& gl, const RenderTarget& target, GLenum format, GLenum type, std::size_t channels) {
  std::vector<T> values(pixel_count(target) * channels);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  target.bind(gl);
  gl.ReadPixels(0, 0, target.width(), target.height(), format, type, values.data());
  return values;
}

}  // namespace

Image read_bytes(const Gl& gl, const RenderTarget& target, Channels channels) {
  const auto texels = read<std::uint8_t>(gl, target, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, 4);
  if (channels == Channels::kAlpha) {
    return flipped(target, [&](std::size_t i, std::size_t /*k*/) { return texels[i * 4 + 3]; });
  }
  return flipped(target, [&](std::size_t i, std::size_t k) { return texels[i * 4 + k]; });
}

Image read_floats(const Gl& gl, const RenderTarget& target, Channels channels) {
  const auto texels = read<float>(gl, target, GL_RGBA, GL_FLOAT, 4);
  if (channels == Channels::kAlpha) {
    return flipped(target, [&](std::size_t i, std::size_t /*k*/) { return to_byte(texels[i * 4 + 3]); });
  }
  return flipped(target, [&](std::size_t i, std::size_t k) {
    return to_byte(std::sqrt(std::max(0.0, static_cast<double>(texels[i * 4 + k]))));
  });
}

Image read_depth(const Gl& gl, const RenderTarget& map, const View& light) {
  const auto depths = read<float>(gl, map, GL_DEPTH_COMPONENT, GL_FLOAT, 1);
  std::vector<double> distance(depths.size());
  double nearest = light.far, farthest = light.near;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const double clip = static_cast<double>(depths[i]) * 2 - 1;
    distance[i] = 2 * light.far * light.near / (light.far + light.near - clip * (light.far - light.near));
    if (depths[i] >= 1) continue;
    nearest = std::min(nearest, distance[i]);
    farthest = std::max(farthest, distance[i]);
  }
  const double span = std::max(farthest - nearest, 1e-9);
  return flipped(map, [&](std::size_t i, std::size_t /*k*/) {
    return depths[i] >= 1 ? std::uint8_t{255} : to_byte(0.9 * (distance[i] - nearest) / span);
  });
}

}  // namespace tumble::render
