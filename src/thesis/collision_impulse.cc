#include "src/thesis/collision_impulse.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "src/math/grid.h"
#include "src/thesis/meeting.h"
#include "src/thesis/share_load.h"

namespace tumble::sim {
namespace {

Vec3 point_velocity(const ContactBody& body) { return body.velocity + cross(body.spin, body.r); }

double patch_radius(std::span<const Vec3> patch, const Vec3& normal) {
  double sum = 0;
  for (const Vec3& p : patch) sum += PositionGrid::round(length(along_plane(p, normal)));
  return sum / static_cast<double>(patch.size());
}

// The collision with its impulses at a point that moves with `relative`; turns: of them. The collision changes the
// kinetic energy by J·u + ½ J·KJ. Equation 3.1 alone keeps the sum negative, but friction is computed on its own, and
// off centre each of the two impulses changes the speed that the other has to stop. Scaling J by −2 J·u / J·KJ brings
// the sum back to zero.
inline void keep_energy(const Response& a, const Response& b, const Vec3& relative, Collision& result) {
  const Turns turns = {result.turn_a, result.turn_b};
  const double spent = -2 * dot(result.impulse, relative);
  const double adding = dot(result.impulse, result.impulse) * (a.inverse_mass + b.inverse_mass) +
                        yield_of_rotation(a, b, turns);  // J · K J
  if (adding <= spent) return;
  const double scale = std::max(0.0, spent) / adding;
  result.impulse = result.impulse * scale;
  result.friction = result.friction * scale;
  result.turn_a = turns.a * scale;
  result.turn_b = turns.b * scale;
}

inline Collision collision_of(const Encounter& met, const Vec3& normal, const Impulses& impulses) {
  Collision result;
  result.friction = met.tangent * -impulses.friction;
  result.impulse = normal * impulses.normal + result.friction;
  result.turn_a = met.by_normal.a * impulses.normal - met.by_tangent.a * impulses.friction;
  result.turn_b = met.by_normal.b * impulses.normal - met.by_tangent.b * impulses.friction;
  return result;
}

// The collision with its load moved by `shift`. The twist that is left then is stopped, as far as friction can.
Collision shared_collision(const Touch& touch, const Meeting& m, const SharedLoad& load) {
  const ContactBody &a = touch.a, &b = touch.b;
  Collision result = collision_of(touch.met, touch.normal, load.impulses);
  result.shift = load.shift;
  result.resting = true;
  Vec3 relative = touch.met.relative;
  if (load.shift != Vec3::Zero()) {
    relative += cross(b.spin - a.spin, load.shift);
    result.turn_a = turn_of(a, a.r + load.shift, result.impulse);
    result.turn_b = turn_of(b, b.r + load.shift, result.impulse);
  }
  keep_energy(a, b, relative, result);
  if (load.impulses.twist > 0) {
    const double left = (m.twist + weighted(a, b, m.normals, {result.turn_a, result.turn_b})) / m.twist_yield;
    const double twist = -std::clamp(left, -load.impulses.twist, load.impulses.twist);
    result.twist = touch.normal * twist;
    result.turn_a = result.turn_a + m.normals.a * twist;
    result.turn_b = result.turn_b + m.normals.b * twist;
  }
  return result;
}

Meeting meeting_of(const Encounter& met, const Response& a, const Response& b) {
  const double inverse_mass = a.inverse_mass + b.inverse_mass;
  Meeting m;
  m.approach = met.approach;
  m.slip = met.slip;
  m.pull = met.pull;
  m.slow = met.slow;
  m.normal_yield = inverse_mass + yield_of_rotation(a, b, met.by_normal);
  m.tangent_yield = met.slip > 0 ? inverse_mass + yield_of_rotation(a, b, met.by_tangent) : 1;
  return m;
}

}  // namespace

PairMaterial pair_material(const WorldState& state, BodyIndex a, BodyIndex b) {
  const Bodies& bodies = state.bodies;
  const WorldDef& def = state.def;
  const bool ground = b == kGround;
  const Material& under = def.ground_material;
  const double friction = ground ? under.friction : bodies.friction[b];
  const double dynamic = ground ? under.friction_dynamic : bodies.friction_dynamic[b];
  const double restitution = ground ? under.restitution : bodies.restitution[b];
  const double product = bodies.friction[a] * friction, product_dynamic = bodies.friction_dynamic[a] * dynamic;
  const double mean = std::sqrt(product);
  return {mean, product_dynamic == product ? mean : std::sqrt(product_dynamic),
          std::max(bodies.restitution[a], restitution), def.slip_speed};
}

Vec3 spin_gain_of(const ContactBody& body, const Vec3& impulse, const Vec3& twist) {
  if (body.inverse_mass == 0) return Vec3::Zero();
  const Vec3 turn = to_body(body.axes, cross(body.r, impulse) + twist);
  return to_world(body.axes, turn.cwiseProduct(body.inverse_inertia));
}

void find_encounter(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material,
                    std::size_t corners, Encounter& met) {
  met.relative = point_velocity(b) - point_velocity(a);
  met.approach = dot(met.relative, normal);
  if (met.approach >= 0) return;
  const Vec3 gained = b.gained - a.gained;
  met.by_normal = turns_of(a, b, normal);
  met.rough = material.friction > 0 || material.friction_dynamic > 0;
  met.pull = met.slip = 0;
  met.slow = false;
  if (met.rough) {
    const Vec3 slip = along_plane(met.relative, normal), pull = along_plane(gained, normal), slip_old = slip - pull;
    const double slip_speed = length(slip);
    met.pull = length(pull);
    met.slow = length(slip_old) < material.slip_speed || dot(slip_old, slip) < 0;
    if (slip_speed > kSlipMin) met.slip = slip_speed;
    if (met.slip > 0) met.tangent = slip / slip_speed;
  }
  if (met.slip > 0) {
    met.by_tangent = turns_of(a, b, met.tangent);
  } else {
    met.tangent = Vec3::Zero();
    met.by_tangent = {};
  }
  const bool on_fixed = a.inverse_mass == 0 || b.inverse_mass == 0;
  met.shared = on_fixed && corners >= 3 && met.approach >= 2 * dot(gained, normal);
}

Collision collide_at_point(const Response& a, const Response& b, const Vec3& normal, const PairMaterial& material,
                           const Encounter& met) {
  Collision result = collision_of(met, normal, impulses_of(meeting_of(met, a, b), material));
  keep_energy(a, b, met.relative, result);
  return result;
}

namespace {

// The collision of bodies whose corners may share the load.
Collision collide_at_patch(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material,
                           const Encounter& met, std::span<const Vec3> patch) {
  Meeting m = meeting_of(met, a, b);
  m.resting = true;
  if (a.inverse_mass != 0) m.normals.a = to_body(a.axes, normal);
  if (b.inverse_mass != 0) m.normals.b = to_body(b.axes, normal);
  m.twist = dot(b.spin - a.spin, normal);
  if (met.rough && m.twist != 0) {
    m.radius = patch_radius(patch, normal);
    m.twist_yield = yield_of_rotation(a, b, m.normals);
    m.slow = met.slow && std::fabs(m.twist) * m.radius < material.slip_speed;
  }
  const Touch touch = {a, b, normal, met, material, patch};
  if (const auto load = share_load(touch, m)) return shared_collision(touch, m, *load);
  return collide_at_point(a, b, normal, material, met);
}

}  // namespace

Collision collide(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material,
                  const Encounter& met, std::span<const Vec3> patch) {
  if (met.approach >= 0) return {};
  return met.shared ? collide_at_patch(a, b, normal, material, met, patch)
                    : collide_at_point(a, b, normal, material, met);
}

}  // namespace tumble::sim
