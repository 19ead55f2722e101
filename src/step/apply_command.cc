#include <string>

#include "src/base/text.h"
#include "src/math/grid.h"
#include "src/step/first_contacts.h"
#include "src/world/body_check.h"
#include "src/world/edit_bodies.h"
#include "src/world/forget_contacts.h"
#include "src/world/scratch.h"
#include "tumble/sim/limits.h"
#include "tumble/sim/step.h"

namespace tumble::sim {
namespace {

std::string id_text(BodyId id) { return std::to_string(id); }

Error unknown_body(const char* input, BodyId id) {
  return bad_input(std::string(input) + ": found id " + id_text(id) +
                   ", wanted the id of a body that exists at this step");
}

Status check_vector(const char* input, const char* what, const Vec3& v, double limit) {
  if (within(v, limit)) return {};
  return bad_input(std::string(input) + ": found " + what + " that is not finite or beyond ±" + number_text(limit) +
                   ", wanted one within");
}

// Applies one input to a state; each overload checks before it writes.
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
    if (Status ok = check_vector("push", "a point", input.at, kPositionMax); !ok.ok()) return ok;
    if (Status ok = check_vector("push", "an impulse", input.impulse, kMassMax); !ok.ok()) return ok;
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
    if (Status ok = check_vector("set_velocity", "a velocity", input.velocity, kSpeedMax); !ok.ok()) return ok;
    if (Status ok = check_vector("set_velocity", "a spin", input.spin, kSpeedMax); !ok.ok()) return ok;
    wake_body(state_, *i);
    restart_rest(state_, *i);
    bodies_.velocity.set(*i, VelocityGrid::round(input.velocity));
    bodies_.spin.set(*i, VelocityGrid::round(input.spin));
    return {};
  }

  Status operator()(const SetGravity& input) {
    if (Status ok = check_vector("set_gravity", "a gravity", input.gravity, kGravityMax); !ok.ok()) return ok;
    state_.def.gravity = input.gravity;
    for (BodyIndex i = 0; i < bodies_.size(); ++i) wake_body(state_, i);
    forget_impulses(state_.contact_memory);
    return {};
  }

  Status operator()(const SetDt& input) {
    if (!(input.dt >= kDtMin && input.dt <= kDtMax)) {
      return bad_input("set_dt: found " + exact(input.dt) + " s, wanted " + exact(kDtMin) + " … " + exact(kDtMax) +
                       " s");
    }
    state_.def.dt = input.dt;
    forget_impulses(state_.contact_memory);
    return {};
  }

 private:
  // Changes velocity and spin as the impulse of a collision would. A frozen body keeps the change only if it takes the
  // body past the escape threshold.
  Status push(BodyIndex i, const Push& input) {
    if (bodies_.is_static[i] != 0) return bad_input("push: body " + id_text(input.id) + " is static");
    const Axes axes = axes_of(bodies_.orientation[i]);
    const Vec3 r = input.at_centre ? Vec3(Vec3::Zero()) : Vec3(PositionGrid::round(input.at) - bodies_.position[i]);
    const Vec3 turn = to_body(axes, cross(r, input.impulse)).cwiseProduct(bodies_.inverse_inertia[i]);
    const Vec3 velocity = bodies_.velocity[i] + VelocityGrid::round(Vec3(input.impulse * bodies_.inverse_mass[i]));
    const Vec3 spin = bodies_.spin[i] + VelocityGrid::round(to_world(axes, turn));
    if (!within(velocity, kSpeedMax) || !within(spin, kSpeedMax)) {
      return bad_input("push: the impulse would take body " + id_text(input.id) + " past " + number_text(kSpeedMax) +
                       " m/s or rad/s; push less");
    }
    const Vec3 old_velocity = bodies_.velocity[i], old_spin = bodies_.spin[i];
    bodies_.velocity.set(i, plus_zero(velocity));
    bodies_.spin.set(i, plus_zero(spin));
    if (bodies_.frozen[i] == 0) {
      restart_rest(state_, i);
      return {};
    }
    if (energy_per_mass(bodies_, i) > kEscapeFactor * state_.def.freeze_energy) {
      wake_body(state_, i);
      restart_rest(state_, i);
    } else {
      bodies_.velocity.set(i, old_velocity);
      bodies_.spin.set(i, old_spin);
    }
    return {};
  }

  WorldState& state_;
  Bodies& bodies_;
};

// What a box that was thrown in touches.
void look_around(WorldState& state, const BoxDef& box) {
  const auto i = state.bodies.find(box.id);
  if (box.frozen) find_first_contacts(state, i);
  if (state.def.method == Method::kLayered && (!box.frozen || box.is_static)) wake_touched(state, *i);
}

}  // namespace

Status apply(World& world, const Command& command) {
  WorldState& state = world.mutable_state();
  const Energy before = total_energy(state);
  world.mutable_scratch().still_steps = 0;
  if (Status ok = std::visit(Applier(state), command); !ok.ok()) return ok;
  if (const auto* thrown = std::get_if<Throw>(&command)) look_around(state, thrown->box);
  const Energy after = total_energy(state);
  world.add_input_energy((after.kinetic + after.potential) - (before.kinetic + before.potential));
  return {};
}

}  // namespace tumble::sim
