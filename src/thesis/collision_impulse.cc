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

// What an impulse does to the spins of two bodies: its angular impulses about their centres, axes of each body.
struct Turns {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
};

inline Vec3 turn_of(const ContactBody& body, const Vec3& r, const Vec3& impulse) {
  if (body.inverse_mass == 0) return Vec3::Zero();
  return to_body(body.axes, cross(r, impulse));
}
inline Turns turns_of(const ContactBody& a, const ContactBody& b, const Vec3& impulse) {
  return {turn_of(a, a.r, impulse), turn_of(b, b.r, impulse)};
}

// The speed that a unit impulse along n at r gives the point along n by rotation: n · ((I⁻¹ (r × n)) × r), written as a
// sum of squares, so that the result is never negative.
double yield_of_rotation(const Vec3& lever, const Vec3& i) {
  return (lever.x() * lever.x() * i.x() + lever.y() * lever.y() * i.y()) + lever.z() * lever.z() * i.z();
}
double yield_of_rotation(const ContactBody& a, const ContactBody& b, const Turns& turns) {
  return yield_of_rotation(turns.a, a.inverse_inertia) + yield_of_rotation(turns.b, b.inverse_inertia);
}

// The parts of a spin gain along a direction of the body's axes.
double weighted(const ContactBody& a, const ContactBody& b, const Turns& direction, const Turns& turns) {
  return weighted(direction.a, turns.a, a.inverse_inertia) + weighted(direction.b, turns.b, b.inverse_inertia);
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
  // Of a patch: its mean radius, m, or 0 where nothing brakes a twist; the twist about the normal, rad/s, and its
  // answer to an angular impulse, 1/(kg·m²); the normal in the axes of both bodies.
  double radius = 0, twist = 0, twist_yield = 0;
  Turns normals;
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

// Whether the convex hull of the corners, seen along the normal, reaches as far as a point of the plane. Every two
// corners on either side of the line to the point span a segment that cuts the line; the hull ends at the farthest cut.
bool reaches(std::span<const Vec3> patch, const Vec3& point, const Vec3& normal) {
  constexpr std::size_t kCornersMax = 8;
  SIM_DCHECK(patch.size() <= kCornersMax, patch.size());
  const Vec3 across = cross(normal, point);
  const double distance = dot(point, point);  // lengths along the line are measured in lengths of `point`
  std::array<double, kCornersMax> along, beside;
  for (std::size_t k = 0; k < patch.size(); ++k) {
    along[k] = dot(patch[k], point);
    beside[k] = dot(patch[k], across);
  }
  for (std::size_t p = 0; p < patch.size(); ++p) {
    if (beside[p] > 0) continue;
    for (std::size_t q = 0; q < patch.size(); ++q) {
      const double px = along[p], py = beside[p], qx = along[q], qy = beside[q];
      if (qy < 0) continue;
      if (py == qy ? px >= distance : px * qy - qx * py >= distance * (qy - py)) return true;
    }
  }
  return false;
}

// A part along the tangent and one along normal × tangent.
struct InPlane {
  double t = 0, u = 0;
  [[nodiscard]] double times(const InPlane& other) const { return t * other.t + u * other.u; }
};

// Two bodies at their collision point. Tangent: zero without slip.
struct Touch {
  const ContactBody &a, &b;
  Vec3 normal, tangent, relative;
  Turns by_normal, by_tangent;  // of unit impulses
  const PairMaterial& material;
  std::span<const Vec3> patch;
};

// Two bodies that touch along a whole patch, and tilt against each other about axes in the plane of it.
class Tilting {
 public:
  // normals: the normal in the axes of the two bodies.
  Tilting(const Touch& touch, const Vec3& tangent, const Turns& normals)
      : a_(touch.a), b_(touch.b), t_(tangent), u_(cross(touch.normal, t_)) {
    if (a_.inverse_mass != 0) t_of_.a = to_body(a_.axes, t_);
    if (b_.inverse_mass != 0) t_of_.b = to_body(b_.axes, t_);
    u_of_ = {cross(normals.a, t_of_.a), cross(normals.b, t_of_.b)};
    tt_ = weighted(a_, b_, t_of_, t_of_);
    tu_ = weighted(a_, b_, t_of_, u_of_);
    uu_ = weighted(a_, b_, u_of_, u_of_);
  }

  // The tilting that a spin is.
  [[nodiscard]] InPlane part_of(const Vec3& spin) const { return {dot(spin, t_), dot(spin, u_)}; }
  // The tilting that an impulse gives.
  [[nodiscard]] InPlane given_by(const Turns& turns) const {
    return {weighted(a_, b_, t_of_, turns), weighted(a_, b_, u_of_, turns)};
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
  const ContactBody& a_;
  const ContactBody& b_;
  Vec3 t_, u_;
  Turns t_of_, u_of_;  // in the axes of the two bodies
  double tt_ = 0, tu_ = 0, uu_ = 0;
};

double patch_radius(std::span<const Vec3> patch, const Vec3& normal) {
  double sum = 0;
  for (const Vec3& p : patch) sum += PositionGrid::round(length(along_plane(p, normal)));
  return sum / static_cast<double>(patch.size());
}

// The collision with its impulses at a point `shift` from the collision point. The collision changes the kinetic energy
// by J·u + ½ J·KJ. Equation 3.1 alone keeps the sum negative, but friction is computed on its own, and off centre each
// of the two impulses changes the speed that the other has to stop. Scaling J by −2 J·u / J·KJ brings the sum back to
// zero. The twist that is left then is stopped, as far as friction can.
Collision collision_at(const Touch& touch, const Meeting& m, const Vec3& shift, const Impulses& impulses) {
  const ContactBody &a = touch.a, &b = touch.b;
  Collision result;
  result.shift = shift;
  result.resting = m.resting;
  result.friction = touch.tangent * -impulses.friction;
  result.impulse = touch.normal * impulses.normal + result.friction;
  Vec3 relative = touch.relative;
  Turns turns = {touch.by_normal.a * impulses.normal - touch.by_tangent.a * impulses.friction,
                 touch.by_normal.b * impulses.normal - touch.by_tangent.b * impulses.friction};
  if (shift != Vec3::Zero()) {
    relative += cross(b.spin - a.spin, shift);
    turns = {turn_of(a, a.r + shift, result.impulse), turn_of(b, b.r + shift, result.impulse)};
  }
  const double spent = -2 * dot(result.impulse, relative);
  const double adding = dot(result.impulse, result.impulse) * (a.inverse_mass + b.inverse_mass) +
                        yield_of_rotation(a, b, turns);  // J · K J
  if (adding > spent) {
    const double scale = std::max(0.0, spent) / adding;
    result.impulse = result.impulse * scale;
    result.friction = result.friction * scale;
    turns = {turns.a * scale, turns.b * scale};
  }
  if (impulses.twist > 0) {
    const double left = (m.twist + weighted(a, b, m.normals, turns)) / m.twist_yield;
    const double twist = -std::clamp(left, -impulses.twist, impulses.twist);
    result.twist = touch.normal * twist;
    turns = {turns.a + m.normals.a * twist, turns.b + m.normals.b * twist};
  }
  result.turn_a = turns.a;
  result.turn_b = turns.b;
  return result;
}

// A collision whose corners share the load.
struct SharedLoad {
  Vec3 shift = Vec3::Zero();  // m, from the collision point to the middle of the load
  Impulses impulses;
};

// The collision of bodies of which one rests on the other with three corners or more: the corners share the load so
// that friction and pressure together leave no tilting. None where the pressure would have to act beyond the patch.
std::optional<SharedLoad> share_load(const Touch& touch, Meeting m) {
  const ContactBody &a = touch.a, &b = touch.b;
  const Vec3& normal = touch.normal;
  const Vec3 spin = b.spin - a.spin;
  Vec3 tangent = touch.tangent;
  if (m.slip == 0) {
    const Impulses found = impulses_of(m, touch.material);
    const Vec3 given = (spin_gain_of(a, normal) + spin_gain_of(b, normal)) * found.normal;
    const Vec3 tilt = along_plane(spin + given, normal);
    const double speed = length(tilt);
    if (speed <= kSlipMin) return SharedLoad{Vec3::Zero(), found};
    tangent = cross(tilt, normal) / speed;
  }
  const Tilting tilting(touch, tangent, m.normals);
  const InPlane by_normal = tilting.given_by(touch.by_normal);
  const InPlane end = tilting.ended_by(tilting.part_of(spin)), end_normal = tilting.ended_by(by_normal);
  InPlane end_friction;
  m.approach += end.times(by_normal);
  m.normal_yield += end_normal.times(by_normal);
  if (m.approach >= 0) return std::nullopt;
  if (m.slip > 0) {
    const InPlane by_friction = tilting.given_by(touch.by_tangent);
    end_friction = tilting.ended_by(by_friction);
    m.slip = std::max(0.0, m.slip + end.times(by_friction));
    m.tangent_yield += end_friction.times(by_friction);
  }
  const Impulses found = impulses_of(m, touch.material);
  const InPlane torque = {end.t + (end_normal.t * found.normal - end_friction.t * found.friction),
                          end.u + (end_normal.u * found.normal - end_friction.u * found.friction)};
  const Vec3 shift = tilting.shift_of(torque, found.normal);
  if (dot(shift, shift) > 0 && !reaches(touch.patch, shift, normal)) return std::nullopt;
  return SharedLoad{PositionGrid::round(shift), found};
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
  Touch touch = {a, b, normal, Vec3::Zero(), relative, turns_of(a, b, normal), {}, material, patch};
  const double inverse_mass = a.inverse_mass + b.inverse_mass;
  m.normal_yield = inverse_mass + yield_of_rotation(a, b, touch.by_normal);
  m.tangent_yield = 1;
  const bool rough = material.friction > 0 || material.friction_dynamic > 0;
  if (rough) {
    const Vec3 slip = along_plane(relative, normal), pull = along_plane(gained, normal), slip_old = slip - pull;
    const double slip_speed = length(slip);
    m.pull = length(pull);
    m.slow = length(slip_old) < material.slip_speed || dot(slip_old, slip) < 0;
    if (slip_speed > kSlipMin) {
      touch.tangent = slip / slip_speed;
      touch.by_tangent = turns_of(a, b, touch.tangent);
      m.slip = slip_speed;
      m.tangent_yield = inverse_mass + yield_of_rotation(a, b, touch.by_tangent);
    }
  }
  const bool on_fixed = a.inverse_mass == 0 || b.inverse_mass == 0;
  if (on_fixed && patch.size() >= 3 && approach >= 2 * falling) {
    Meeting shared = m;
    shared.resting = true;
    if (a.inverse_mass != 0) shared.normals.a = to_body(a.axes, normal);
    if (b.inverse_mass != 0) shared.normals.b = to_body(b.axes, normal);
    shared.twist = dot(b.spin - a.spin, normal);
    if (rough && shared.twist != 0) {
      shared.radius = patch_radius(patch, normal);
      shared.twist_yield = yield_of_rotation(a, b, shared.normals);
      shared.slow = m.slow && std::fabs(shared.twist) * shared.radius < material.slip_speed;
    }
    if (const auto load = share_load(touch, shared)) return collision_at(touch, shared, load->shift, load->impulses);
  }
  return collision_at(touch, m, Vec3::Zero(), impulses_of(m, material));
}

}  // namespace tumble::sim
