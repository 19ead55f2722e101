#include "src/world/world.h"

#include <cmath>
#include <string>

#include "src/math/grid.h"
#include "src/model/limits.h"
#include "src/world/edit_bodies.h"
#include "src/world/float_environment.h"

namespace tumble::sim {
namespace {

std::string id_text(BodyId id) { return std::to_string(id); }

Error unknown_body(const char* input, BodyId id) {
  return bad_input(std::string(input) + ": found id " + id_text(id) +
                   ", wanted the id of a body that exists at this step");
}

bool within(const Vec3& v, double limit) {
  return std::fabs(v.x()) <= limit && std::fabs(v.y()) <= limit && std::fabs(v.z()) <= limit;
}

Status check_vector(const char* input, const char* what, const Vec3& v, double limit) {
  if (within(v, limit)) return {};
  return bad_input(std::string(input) + ": found a " + what + " that is not finite or beyond ±" +
                   std::to_string(limit) + ", wanted one within");
}

/// Applies one input to a world whose state may be changed; each overload checks before it writes.
class Applier {
 public:
  explicit Applier(WorldState& state) : state_(state), bodies_(state.bodies) {}

  Status operator()(const Throw& input) {
    if (Status ok = check_box(input.box); !ok.ok()) return ok;
    if (bodies_.find(input.box.id))
      return bad_input("throw: found id " + id_text(input.box.id) + " twice, wanted a new one");
    if (bodies_.size() >= kBodiesMax) return bad_input("throw: the world is full");
    insert_body(state_, input.box);
    return {};
  }

  Status operator()(const Push& input) {
    const auto i = bodies_.find(input.id);
    if (!i) return unknown_body("push", input.id);
    if (Status ok = check_vector("push", "point", input.at, kPositionMax); !ok.ok()) return ok;
    if (!within(input.impulse, kMassMax)) return bad_input("push: found an impulse that is not finite, wanted N·s");
    return push(*i, input);
  }

  Status operator()(const Remove& input) {
    const auto i = bodies_.find(input.id);
    if (!i) return unknown_body("remove", input.id);
    erase_body(state_, *i);
    return {};
  }

  Status operator()(const Wake& input) {
    const auto i = bodies_.find(input.id);
    if (!i) return unknown_body("wake", input.id);
    wake_body(state_, *i);
    return {};
  }

  Status operator()(const SetVelocity& input) {
    const auto i = bodies_.find(input.id);
    if (!i) return unknown_body("set_velocity", input.id);
    if (bodies_.is_static[*i] != 0) return bad_input("set_velocity: body " + id_text(input.id) + " is static");
    if (Status ok = check_vector("set_velocity", "velocity", input.velocity, kSpeedMax); !ok.ok()) return ok;
    if (Status ok = check_vector("set_velocity", "spin", input.spin, kSpeedMax); !ok.ok()) return ok;
    wake_body(state_, *i);
    bodies_.velocity.set(*i, VelocityGrid::round(input.velocity));
    bodies_.spin.set(*i, VelocityGrid::round(input.spin));
    return {};
  }

  Status operator()(const SetGravity& input) {
    if (Status ok = check_vector("set_gravity", "gravity", input.gravity, kGravityMax); !ok.ok()) return ok;
    state_.def.gravity = input.gravity;
    for (BodyIndex i = 0; i < bodies_.size(); ++i) wake_body(state_, i);
    return {};
  }

  Status operator()(const SetDt& input) {
    if (!(input.dt >= kDtMin && input.dt <= kDtMax)) {
      return bad_input("set_dt: found " + std::to_string(input.dt) + " s, wanted " + std::to_string(kDtMin) + " … " +
                       std::to_string(kDtMax) + " s");
    }
    state_.def.dt = input.dt;
    return {};
  }

 private:
  // The same outcome as a collision's impulse; a frozen body keeps it only when that takes it past the escape
  // threshold.
  Status push(BodyIndex i, const Push& input) {
    if (bodies_.is_static[i] != 0) return bad_input("push: body " + id_text(input.id) + " is static");
    const Axes axes = axes_of(bodies_.orientation[i]);
    const Vec3 r = input.at_centre ? Vec3(Vec3::Zero()) : Vec3(PositionGrid::round(input.at) - bodies_.position[i]);
    const Vec3 turn = to_body(axes, cross(r, input.impulse)).cwiseProduct(bodies_.inverse_inertia[i]);
    const Vec3 velocity = bodies_.velocity[i] + VelocityGrid::round(Vec3(input.impulse * bodies_.inverse_mass[i]));
    const Vec3 spin = bodies_.spin[i] + VelocityGrid::round(to_world(axes, turn));
    if (!within(velocity, kSpeedMax) || !within(spin, kSpeedMax)) {
      return bad_input("push: the impulse would take body " + id_text(input.id) + " past " + std::to_string(kSpeedMax) +
                       " m/s or rad/s; push less");
    }
    const Vec3 old_velocity = bodies_.velocity[i], old_spin = bodies_.spin[i];
    bodies_.velocity.set(i, plus_zero(velocity));
    bodies_.spin.set(i, plus_zero(spin));
    if (bodies_.frozen[i] == 0) return {};
    if (kinetic_energy(bodies_, i) / bodies_.mass[i] > kEscapeFactor * state_.def.freeze_energy) {
      wake_body(state_, i);
    } else {
      bodies_.velocity.set(i, old_velocity);
      bodies_.spin.set(i, old_spin);
    }
    return {};
  }

  WorldState& state_;
  Bodies& bodies_;
};

bool same_sizes(const WorldState& state) {
  const Bodies& b = state.bodies;
  const std::size_t n = b.size();
  for (const std::size_t size : {b.position.x.size(),
                                 b.position.y.size(),
                                 b.position.z.size(),
                                 b.orientation.w.size(),
                                 b.orientation.x.size(),
                                 b.orientation.y.size(),
                                 b.orientation.z.size(),
                                 b.velocity.x.size(),
                                 b.velocity.y.size(),
                                 b.velocity.z.size(),
                                 b.spin.x.size(),
                                 b.spin.y.size(),
                                 b.spin.z.size(),
                                 b.frozen.size(),
                                 b.low_energy_time.size(),
                                 b.half_extent.x.size(),
                                 b.half_extent.y.size(),
                                 b.half_extent.z.size(),
                                 b.mass.size(),
                                 b.inverse_mass.size(),
                                 b.inertia.x.size(),
                                 b.inertia.y.size(),
                                 b.inertia.z.size(),
                                 b.inverse_inertia.x.size(),
                                 b.inverse_inertia.y.size(),
                                 b.inverse_inertia.z.size(),
                                 b.friction.size(),
                                 b.friction_dynamic.size(),
                                 b.restitution.size(),
                                 b.is_static.size()}) {
    if (size != n) return false;
  }
  return true;
}

Status check_memory(const ContactMemory& memory, BodyIndex n) {
  const std::size_t size = memory.size();
  if (memory.b.size() != size || memory.count.size() != size || memory.friction.x.size() != size ||
      memory.friction.y.size() != size || memory.friction.z.size() != size || memory.twist.size() != size) {
    return bad_input("snapshot: the columns of the contact memory differ in length");
  }
  std::uint64_t points = 0;
  for (std::size_t k = 0; k < size; ++k) {
    points += memory.count[k];
    if (memory.b[k] >= n || (memory.a[k] >= n && memory.a[k] != kGround)) {
      return bad_input("snapshot: contact memory " + std::to_string(k) + " is out of range");
    }
  }
  if (memory.feature.size() != points || memory.impulse.size() != points) {
    return bad_input("snapshot: the contact memory's points do not add up");
  }
  return {};
}

Status check_lists(const WorldState& state) {
  const BodyIndex n = static_cast<BodyIndex>(state.bodies.size());
  for (std::size_t i = 0; i < n; ++i) {
    const BodyId id = state.bodies.id[i];
    if (id == 0 || id > kBodyIdMax || (i > 0 && id <= state.bodies.id[i - 1])) {
      return bad_input("snapshot: ids do not ascend within 1 … 2^53 − 1");
    }
  }
  const PairTable& pairs = state.pairs;
  if (pairs.b.size() != pairs.size() || pairs.planes.size() != pairs.size()) {
    return bad_input("snapshot: the columns of the pair list differ in length");
  }
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const bool ordered =
        k == 0 || pairs.a[k - 1] < pairs.a[k] || (pairs.a[k - 1] == pairs.a[k] && pairs.b[k - 1] < pairs.b[k]);
    if (!ordered || pairs.a[k] >= pairs.b[k] || pairs.b[k] >= n || pairs.planes[k] >= (1U << 15U)) {
      return bad_input("snapshot: pair " + std::to_string(k) + " is out of order or out of range");
    }
  }
  const ContactObjects& objects = state.contact_objects;
  if (objects.object.size() != objects.size()) return bad_input("snapshot: contact objects differ in length");
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const bool ordered = k == 0 || objects.body[k - 1] <= objects.body[k];
    if (!ordered || objects.body[k] >= n || (objects.object[k] >= n && objects.object[k] != kGround)) {
      return bad_input("snapshot: contact object " + std::to_string(k) + " is out of order or out of range");
    }
  }
  return check_memory(state.contact_memory, n);
}

}  // namespace

Status World::apply(const Command& command) {
  const Energy before = total_energy(state_);
  if (Status ok = std::visit(Applier(state_), command); !ok.ok()) return ok;
  const Energy after = total_energy(state_);
  input_energy_ += (after.kinetic + after.potential) - (before.kinetic + before.potential);
  return {};
}

Result<World> World::restore(WorldState state) {
  if (Status ok = check_float_environment(); !ok.ok()) return ok.error();
  if (!same_sizes(state)) return bad_input("snapshot: the columns of the bodies differ in length");
  if (Status ok = check_lists(state); !ok.ok()) return ok.error();
  if (state.def.substeps == 0 || state.def.substeps > kSubstepsMax) return bad_input("snapshot: substeps out of range");
  World world;
  world.state_ = std::move(state);
  return world;
}

}  // namespace tumble::sim
