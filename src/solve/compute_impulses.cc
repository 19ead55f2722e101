#include "src/solve/compute_impulses.h"

#include <algorithm>
#include <cmath>

#include "src/math/grid.h"
#include "src/world/body_check.h"

namespace tumble::sim {
namespace {

// Slower than this there is no direction of slip to oppose, m/s.
constexpr double kSlipMin = 1e-12;

inline Vec3 point_velocity(const ContactBody& body) { return body.velocity + cross(body.spin, body.r); }

inline double yield_along(const ContactBody& body, const Vec3& lever_W) {
  const Vec3 lever = to_body(body.axes, lever_W);
  const Vec3& i = body.inverse_inertia;
  return (lever.x() * lever.x() * i.x() + lever.y() * lever.y() * i.y()) + lever.z() * lever.z() * i.z();
}

// The speed that a unit impulse at r gives the point along `direction`: n · ((I⁻¹ (r × n)) × r), as a square.
inline double yield_of_rotation(const ContactBody& body, const Vec3& direction) {
  return yield_along(body, cross(body.r, direction));
}

// How fast the points move apart along what an impulse pushes them by, times the impulse: J · K J, in J.
double stiffness_work(const ContactBody& a, const ContactBody& b, const Vec3& impulse) {
  return dot(impulse, impulse) * (a.inverse_mass + b.inverse_mass) +
         (yield_of_rotation(a, impulse) + yield_of_rotation(b, impulse));
}

double yield(const ContactBody& a, const ContactBody& b, const Vec3& direction) {
  return (a.inverse_mass + b.inverse_mass) + (yield_of_rotation(a, direction) + yield_of_rotation(b, direction));
}

// r × (x, y, 0).
inline Vec3 level_lever(const Vec3& r, double x, double y) { return {-(r.z() * y), r.z() * x, r.x() * y - r.y() * x}; }

// collision_impulse on a ground whose normal is (0, 0, −1), without the terms that are then zero: to the bit the same.
inline Vec3 ground_impulse(const ContactBody& a, const PairMaterial& material) {
  const Vec3 relative = Vec3::Zero() - point_velocity(a);
  const double approach = -relative.z();
  if (approach >= 0) return Vec3::Zero();
  const double along_normal =
      -(1 + material.restitution) * approach / (a.inverse_mass + yield_along(a, {-a.r.y(), a.r.x(), 0}));
  double x = 0, y = 0;
  const double slip_speed = std::sqrt(relative.x() * relative.x() + relative.y() * relative.y());
  if (slip_speed > kSlipMin) {
    const double along_x = relative.x() / slip_speed, along_y = relative.y() / slip_speed;
    const double to_stop = slip_speed / (a.inverse_mass + yield_along(a, level_lever(a.r, along_x, along_y)));
    const double friction = slip_speed < material.slip_speed ? material.friction : material.friction_dynamic;
    const double held = std::min(to_stop, friction * along_normal);
    x = 0 - along_x * held;
    y = 0 - along_y * held;
  }
  const Vec3 impulse(x, y, -along_normal);
  const double spent = -2 * dot(impulse, relative);
  const double gained = dot(impulse, impulse) * a.inverse_mass + yield_of_rotation(a, impulse);
  return gained > spent ? Vec3(impulse * (spent / gained)) : impulse;
}

inline Vec3 spin_gain(const ContactBody& body, const Vec3& impulse) {
  const Vec3 turn = to_body(body.axes, cross(body.r, impulse));
  return to_world(body.axes, turn.cwiseProduct(body.inverse_inertia));
}

inline ContactBody contact_body(const World& world, BodyIndex i, const Vec3& r) {
  const Bodies& bodies = world.bodies();
  const BoxFrame& frame = world.scratch().frames[i];
  return {bodies.velocity[i], bodies.spin[i], bodies.inverse_mass[i], bodies.inverse_inertia[i], frame.axes, r};
}

// Square roots of what is mostly the same number again.
class RootOfLast {
 public:
  double of(double x) {
    if (x != x_) {
      x_ = x;
      root_ = std::sqrt(x);
    }
    return root_;
  }

 private:
  double x_ = 0, root_ = 0;
};

Material material_of(const Bodies& bodies, BodyIndex i) {
  return {bodies.friction[i], bodies.friction_dynamic[i], bodies.restitution[i]};
}

// Adds what the impulse does to body i. The impulse on a is the negative of that on b, to the bit.
inline Status add_gain(World& world, BodyIndex i, const ContactBody& body, const Vec3& impulse) {
  Scratch& scratch = world.mutable_scratch();
  scratch.touched[i] = 1;
  if (body.inverse_mass == 0) return {};
  const Vec3 velocity = VelocityGrid::round(Vec3(impulse * body.inverse_mass));
  const Vec3 spin = VelocityGrid::round(spin_gain(body, impulse));
  if (Status ok = check_gain(world.bodies(), i, velocity, spin); !ok.ok()) return ok;
  scratch.velocity_gain.add(i, velocity);
  scratch.spin_gain.add(i, spin);
  return {};
}

// Takes the contacts one by one.
class Collisions {
 public:
  explicit Collisions(World& world) : world_(world), contacts_(world.mutable_scratch().contacts) {}

  Status run() {
    for (std::size_t k = 0; k < contacts_.size(); ++k) {
      Status ok = contacts_.b[k] == kGround ? with_ground(k) : with_body(k);
      if (!ok.ok()) return ok;
    }
    return {};
  }

 private:
  PairMaterial pair_material(const Material& a, const Material& b) {
    return {friction_.of(a.friction * b.friction), friction_dynamic_.of(a.friction_dynamic * b.friction_dynamic),
            std::max(a.restitution, b.restitution), world_.state().def.slip_speed};
  }

  Status with_body(std::size_t k) {
    const BodyIndex a = contacts_.a[k], b = contacts_.b[k];
    const ContactBody on_a = contact_body(world_, a, contacts_.r_a[k]);
    const ContactBody on_b = contact_body(world_, b, contacts_.r_b[k]);
    const PairMaterial material = pair_material(material_of(world_.bodies(), a), material_of(world_.bodies(), b));
    const Vec3 impulse = collision_impulse(on_a, on_b, contacts_.normal[k], material);
    contacts_.impulse.set(k, impulse);
    if (Status ok = add_gain(world_, a, on_a, -impulse); !ok.ok()) return ok;
    return add_gain(world_, b, on_b, impulse);
  }

  Status with_ground(std::size_t k) {
    const BodyIndex a = contacts_.a[k];
    const ContactBody on_a = contact_body(world_, a, contacts_.r_a[k]);
    const PairMaterial material = pair_material(material_of(world_.bodies(), a), world_.state().def.ground_material);
    const Vec3 impulse = ground_impulse(on_a, material);
    contacts_.impulse.set(k, impulse);
    return add_gain(world_, a, on_a, -impulse);
  }

  World& world_;
  Contacts& contacts_;
  RootOfLast friction_, friction_dynamic_;
};

}  // namespace

Vec3 spin_gain_of(const ContactBody& body, const Vec3& impulse) { return spin_gain(body, impulse); }

Vec3 collision_impulse(const ContactBody& a, const ContactBody& b, const Vec3& normal, const PairMaterial& material) {
  const Vec3 relative = point_velocity(b) - point_velocity(a);
  const double approach = dot(relative, normal);
  if (approach >= 0) return Vec3::Zero();
  const double along_normal = -(1 + material.restitution) * approach / yield(a, b, normal);
  Vec3 impulse = normal * along_normal;
  const Vec3 slip = relative - normal * approach;
  const double slip_speed = length(slip);
  if (slip_speed > kSlipMin) {
    const Vec3 tangent = slip / slip_speed;
    const double to_stop = slip_speed / yield(a, b, tangent);
    const double friction = slip_speed < material.slip_speed ? material.friction : material.friction_dynamic;
    impulse -= tangent * std::min(to_stop, friction * along_normal);
  }
  // The collision changes the kinetic energy by J·u + ½ J·KJ, which 3.1 keeps below zero, but not together with
  // friction that was found on its own: off centre, each changes the other's speed.
  const double spent = -2 * dot(impulse, relative), gained = stiffness_work(a, b, impulse);
  return gained > spent ? Vec3(impulse * (spent / gained)) : impulse;
}

Status compute_impulses(World& world, double /*dt_s*/) {
  Scratch& scratch = world.mutable_scratch();
  Contacts& contacts = scratch.contacts;
  const std::size_t n = world.bodies().size();
  scratch.velocity_gain.assign(n, Vec3::Zero());
  scratch.spin_gain.assign(n, Vec3::Zero());
  scratch.touched.assign(n, 0);
  contacts.impulse.resize(contacts.size());
  return Collisions(world).run();
}

void hash_compute_impulses(const World& world, Hasher& hasher) {
  const Vec3Column& impulse = world.scratch().contacts.impulse;
  for (const auto* column : {&impulse.x, &impulse.y, &impulse.z}) hasher.add(std::span<const double>(*column));
  for (const auto* gain : {&world.scratch().velocity_gain, &world.scratch().spin_gain}) {
    for (const auto* column : {&gain->x, &gain->y, &gain->z}) hasher.add(std::span<const double>(*column));
  }
  hasher.add(std::span<const std::uint8_t>(world.scratch().touched));
}

}  // namespace tumble::sim
