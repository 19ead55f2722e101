#include "src/layered/order/load_fit.h"

namespace tumble::sim {
namespace {

using SupportPoint = WeightScratch::SupportPoint;

// Solves for the slopes from the moments about x and y.
void balance(const Borne& borne, LoadFit& f) {
  const double turn_x = borne.moment_x - borne.mass * f.x, turn_y = borne.moment_y - borne.mass * f.y;
  const double little = 1e-6 * (f.xx + f.yy);  // points in a row leave one slope undetermined
  const double xx = f.xx + little, yy = f.yy + little;
  const double determinant = xx * yy - f.xy * f.xy;
  if (determinant <= 0) return;
  f.along_x = (yy * turn_x - f.xy * turn_y) / determinant;
  f.along_y = (xx * turn_y - f.xy * turn_x) / determinant;
}

}  // namespace

LoadFit fit_loads(std::span<const SupportPoint> points, const Borne& borne, bool balanced) {
  LoadFit f;
  if (points.empty()) return f;
  f.count = static_cast<double>(points.size());
  const double terms = std::max(4.0, f.count);  // fitting_magic wants no term larger than a quarter of all
  double farthest = 0;
  for (const SupportPoint& p : points) farthest = std::max({farthest, std::fabs(p.x), std::fabs(p.y)});
  const double magic = fitting_magic(VelocityGrid::kMagic, farthest * terms);
  for (const SupportPoint& point : points) {
    f.x += to_grid(magic, point.x);
    f.y += to_grid(magic, point.y);
  }
  f.x /= f.count;
  f.y /= f.count;
  const double squares = fitting_magic(VelocityGrid::kMagic, 4 * farthest * farthest * terms);
  for (const SupportPoint& point : points) {
    const double x = point.x - f.x, y = point.y - f.y;
    f.xx += to_grid(squares, x * x);
    f.xy += to_grid(squares, x * y);
    f.yy += to_grid(squares, y * y);
  }
  f.even = borne.mass / f.count;
  if (balanced) balance(borne, f);
  return f;
}

}  // namespace tumble::sim
