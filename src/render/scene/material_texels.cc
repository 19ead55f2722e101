#include "src/render/scene/material_texels.h"

#include <algorithm>
#include <cmath>

namespace tumble::render {
namespace {

// A texel while it is made: encoded colour 0 … 1 and specular mask.
struct Texel {
  double r = 0, g = 0, b = 0, shine = 0;
};

Texel scaled(Texel t, double k) { return {t.r * k, t.g * k, t.b * k, t.shine}; }
Texel mixed(const Texel& a, const Texel& b, double k) {
  return {a.r + (b.r - a.r) * k, a.g + (b.g - a.g) * k, a.b + (b.b - a.b) * k, a.shine + (b.shine - a.shine) * k};
}
double ramp(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

// 0 … 1 for a lattice point.
double lattice(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  std::uint32_t h = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ seed * 0xC2B2AE3DU;
  h = (h ^ (h >> 15U)) * 0x2C1B3C6DU;
  h = (h ^ (h >> 12U)) * 0x297A2D39U;
  return static_cast<double>(h ^ (h >> 15U)) / 4294967295.0;
}

// Where a coordinate >= 0 lies in a row of cells that closes on itself.
struct Cell {
  std::uint32_t low, high;  // its lattice points
  double part;              // of the way from one to the other, eased
};
Cell cell_of(double x, int cells) {
  const auto whole = static_cast<std::uint32_t>(x);
  const auto count = static_cast<std::uint32_t>(cells);
  const std::uint32_t low = whole % count;
  const double t = x - whole;
  return {low, low + 1 == count ? 0 : low + 1, t * t * (3 - 2 * t)};
}

// Smooth noise, 0 … 1, of cells_x by cells_y cells over the unit square; the edges fit together. u, v >= 0.
double noise(double u, double v, int cells_x, int cells_y, std::uint32_t seed) {
  const Cell x = cell_of(u * cells_x, cells_x), y = cell_of(v * cells_y, cells_y);
  const double low = lattice(x.low, y.low, seed) * (1 - x.part) + lattice(x.high, y.low, seed) * x.part;
  const double high = lattice(x.low, y.high, seed) * (1 - x.part) + lattice(x.high, y.high, seed) * x.part;
  return low * (1 - y.part) + high * y.part;
}

// Four octaves of it, 0 … 1.
double clouds(double u, double v, int cells_x, int cells_y, std::uint32_t seed) {
  double sum = 0, weight = 0.5;
  for (std::uint32_t octave = 0; octave < 4; ++octave) {
    const int factor = 1 << octave;
    sum += weight * noise(u, v, cells_x * factor, cells_y * factor, seed + octave);
    weight /= 2;
  }
  return sum / 0.9375;
}

// Grain along u.
Texel wood_grain(double u, double v, std::uint32_t seed) {
  const double sway = 0.06 * (clouds(u, v, 2, 3, seed) - 0.5);
  const double ring = clouds(u, v + sway + 1, 2, 24, seed + 11);
  const double pore = noise(u, v + sway + 1, 6, 120, seed + 23);
  const Texel light = {0.78, 0.62, 0.43, 0.10}, dark = {0.57, 0.41, 0.26, 0.06};
  return scaled(mixed(light, dark, ramp(0.30, 0.75, ring)), 0.90 + 0.14 * pore);
}

Texel wood(double u, double v) { return wood_grain(u, v, 7); }

// Distance in the unit square to the nearest of rivets `pitch` apart along x, at height y.
double rivet_distance(double x, double y, double pitch) {
  const double along = x - (std::floor(x / pitch) + 0.5) * pitch;
  return std::sqrt(along * along + y * y);
}

Texel steel(double u, double v, double across, double half_width, double along) {
  const Texel base = {0.60, 0.62, 0.66, 0.95};
  Texel t = scaled(base, 0.82 + 0.22 * noise(u, v, 90, 90, 31) - 0.18 * clouds(u, v, 5, 5, 33));
  const double rim = std::fabs(across) / half_width;  // 1 at the band's edges
  t = scaled(t, 1 - 0.45 * ramp(0.80, 1.0, rim));
  const double rivet = rivet_distance(along, across, 0.125);
  if (rivet < 0.016) t = scaled(t, 1.28 - 0.25 * ramp(0.004, 0.016, rivet));
  if (rivet >= 0.016 && rivet < 0.023) t = scaled(t, 0.62);
  return t;
}

// Five boards between steel bands on all four edges, and one across the middle.
Texel crate(double u, double v) {
  constexpr double kBand = 0.085, kMiddle = 0.045;
  const double edge_u = std::min(u, 1 - u), edge_v = std::min(v, 1 - v);
  const double edge = std::min(edge_u, edge_v);
  if (edge < kBand) return steel(u, v, edge - kBand / 2, kBand / 2, edge_v < edge_u ? u : v);
  const double middle = v - 0.5;
  if (std::fabs(middle) < kMiddle) return steel(u, v, middle, kMiddle, u);
  const double place = (u - kBand) / (1 - 2 * kBand) * 5;
  const auto board = static_cast<std::uint32_t>(place);
  const double across = place - board;
  Texel t = wood_grain(v, across / 5 + 0.2 * board, 40 + board * 5);
  t = scaled(t, 0.90 + 0.2 * lattice(board, 3, 9));
  t = scaled(t, 0.35 + 0.65 * ramp(0.0, 0.07, std::min(across, 1 - across)));
  const double shade = std::min(edge - kBand, std::fabs(middle) - kMiddle);  // the bands stand a little proud
  return scaled(t, 0.62 + 0.38 * ramp(0.0, 0.03, shade));
}

Texel brick(double u, double v) {
  const double patch = clouds(u, v, 3, 3, 51), grit = noise(u, v, 100, 100, 57), pit = noise(u, v, 60, 60, 59);
  Texel t = mixed({0.69, 0.41, 0.33, 0.05}, {0.54, 0.31, 0.26, 0.03}, ramp(0.25, 0.75, patch));
  t = scaled(t, 0.86 + 0.24 * grit);
  return scaled(t, 1 - 0.25 * ramp(0.84, 0.98, pit));
}

Texel concrete(double u, double v) {
  const double patch = clouds(u, v, 4, 4, 61), grit = noise(u, v, 110, 110, 67), pit = noise(u, v, 48, 48, 71);
  const Texel t = scaled({0.64, 0.63, 0.61, 0.07}, 0.80 + 0.25 * patch + 0.12 * grit);
  return scaled(t, 1 - 0.30 * ramp(0.88, 0.98, pit));
}

Texel white(double /*u*/, double /*v*/) { return {0.955, 0.955, 0.955, 0.30}; }

// Four slabs with joints between.
Texel ground(double u, double v) {
  const double patch = clouds(u, v, 3, 3, 81), grit = noise(u, v, 120, 120, 87);
  const double a = u * 2 - std::floor(u * 2), b = v * 2 - std::floor(v * 2);
  const double joint = std::min({a, 1 - a, b, 1 - b});
  const Texel t = scaled({0.655, 0.650, 0.640, 0.04}, 0.93 + 0.08 * patch + 0.05 * grit);
  return scaled(t, 0.86 + 0.14 * ramp(0.004, 0.020, joint));
}

std::uint8_t to_byte(double x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0, 1.0) * 255)); }

Texels make_finest(Texel (*material)(double, double)) {
  Texels texels;
  texels.reserve(std::size_t{kTexelsPerEdge} * kTexelsPerEdge * 4);
  for (int y = 0; y < kTexelsPerEdge; ++y) {
    for (int x = 0; x < kTexelsPerEdge; ++x) {
      const Texel t = material((x + 0.5) / kTexelsPerEdge, (y + 0.5) / kTexelsPerEdge);
      texels.insert(texels.end(), {to_byte(t.r), to_byte(t.g), to_byte(t.b), to_byte(t.shine)});
    }
  }
  return texels;
}

Texels make_coarser(const Texels& fine, std::size_t edge) {
  Texels coarse(edge * edge * 4);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    const std::size_t channel = i % 4, x = i / 4 % edge, y = i / 4 / edge;
    const std::size_t first = ((y * 2) * edge * 2 + x * 2) * 4 + channel;
    double linear = 0, plain = 0;
    for (const std::size_t at : {first, first + 4, first + edge * 8, first + edge * 8 + 4}) {
      const double value = fine[at] / 255.0;
      plain += value / 4;
      linear += value * value / 4;  // near enough to sRGB's curve, and the same bits everywhere
    }
    coarse[i] = to_byte(channel == 3 ? plain : std::sqrt(linear));
  }
  return coarse;
}

}  // namespace

std::array<Texels, kLevelCount> make_levels(int layer) {
  constexpr std::array<Texel (*)(double, double), kLayerCount> kMaterials = {crate,    brick, wood,
                                                                             concrete, white, ground};
  std::array<Texels, kLevelCount> levels;
  levels[0] = make_finest(kMaterials[static_cast<std::size_t>(layer)]);
  for (std::size_t level = 1; level < kLevelCount; ++level) {
    levels[level] = make_coarser(levels[level - 1], std::size_t{kTexelsPerEdge} >> level);
  }
  return levels;
}

}  // namespace tumble::render
