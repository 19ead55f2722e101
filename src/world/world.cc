#include "tumble/sim/world.h"

#include <string>
#include <utility>

#include "src/world/body_check.h"
#include "src/world/float_environment.h"
#include "src/world/scratch.h"
#include "tumble/sim/limits.h"

namespace tumble::sim {
namespace {

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

// Derived columns are not recomputed: they must only be what arithmetic can work with.
Status check_constants(const Bodies& b, BodyIndex i) {
  const auto sane = [](double value) { return value >= 0 && value <= 1e30; };  // false for NaN
  const Vec3 half = b.half_extent[i], inertia = b.inertia[i], inverse = b.inverse_inertia[i];
  bool ok = b.frozen[i] <= 1 && b.is_static[i] <= 1 && b.mass[i] > 0 && half.minCoeff() > 0;
  for (const double value :
       {b.mass[i], b.inverse_mass[i], b.low_energy_time[i], b.friction[i], b.friction_dynamic[i], b.restitution[i],
        half.x(), half.y(), half.z(), inertia.x(), inertia.y(), inertia.z(), inverse.x(), inverse.y(), inverse.z()}) {
    ok = ok && sane(value);
  }
  if (ok) return {};
  return bad_input("snapshot: body " + std::to_string(b.id[i]) + " has a size, mass, inertia or material out of range");
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

Result<World> World::restore(WorldState state) {
  if (Status ok = check_float_environment(); !ok.ok()) return ok.error();
  if (!same_sizes(state)) return bad_input("snapshot: the columns of the bodies differ in length");
  if (Status ok = check_lists(state); !ok.ok()) return ok.error();
  if (Status ok = check_def(state.def); !ok.ok()) return ok.error();
  for (BodyIndex i = 0; i < state.bodies.size(); ++i) {
    if (Status ok = check_body(state.bodies, i); !ok.ok()) return bad_input("snapshot: " + ok.error().message);
    if (Status ok = check_constants(state.bodies, i); !ok.ok()) return ok.error();
  }
  return World(std::move(state));
}

World::World(WorldState state) : state_(std::move(state)), scratch_(std::make_unique<Scratch>()) {}
World::World(const World& other)
    : state_(other.state_), scratch_(std::make_unique<Scratch>(*other.scratch_)), input_energy_(other.input_energy_) {}
World::World(World&& other) noexcept = default;
World& World::operator=(World&& other) noexcept = default;
World::~World() = default;

World& World::operator=(const World& other) {
  if (this != &other) *this = World(other);
  return *this;
}

void World::use(Workers* workers) { scratch_->workers = workers; }

}  // namespace tumble::sim
