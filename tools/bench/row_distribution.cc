#include "tools/bench/row_distribution.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace tumble::tools {
namespace {

/// Cubes deeper than this in the ground have fallen through it.
constexpr double kDepthMax = 1.0;  // m

/// The value at fraction q of an ascending list.
double at_fraction(const std::vector<double>& values, double q) {
  const auto k = static_cast<std::size_t>(q * static_cast<double>(values.size()));
  return values[std::min(k, values.size() - 1)];
}

}  // namespace

RowDistribution distribution_of(const sim::SceneDef& scene, const replay::BodyStates& states) {
  struct Row {
    double sum = 0;
    double count = 0;
  };
  RowDistribution out;
  std::map<std::uint32_t, Row> rows;
  for (std::size_t i = 0; i < std::min(states.size(), scene.boxes.size()); ++i) {
    const double y = states.position[i].y(), z = states.position[i].z();
    if (!std::isfinite(y) || !(z > -kDepthMax)) continue;
    out.y.push_back(y);
    out.mean += y;
    Row& row = rows[scene.boxes[i].origin.row];
    row.sum += y;
    row.count += 1;
  }
  if (out.y.empty()) return out;
  out.mean /= static_cast<double>(out.y.size());
  out.farthest = out.y.front();
  for (const auto& [number, row] : rows) out.farthest = std::max(out.farthest, row.sum / row.count);
  std::ranges::sort(out.y);
  return out;
}

std::optional<double> distance(const RowDistribution& a, const RowDistribution& b) {
  if (a.y.empty() || b.y.empty()) return std::nullopt;
  const std::size_t count = std::max(a.y.size(), b.y.size());
  double sum = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double q = (static_cast<double>(k) + 0.5) / static_cast<double>(count);
    sum += std::fabs(at_fraction(a.y, q) - at_fraction(b.y, q));
  }
  return sum / static_cast<double>(count);
}

}  // namespace tumble::tools
