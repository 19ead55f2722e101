#include "src/thesis/collision_impulse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "src/base/check.h"
#include "src/math/grid.h"

namespace tumble::sim {
namespace {

// Slower than this there is no direction of slip to oppose, m/s.
constexpr double kSlipMin = 1e-12;

Vec3 point_velocity(const ContactBody& body) { return body.velocity + cross(body.spin, body.r); }

// x · I⁻¹ y, axes of the body.
double weighted(const Vec3& x, const Vec3& y, const Vec3& i) {
  return (x.x() * y.x() * i.x() + x.y() * y.y() * i.y()) + x.z() * y.z() * i.z();
}

// The spin about a direction that a unit angular impulse about the direction gives.
double yield_of_torque(const ContactBody& body, const Vec3& direction) {
  if (body.inverse_mass == 0) return 0;
  const Vec3 x = to_body(body.axes, direction);
  return weighted(x, x, body.inverse_inertia);
}

// The speed that a unit impulse along n at r gives the point along n by rotation: n · ((I⁻¹ (r × n)) × r), written as a
// sum of squares, so that the result is never negative.
double yield_of_rotation(const ContactBody& body, const Vec3& direction) {
  if (body.inverse_mass == 0) return 0;
  const Vec3 lever = to_body(body.axes, cross(body.r, direction));
  const Vec3& i = body.inverse_inertia;
  return (lever.x() * lever.x() * i.x() + lever.y() * lever.y() * i.y()) + lever.z() * lever.z() * i.z();
}

// J · K J in J: the impulse times the relative velocity that the impulse gives the points.
double stiffness_work(const ContactBody& a, const ContactBody& b, const Vec3& impulse) {
  return dot(impulse, impulse) * (a.inverse_mass + b.inverse_mass) +
         (yield_of_rotation(a, impulse) + yield_of_rotation(b, impulse));
}

double yield(const ContactBody& a, const ContactBody& b, const Vec3& direction) {
  return (a.inverse_mass + b.inverse_mass) + (yield_of_rotation(a, direction) + yield_of_rotation(b, direction));
}

Vec3 along_plane(const Vec3& v, const Vec3& normal) { return v - normal * dot(v, normal); }

// How two bodies move at their collision point, and how they answer impulses along the normal and along the slip.
struct Meeting {
  double approach = 0;  // m/s along the normal, < 0
  double slip = 0;      // m/s along the tangent, >= 0
  double pull = 0;      // m/s of slip that gravity adds in one sub-step
  bool resting = false;
  bool slow = false;                           // whether the slip was slow before gravity acted, or turned round
  double normal_yield = 0, tangent_yield = 0;  // 1/kg
  // Of a patch: its mean radius, m; the twist about the normal, rad/s, and its answer to an angular impulse, 1/(kg·m²).
  double radius = 0, twist = 0, twist_yield = 0;
};

struct Impulses {
  double normal = 0, friction = 0;  // N·s
  double twist = 0;                 // N·m·s at most, about the normal
};

// Equation 3.1 and Coulomb's bound; a patch that slips and twists at once divides the bound. At rest the part of the
// impulse that restitution adds does not press: III.E takes that part from the body again, for the height by which
// separation lifts the body.
Impulses impulses_of(const Meeting& m, const PairMaterial& material) {
  const double normal = -(1 + material.restitution) * m.approach / m.normal_yield;
  const double pressing = m.resting ? -m.approach / m.normal_yield : normal;
  const bool held = m.slow && m.pull <= material.friction * pressing * m.tangent_yield;
  const double most = (held ? material.friction : material.friction_dynamic) * pressing;
  const double to_stop = m.slip / m.tangent_yield;
  if (m.radius == 0) return {normal, std::min(to_stop, most)};
  const double stop_twist = std::fabs(m.twist) / m.twist_yield, at_rim = stop_twist / m.radius;
  const double wanted = std::sqrt(to_stop * to_stop + at_rim * at_rim), share = wanted > most ? most / wanted : 1;
  return {normal, to_stop * share, stop_twist * share};
}

// How far the convex hull of the corners reaches along x, seen along the normal; across: normal to x. Every two corners
// on either side of the line span a segment that cuts the line; the hull ends at the farthest cut.
double reach_of(std::span<const Vec3> patch, const Vec3& x, const Vec3& across) {
  constexpr std::size_t kCornersMax = 8;
  SIM_DCHECK(patch.size() <= kCornersMax, patch.size());
  std::array<double, kCornersMax> along, beside;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    along[k] = dot(patch[k], x);
    beside[k] = dot(patch[k], across);
  }
  double reach = 0;
  for (std::size_t p = 0; p < patch.size(); ++p) {
    if (beside[p] > 0) continue;
    for (std::size_t q = 0; q < patch.size(); ++q) {
      const double px = along[p], py = beside[p], qx = along[q], qy = beside[q];
      if (qy < 0) continue;
      reach = std::max(reach, py == qy ? px : (px * qy - qx * py) / (qy - py));
    }
  }
  return reach;
}

// A part along the tangent and one along normal × tangent.
struct InPlane {
  double t = 0, u = 0;
  [[nodiscard]] double times(const InPlane& other) const { return t * other.t + u * other.u; }
};

// Two bodies that touch along a whole patch, and tilt against each other about axes in the plane of it.
class Tilting {
 public:
  Tilting(const ContactBody& a, const ContactBody& b, const Vec3& normal, const Vec3& tangent)
      : a_(a),
        b_(b),
        t_(tangent),
        u_(cross(normal, tangent)),
        t_of_a_(to_body(a.axes, t_)),
        u_of_a_(to_body(a.axes, u_)),
        t_of_b_(to_body(b.axes, t_)),
        u_of_b_(to_body(b.axes, u_)) {
    const InPlane of_t = gain_of(t_, t_), of_u = gain_of(u_, u_);
    tt_ = of_t.t;
    tu_ = of_t.u;
    uu_ = of_u.u;
  }

  // The tilting that a spin is.
  [[nodiscard]] InPlane part_of(const Vec3& spin) const { return {dot(spin, t_), dot(spin, u_)}; }
  // The tilting that a unit impulse at the collision point gives.
  [[nodiscard]] InPlane by_impulse(const Vec3& direction) const {
    return gain_of(cross(a_.r, direction), cross(b_.r, direction));
  }
  // The angular impulse in the plane that ends a tilting.
  [[nodiscard]] InPlane ended_by(const InPlane& tilt) const {
    const double determinant = tt_ * uu_ - tu_ * tu_;
    return {-(tilt.t * uu_ - tilt.u * tu_) / determinant, -(tilt.u * tt_ - tilt.t * tu_) / determinant};
  }
  // The shift, m, of a normal impulse that gives an angular impulse.
  [[nodiscard]] Vec3 shift_of(const InPlane& torque, double normal_impulse) const {
    return (u_ * torque.t - t_ * torque.u) / normal_impulse;
  }

 private:
  [[nodiscard]] InPlane gain_of(const Vec3& on_a, const Vec3& on_b) const {
    const InPlane of_a = gain_of(a_, on_a, t_of_a_, u_of_a_), of_b = gain_of(b_, on_b, t_of_b_, u_of_b_);
    return {of_a.t + of_b.t, of_a.u + of_b.u};
  }
  // t, u: of the body's frame.
  static InPlane gain_of(const ContactBody& body, const Vec3& torque, const Vec3& t, const Vec3& u) {
    if (body.inverse_mass == 0) return {};
    const Vec3 y = to_body(body.axes, torque);
    return {weighted(t, y, body.inverse_inertia), weighted(u, y, body.inverse_inertia)};
  }

  const ContactBody& a_;
  const ContactBody& b_;
  Vec3 t_, u_, t_of_a_, u_of_a_, t_of_b_, u_of_b_;
  double tt_ = 0, tu_ = 0, uu_ = 0;
};

double patch_radius(std::span<const Vec3> patch, const Vec3& normal) {
  double sum = 0;
  for (const Vec3& p : patch) sum += PositionGrid::round(length(along_plane(p, normal)));
  return sum / static_cast<double>(patch.size());
}

// Two bodies at their collision point.
struct Touch {
  const ContactBody &a, &b;
  Vec3 normal, tangent;  // tangent: zero without slip
  const PairMaterial& material;
  std::span<const Vec3> patch;
};

// The collision with its impulses at a point `shift` from the collision point. The collision changes the kinetic energy
// by J·u + ½ J·KJ. Equation 3.1 alone keeps the sum negative, but friction is computed on its own, and off centre each
// of the two impulses changes the speed that the other has to stop. Scaling J by −2 J·u / J·KJ brings the sum back to
// zero. The twist that is left then is stopped, as far as friction can.
Collision collision_at(const Touch& touch, const Meeting& m, const Vec3& shift, const Impulses& impulses) {
  ContactBody a = touch.a, b = touch.b;
  a.r += shift;
  b.r += shift;
  Collision result;
  result.shift = shift;
  result.resting = m.resting;
  result.friction = touch.tangent * -impulses.friction;
  result.impulse = touch.normal * impulses.normal + result.friction;
  const double spent = -2 * dot(result.impulse, point_velocity(b) - point_velocity(a));
  const double adding = stiffness_work(a, b, result.impulse);
  if (adding > spent) {
    const double scale = std::max(0.0, spent) / adding;
    result.impulse = result.impulse * scale;
    result.friction = result.friction * scale;
  }
  if (impulses.twist > 0) {
    const Vec3 given = spin_gain_of(a, result.impulse) + spin_gain_of(b, result.impulse);
    const double left = dot((b.spin - a.spin) + given, touch.normal) / m.twist_yield;
    result.twist = touch.normal * -std::clamp(left, -impulses.twist, impulses.twist);
  }
  return result;
}

// The collision of bodies of which one rests on the other with three corners or more: the corners share the load so
// that friction and pressure together leave no tilting. None where the pressure would have to act beyond the patch.
std::optional<Collision> shared_collision(Touch touch, Meeting m) {
  const auto& [a, b, normal, tangent, material, patch] = touch;
  const Vec3 spin = b.spin - a.spin;
  if (m.slip == 0) {
    const Impulses found = impulses_of(m, material);
    const Vec3 given = (spin_gain_of(a, normal) + spin_gain_of(b, normal)) * found.normal;
    const Vec3 tilt = along_plane(spin + given, normal);
    const double speed = length(tilt);
    if (speed <= kSlipMin) return collision_at(touch, m, Vec3::Zero(), found);
    touch.tangent = cross(tilt, normal) / speed;
  }
  const Tilting tilting(a, b, normal, tangent);
  const InPlane by_normal = tilting.by_impulse(normal), by_friction = tilting.by_impulse(tangent);
  const InPlane end = tilting.ended_by(tilting.part_of(spin)), end_normal = tilting.ended_by(by_normal),
                end_friction = tilting.ended_by(by_friction);
  m.approach += end.times(by_normal);
  m.normal_yield += end_normal.times(by_normal);
  if (m.slip > 0) {
    m.slip = std::max(0.0, m.slip + end.times(by_friction));
    m.tangent_yield += end_friction.times(by_friction);
  }
  if (m.approach >= 0) return std::nullopt;
  const Impulses found = impulses_of(m, material);
  const InPlane torque = {end.t + (end_normal.t * found.normal - end_friction.t * found.friction),
                          end.u + (end_normal.u * found.normal - end_friction.u * found.friction)};
  const Vec3 shift = tilting.shift_of(torque, found.normal);
  const double distance = length(shift);
  if (distance > 0 && reach_of(patch, shift / distance, cross(normal, shift / distance)) < distance) {
    return std::nullopt;
  }
  return collision_at(touch, m, PositionGrid::round(shift), found);
}

}  // namespace

Vec3 spin_gain_of(const ContactBody& body, const Vec3& impulse, const Vec3& twist) {
  if (body.inverse_mass == 0) return Vec3::Zero();
  const Vec3 turn = to_body(body.axes, cross(body.r, impulse) + twist);
  return to_world(body.axes, turn.cwiseProduct(body.inverse_inertia));
}

Collision collide(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material,
                  std::span<const Vec3> patch) {
  const Vec3 relative = point_velocity(b) - point_velocity(a), gained = b.gained - a.gained;
  const double approach = dot(relative, normal), falling = dot(gained, normal);
  if (approach >= 0) return {};
  Meeting m;
  m.approach = approach;
  m.normal_yield = yield(a, b, normal);
  m.tangent_yield = 1;
  Touch touch = {a, b, normal, Vec3::Zero(), material, patch};
  const Vec3 slip = along_plane(relative, normal), pull = along_plane(gained, normal), slip_old = slip - pull;
  const double slip_speed = length(slip);
  m.pull = length(pull);
  m.slow = length(slip_old) < material.slip_speed || dot(slip_old, slip) < 0;
  if (slip_speed > kSlipMin) {
    touch.tangent = slip / slip_speed;
    m.slip = slip_speed;
    m.tangent_yield = yield(a, b, touch.tangent);
  }
  const bool on_fixed = a.inverse_mass == 0 || b.inverse_mass == 0;
  if (on_fixed && patch.size() >= 3 && approach >= 2 * falling) {
    Meeting shared = m;
    shared.resting = true;
    shared.radius = patch_radius(patch, normal);
    shared.twist = dot(b.spin - a.spin, normal);
    shared.twist_yield = yield_of_torque(a, normal) + yield_of_torque(b, normal);
    shared.slow = m.slow && std::fabs(shared.twist) * shared.radius < material.slip_speed;
    if (auto collision = shared_collision(touch, shared)) return *collision;
  }
  return collision_at(touch, m, Vec3::Zero(), impulses_of(m, material));
}

}  // namespace tumble::sim
