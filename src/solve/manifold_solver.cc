#include "src/solve/manifold_solver.h"

#include <algorithm>
#include <cmath>

#include "src/math/grid.h"
#include "src/solve/solver_body.h"

namespace tumble::sim {
namespace {

constexpr double kOverRelaxation = 1.8;  // of the inner Jacobi, over its row sums

// What a unit of force along `direction` (or of pure torque, when it is zero) does to (u, W1, W2).
struct Response {
  double u, w1, w2;
};
Response response_to(const Manifold& m, const SolverBody& a, const SolverBody& b, const Wrench& wrench) {
  const Vec3 va = wrench.force * (-a.inverse_mass * m.split_a), vb = wrench.force * (b.inverse_mass * m.split_b);
  const Vec3 wa = spin_of(a, reaction_torque(m, wrench)) * -m.split_a, wb = spin_of(b, wrench.torque) * m.split_b;
  const Vec3 u = (vb - va) - cross(wa, m.d), w = wb - wa;
  return {dot(u, m.n), dot(w, m.t1), dot(w, m.t2)};
}

Wrench normal_wrench(const Manifold& m, double s, double sq, double sp) { return {m.n * s, m.t1 * sq - m.t2 * sp}; }

// The point where friction acts: the mean of the points; and how far they lie from it.
void find_friction_centre(Manifold& m, std::span<const ManifoldPoint> points) {
  double p = 0, q = 0;
  for (const ManifoldPoint& point : points) {
    p += VelocityGrid::round(point.p);
    q += VelocityGrid::round(point.q);
  }
  const double count = static_cast<double>(points.size());
  m.centre_p = p / count;
  m.centre_q = q / count;
  double radius = 0;
  for (const ManifoldPoint& point : points) {
    const double x = point.p - m.centre_p, y = point.q - m.centre_q;
    radius += VelocityGrid::round(std::sqrt(x * x + y * y));
  }
  m.radius = radius / count;
}

// Inverts the symmetric matrix k = (11, 12, 13, 22, 23, 33).
void invert_symmetric(const double k[6], double inverse[6]) {
  const double c11 = k[3] * k[5] - k[4] * k[4], c22 = k[0] * k[5] - k[2] * k[2], c33 = k[0] * k[3] - k[1] * k[1];
  const double c12 = k[2] * k[4] - k[1] * k[5], c13 = k[1] * k[4] - k[2] * k[3], c23 = k[1] * k[2] - k[0] * k[4];
  const double scale = 1 / (k[5] * c33 + (k[2] * c13 + k[4] * c23));
  inverse[0] = c11 * scale;
  inverse[1] = c12 * scale;
  inverse[2] = c13 * scale;
  inverse[3] = c22 * scale;
  inverse[4] = c23 * scale;
  inverse[5] = c33 * scale;
}

// Friction's rows: t1 and t2 at the friction centre, and twist about n.
void prepare_friction(Manifold& m, const SolverBody& a, const SolverBody& b) {
  const Vec3 rb = (m.t1 * m.centre_p + m.t2 * m.centre_q) + m.n * m.offset, ra = rb + m.d;
  const Vec3 lever_a[3] = {cross(ra, m.t1), cross(ra, m.t2), m.n};
  const Vec3 lever_b[3] = {cross(rb, m.t1), cross(rb, m.t2), m.n};
  Vec3 turn_a[3], turn_b[3];
  for (int k = 0; k < 3; ++k) {
    turn_a[k] = spin_of(a, lever_a[k]);
    turn_b[k] = spin_of(b, lever_b[k]);
  }
  const double linear = m.split_a * a.inverse_mass + m.split_b * b.inverse_mass;
  double k[6];
  int at = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const double of_a = 0.5 * (dot(lever_a[i], turn_a[j]) + dot(lever_a[j], turn_a[i]));
      const double of_b = 0.5 * (dot(lever_b[i], turn_b[j]) + dot(lever_b[j], turn_b[i]));
      k[at++] = (i == j && i < 2 ? linear : 0) + (m.split_a * of_a + m.split_b * of_b);
    }
  }
  invert_symmetric(k, m.friction_inverse);
}

}  // namespace

RelativeMotion relative_motion(const Manifold& m, const SolverBody& a, const SolverBody& b) {
  return {(b.velocity - a.velocity) - cross(a.spin, m.d), b.spin - a.spin};
}

Vec3 reaction_torque(const Manifold& m, const Wrench& wrench) { return wrench.torque + cross(m.d, wrench.force); }

void prepare_manifold(Manifold& m, std::span<ManifoldPoint> points, const SolverBody& a, const SolverBody& b,
                      double lighter_mass) {
  m.impulse_magic = VelocityGrid::kMagic * power_of_two(lighter_mass);
  find_friction_centre(m, points);
  prepare_friction(m, a, b);
  const Response s = response_to(m, a, b, normal_wrench(m, 1, 0, 0));
  const Response sq = response_to(m, a, b, normal_wrench(m, 0, 1, 0));
  const Response sp = response_to(m, a, b, normal_wrench(m, 0, 0, 1));
  const RelativeMotion motion = relative_motion(m, a, b);
  const double u = dot(motion.u, m.n), w1 = dot(motion.w, m.t1), w2 = dot(motion.w, m.t2);
  const auto to_unit = [&](const ManifoldPoint& point) {
    return Response{s.u + (point.q * sq.u + point.p * sp.u), s.w1 + (point.q * sq.w1 + point.p * sp.w1),
                    s.w2 + (point.q * sq.w2 + point.p * sp.w2)};
  };
  for (ManifoldPoint& point : points) {
    const Response r = to_unit(point);
    point.mass = 1 / (r.u + (point.q * r.w1 - point.p * r.w2));
    point.peak = 0;
    point.approach = u + (w1 * point.q - w2 * point.p);
  }
  double row_sum = 1;
  for (const ManifoldPoint& row : points) {
    double sum = 0;
    for (const ManifoldPoint& column : points) {
      const Response r = to_unit(column);
      const double k = r.u + (row.q * r.w1 - row.p * r.w2);
      sum += VelocityGrid::round(std::fabs(k) * std::sqrt(row.mass * column.mass));
    }
    row_sum = std::max(row_sum, sum);
  }
  m.relaxation = std::min(1.0, kOverRelaxation / row_sum);
  m.response[0] = s.u;
  m.response[1] = sq.u;
  m.response[2] = sp.u;
  m.response[3] = sq.w1;
  m.response[4] = 0.5 * (sp.w1 - sq.w2);
  m.response[5] = sp.w2;
}

}  // namespace tumble::sim
