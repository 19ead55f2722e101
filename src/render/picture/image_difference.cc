#include "src/render/picture/image_difference.h"

#include <algorithm>
#include <cstdlib>

#include "src/base/check.h"

namespace tumble::render {
namespace {

// Levels that the worst channel of the pixel at `i` is off by.
int levels_off(const Image& a, const Image& b, std::size_t i) {
  int worst = 0;
  for (std::size_t k = i; k < i + 3; ++k) worst = std::max(worst, std::abs(int{a.rgb[k]} - int{b.rgb[k]}));
  return worst;
}

void check_sizes(const Image& a, const Image& b) {
  SIM_CHECK(a.width == b.width && a.height == b.height, a.width, a.height, b.width, b.height);
  SIM_CHECK(a.rgb.size() == b.rgb.size(), a.rgb.size(), b.rgb.size());
}

}  // namespace

ImageDifference difference_of(const Image& expected, const Image& actual) {
  check_sizes(expected, actual);
  ImageDifference found;
  for (std::size_t i = 0; i < expected.rgb.size(); i += 3) {
    const int off = levels_off(expected, actual, i);
    found.pixels += off > 0 ? 1U : 0U;
    found.far_off += off > kFarOffLevels ? 1U : 0U;
    found.largest = std::max(found.largest, off);
  }
  return found;
}

Image difference_map(const Image& expected, const Image& actual) {
  check_sizes(expected, actual);
  Image map = expected;
  for (std::size_t i = 0; i < map.rgb.size(); i += 3) {
    const int off = levels_off(expected, actual, i);
    const auto put = [&](int r, int g, int b) {
      map.rgb[i] = static_cast<std::uint8_t>(r);
      map.rgb[i + 1] = static_cast<std::uint8_t>(g);
      map.rgb[i + 2] = static_cast<std::uint8_t>(b);
    };
    if (off > kFarOffLevels) {
      put(255, std::max(235 - off * 2, 40), off > 120 ? 90 : 0);
    } else if (off > 0) {
      put(40, 90, 140 + off * 10);
    } else {
      put(map.rgb[i] / 4, map.rgb[i + 1] / 4, map.rgb[i + 2] / 4);
    }
  }
  return map;
}

}  // namespace tumble::render
