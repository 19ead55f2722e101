#include "src/solve/update_freezing.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "src/collide/box_pair.h"
#include "src/collide/find_pairs.h"
#include "src/world/edit_bodies.h"

namespace tumble::sim {
namespace {

constexpr double kTouchGap = 1e-3;  // m; bodies of a resting start this close touch
constexpr double kGroundHeight = -std::numeric_limits<double>::infinity();

double energy_per_mass(const Bodies& bodies, BodyIndex i) { return kinetic_energy(bodies, i) / bodies.mass[i]; }

bool immovable(const Bodies& bodies, const std::vector<std::uint8_t>& frozen, BodyIndex i) {
  return i == kGround || bodies.is_static[i] != 0 || frozen[i] != 0;
}

// Whether `object` may carry `body`, and how high its centre lies over the body's. Only lower bodies carry (thesis),
// and static ones that press from below wherever their centre is: a ramp's may be high. push: direction from object to
// body.
struct Support {
  bool carries = false;
  double height = 0;
};
Support support_of(const World& world, BodyIndex body, BodyIndex object, const Vec3& push) {
  const Vec3& gravity = world.state().def.gravity;
  if (object == kGround) return {gravity.z() < 0, kGroundHeight};
  const Bodies& bodies = world.bodies();
  const double height = -dot(gravity, bodies.position[object] - bodies.position[body]);
  const bool ramp = bodies.is_static[object] != 0 && dot(gravity, push) < 0;
  return {height < 0 || ramp, height};
}

// Calls visit(body, object, push) for both sides of every contact.
template <class Visit>
void for_each_touch(const Contacts& contacts, Visit visit) {
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const BodyIndex a = contacts.a[k], b = contacts.b[k];
    const Vec3 normal = contacts.normal[k];
    visit(a, b, Vec3(-normal));
    if (b != kGround) visit(b, a, normal);
  }
}

// The contact objects of all candidates: for each, those among its supports that lie lowest. Sorted and unique.
void collect_contact_objects(const World& world, std::vector<FreezeCandidate>& candidates, ContactObjects& found) {
  const Contacts& contacts = world.scratch().contacts;
  for_each_touch(contacts, [&](BodyIndex body, BodyIndex object, const Vec3& push) {
    if (!candidates[body].ready) return;
    const Support support = support_of(world, body, object, push);
    if (support.carries) candidates[body].lowest = std::min(candidates[body].lowest, support.height);
  });
  std::vector<std::pair<BodyIndex, BodyIndex>> objects;
  for_each_touch(contacts, [&](BodyIndex body, BodyIndex object, const Vec3& push) {
    if (!candidates[body].ready) return;
    const Support support = support_of(world, body, object, push);
    if (support.carries && support.height == candidates[body].lowest) objects.emplace_back(body, object);
  });
  std::sort(objects.begin(), objects.end());
  found.clear();
  for (const auto& [body, object] : objects) found.push_back(body, object);
}

void halt(Bodies& bodies, BodyIndex i) {
  bodies.velocity.set(i, Vec3::Zero());
  bodies.spin.set(i, Vec3::Zero());
}

// Frozen bodies: escape, or take back what the impulses tried to give.
void escape_or_halt(Bodies& bodies, double escape_energy, BodyIndex i) {
  if (energy_per_mass(bodies, i) > escape_energy) {
    bodies.frozen[i] = 0;
    bodies.low_energy_time[i] = 0;
  } else {
    halt(bodies, i);
  }
}

// Moving bodies: count the time at low energy; true when that and a collision make one a candidate.
bool count_rest(World& world, BodyIndex i, double dt_s) {
  const WorldDef& def = world.state().def;
  Bodies& bodies = world.mutable_state().bodies;
  const bool low = energy_per_mass(bodies, i) < def.freeze_energy;
  bodies.low_energy_time[i] = low ? bodies.low_energy_time[i] + dt_s : 0;
  return def.freezing && low && bodies.low_energy_time[i] >= def.freeze_time && world.scratch().touched[i] != 0;
}

// A frozen body wakes when any of its contact objects moves.
void wake_unsupported(World& world) {
  Bodies& bodies = world.mutable_state().bodies;
  const std::vector<std::uint8_t>& before = world.scratch().frozen_before;
  const ContactObjects& objects = world.state().contact_objects;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const BodyIndex i = objects.body[k];
    if (bodies.frozen[i] != 0 && !immovable(bodies, before, objects.object[k])) {
      bodies.frozen[i] = 0;
      bodies.low_energy_time[i] = 0;
    }
  }
}

// Freezes each candidate all of whose contact objects were immovable.
void freeze_supported(World& world, const ContactObjects& found) {
  Bodies& bodies = world.mutable_state().bodies;
  const std::vector<std::uint8_t>& before = world.scratch().frozen_before;
  for (std::size_t begin = 0, end = 0; begin < found.size(); begin = end) {
    const BodyIndex i = found.body[begin];
    bool supported = true;
    for (end = begin; end < found.size() && found.body[end] == i; ++end) {
      supported = supported && immovable(bodies, before, found.object[end]);
    }
    if (!supported) continue;
    bodies.frozen[i] = 1;
    bodies.low_energy_time[i] = 0;
    halt(bodies, i);
  }
}

// Keeps the contact objects of bodies that stayed frozen and adds those of the newly frozen: both lists are sorted.
void merge_contact_objects(World& world, const ContactObjects& found) {
  const Bodies& bodies = world.bodies();
  const std::vector<std::uint8_t>& before = world.scratch().frozen_before;
  ContactObjects& merged = world.mutable_scratch().new_contact_objects;
  ContactObjects& old = world.mutable_state().contact_objects;
  merged.clear();
  std::size_t j = 0;
  const auto add_found_below = [&](BodyIndex limit) {
    for (; j < found.size() && found.body[j] < limit; ++j) {
      const BodyIndex i = found.body[j];
      if (before[i] == 0 && bodies.frozen[i] != 0) merged.push_back(i, found.object[j]);
    }
  };
  for (std::size_t k = 0; k < old.size(); ++k) {
    add_found_below(old.body[k]);
    if (bodies.frozen[old.body[k]] != 0) merged.push_back(old.body[k], old.object[k]);
  }
  add_found_below(kGround);
  std::swap(old, merged);
}

}  // namespace

Status update_freezing(World& world, double dt_s) {
  const WorldDef& def = world.state().def;
  Bodies& bodies = world.mutable_state().bodies;
  Scratch& scratch = world.mutable_scratch();
  scratch.frozen_before = bodies.frozen;
  scratch.freeze_candidates.assign(bodies.size(), {});
  bool any = false;
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.is_static[i] != 0) continue;
    if (bodies.frozen[i] != 0) {
      if (scratch.touched[i] != 0) escape_or_halt(bodies, kEscapeFactor * def.freeze_energy, i);
    } else if (count_rest(world, i, dt_s)) {
      scratch.freeze_candidates[i] = {true, std::numeric_limits<double>::infinity()};
      any = true;
    }
  }
  wake_unsupported(world);
  ContactObjects found;
  if (any) {
    collect_contact_objects(world, scratch.freeze_candidates, found);
    freeze_supported(world, found);
  }
  if (any || bodies.frozen != scratch.frozen_before) merge_contact_objects(world, found);
  return {};
}

void hash_update_freezing(const World& world, Hasher& hasher) {
  const Bodies& bodies = world.bodies();
  hasher.add(std::span<const std::uint8_t>(bodies.frozen));
  hasher.add(std::span<const double>(bodies.low_energy_time));
  for (const auto* column :
       {&bodies.velocity.x, &bodies.velocity.y, &bodies.velocity.z, &bodies.spin.x, &bodies.spin.y, &bodies.spin.z}) {
    hasher.add(std::span<const double>(*column));
  }
  hasher.add(std::span<const BodyIndex>(world.state().contact_objects.body));
  hasher.add(std::span<const BodyIndex>(world.state().contact_objects.object));
}

void find_first_contact_objects(World& world) {
  const std::vector<std::uint8_t>& frozen = world.bodies().frozen;
  if (std::find(frozen.begin(), frozen.end(), 1) == frozen.end()) return;
  // Boxes grown by half the gap on every side overlap exactly where the real ones touch.
  World grown = world;
  Bodies& bodies = grown.mutable_state().bodies;
  const Vec3 growth = Vec3::Constant(kTouchGap / 2);
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies.half_extent.set(i, bodies.half_extent[i] + growth);
  (void)find_pairs(grown, 0);
  Contacts& contacts = grown.mutable_scratch().contacts;
  const auto add = [&](BodyIndex a, BodyIndex b, const Vec3& normal) {
    contacts.a.push_back(a);
    contacts.b.push_back(b);
    contacts.normal.push_back(normal);
  };
  const PairTable& pairs = grown.state().pairs;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const BodyIndex a = pairs.a[k], b = pairs.b[k];
    const BoxPair pair(grown.scratch().frames[a], grown.scratch().frames[b]);
    if (pair.separating(kFaces | kEdges) != 0) continue;
    const BestAxes best = pair.best(kFaces);
    add(a, b, best.axes != 0 ? pair.normal(std::countr_zero(best.axes)) : Vec3(Vec3::Zero()));
  }
  const bool ground = world.state().def.ground;
  for (BodyIndex i = 0; ground && i < bodies.size(); ++i) {
    const BoxFrame& frame = grown.scratch().frames[i];
    if (reach_along(frame, 2) > frame.position.z()) add(i, kGround, Vec3(0, 0, -1));
  }
  std::vector<FreezeCandidate> candidates(bodies.size());
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    candidates[i] = {bodies.frozen[i] != 0, std::numeric_limits<double>::infinity()};
  }
  collect_contact_objects(grown, candidates, world.mutable_state().contact_objects);
}

}  // namespace tumble::sim
