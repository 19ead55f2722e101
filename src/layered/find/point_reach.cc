#include "src/layered/find/point_reach.h"

#include <algorithm>

namespace tumble::sim {

bool leave_points_in_reach(const Bodies& bodies, const PointReach& reach, Manifold& m,
                           LargeVector<ManifoldPoint>& points) {
  const Vec3 va = m.a == kGround ? Vec3(Vec3::Zero()) : bodies.velocity[m.a];
  const Vec3 wa = m.a == kGround ? Vec3(Vec3::Zero()) : bodies.spin[m.a];
  const Vec3 u = (bodies.velocity[m.b] - va) - cross(wa, m.d), w = bodies.spin[m.b] - wa;
  const double un = dot(u, m.n), w1 = dot(w, m.t1), w2 = dot(w, m.t2);
  bool pushes = false;
  std::size_t kept = m.first;
  for (std::size_t k = m.first; k < points.size(); ++k) {
    const double speed = un + (w1 * points[k].q - w2 * points[k].p);
    if (points[k].separation + std::min(0.0, speed) * reach.time_s > reach.margin) continue;
    pushes |= points[k].separation + speed * reach.pushing_s <= 0;
    if (kept != k) points[kept] = points[k];  // a copy onto itself would stall
    ++kept;
  }
  points.resize(kept);
  m.count = static_cast<std::uint32_t>(kept - m.first);
  return pushes;
}

void separate_as_now(const Bodies& bodies, const Manifold& m, double later, std::span<ManifoldPoint> points) {
  const double opening = dot(Vec3(bodies.velocity[m.b] - bodies.velocity[m.a]), m.n);
  for (ManifoldPoint& point : points) point.separation -= later * opening;
}

}  // namespace tumble::sim
