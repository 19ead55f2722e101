#include "src/thesis/update_freezing.h"

#include <algorithm>
#include <limits>

#include "src/thesis/contact_objects.h"
#include "src/world/body_check.h"
#include "src/world/edit_bodies.h"

namespace tumble::sim {
namespace {

bool immovable(const Bodies& bodies, const std::vector<std::uint8_t>& frozen, BodyIndex i) {
  return i == kGround || bodies.is_static[i] != 0 || frozen[i] != 0;
}

void halt(Bodies& bodies, BodyIndex i) {
  bodies.velocity.set(i, Vec3::Zero());
  bodies.spin.set(i, Vec3::Zero());
}

// A frozen body that was hit: it escapes, or loses the velocity that the impulse gave.
void escape_or_halt(Bodies& bodies, double escape_energy, BodyIndex i) {
  if (energy_per_mass(bodies, i) > escape_energy) {
    bodies.frozen[i] = 0;
    bodies.low_energy_time[i] = 0;
  } else {
    halt(bodies, i);
  }
}

// A moving body: counts the time at low energy. Returns whether that time and a collision make it a candidate.
bool count_rest(WorldState& state, Scratch& scratch, BodyIndex i, double dt_s) {
  const WorldDef& def = state.def;
  Bodies& bodies = state.bodies;
  const bool low = energy_per_mass(bodies, i) < def.freeze_energy;
  bodies.low_energy_time[i] = low ? bodies.low_energy_time[i] + dt_s : 0;
  return def.freezing && low && bodies.low_energy_time[i] >= def.freeze_time && scratch.touched[i] != 0;
}

void mark_candidates(FreezeScratch& freezing, std::size_t bodies) {
  freezing.candidates.assign(bodies, {});
  for (const BodyIndex i : freezing.ready) freezing.candidates[i] = {true, std::numeric_limits<double>::infinity()};
}

// A frozen body wakes when any of its contact objects moves.
void wake_unsupported(WorldState& state, Scratch& scratch) {
  Bodies& bodies = state.bodies;
  const std::vector<std::uint8_t>& before = scratch.freezing.frozen_before;
  const ContactObjects& objects = state.contact_objects;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    const BodyIndex i = objects.body[k];
    if (bodies.frozen[i] != 0 && !immovable(bodies, before, objects.object[k])) {
      bodies.frozen[i] = 0;
      bodies.low_energy_time[i] = 0;
    }
  }
}

// Freezes each candidate all of whose contact objects were immovable.
void freeze_supported(WorldState& state, Scratch& scratch, const ContactObjects& found) {
  Bodies& bodies = state.bodies;
  const std::vector<std::uint8_t>& before = scratch.freezing.frozen_before;
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
void merge_contact_objects(WorldState& state, Scratch& scratch, const ContactObjects& found) {
  const Bodies& bodies = state.bodies;
  const std::vector<std::uint8_t>& before = scratch.freezing.frozen_before;
  ContactObjects& merged = scratch.freezing.merged;
  ContactObjects& old = state.contact_objects;
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

Status update_freezing(WorldState& state, Scratch& scratch, double dt_s) {
  const WorldDef& def = state.def;
  Bodies& bodies = state.bodies;
  scratch.freezing.frozen_before = bodies.frozen;
  scratch.freezing.ready.clear();
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.is_static[i] != 0) continue;
    if (bodies.frozen[i] != 0) {
      if (scratch.touched[i] != 0) escape_or_halt(bodies, kEscapeFactor * def.freeze_energy, i);
    } else if (count_rest(state, scratch, i, dt_s)) {
      scratch.freezing.ready.push_back(i);
    }
  }
  wake_unsupported(state, scratch);
  const ContactObjects& found = scratch.freezing.found;
  const bool any = !scratch.freezing.ready.empty();
  scratch.freezing.found.clear();
  if (any) {
    mark_candidates(scratch.freezing, bodies.size());
    collect_contact_objects(state, scratch.contacts, scratch.freezing);
    freeze_supported(state, scratch, found);
  }
  if (any || bodies.frozen != scratch.freezing.frozen_before) merge_contact_objects(state, scratch, found);
  return {};
}

void hash_update_freezing(const WorldState& state, const Scratch& /*scratch*/, Hasher& hasher) {
  const Bodies& bodies = state.bodies;
  hasher.add(std::span<const std::uint8_t>(bodies.frozen));
  hasher.add(std::span<const double>(bodies.low_energy_time));
  hash_frozen_velocities(state.bodies, hasher);
  hasher.add(std::span<const BodyIndex>(state.contact_objects.body));
  hasher.add(std::span<const BodyIndex>(state.contact_objects.object));
}

}  // namespace tumble::sim
