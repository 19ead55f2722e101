#include "src/world/edit_bodies.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "src/base/check.h"
#include "src/base/text.h"
#include "src/math/grid.h"
#include "src/model/mass.h"
#include "src/world/body_check.h"
#include "src/world/forget_contacts.h"
#include "tumble/sim/limits.h"

namespace tumble::sim {
namespace {

Error bad_box(const BoxDef& box, const std::string& what) {
  return bad_input("body " + std::to_string(box.id) + ": " + what);
}

std::string range(double low, double high, const char* unit) {
  return number_text(low) + " … " + number_text(high) + " " + unit;
}

template <class T>
void insert_at(std::vector<T>& column, BodyIndex i, T value) {
  column.insert(column.begin() + static_cast<std::ptrdiff_t>(i), value);
}

template <class T>
void erase_at(std::vector<T>& column, BodyIndex i) {
  column.erase(column.begin() + static_cast<std::ptrdiff_t>(i));
}

// Indexes at or behind `first` move by `by`; the ground stays the ground.
void shift_indices(std::vector<BodyIndex>& indices, BodyIndex first, int by) {
  for (BodyIndex& index : indices) {
    if (index != kGround && index >= first) index = static_cast<BodyIndex>(static_cast<std::int64_t>(index) + by);
  }
}

void shift_all(WorldState& state, BodyIndex first, int by) {
  shift_indices(state.pairs.a, first, by);
  shift_indices(state.pairs.b, first, by);
  shift_indices(state.contact_objects.body, first, by);
  shift_indices(state.contact_objects.object, first, by);
  shift_indices(state.contact_memory.a, first, by);
  shift_indices(state.contact_memory.b, first, by);
}

template <class Keep>
void filter_pairs(PairTable& pairs, Keep keep) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!keep(pairs.a[k], pairs.b[k])) continue;
    pairs.a[kept] = pairs.a[k];
    pairs.b[kept] = pairs.b[k];
    pairs.planes[kept] = pairs.planes[k];
    ++kept;
  }
  pairs.a.resize(kept);
  pairs.b.resize(kept);
  pairs.planes.resize(kept);
}

template <class Keep>
void filter_objects(ContactObjects& objects, Keep keep) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < objects.size(); ++k) {
    if (!keep(objects.body[k], objects.object[k])) continue;
    objects.body[kept] = objects.body[k];
    objects.object[kept] = objects.object[k];
    ++kept;
  }
  objects.body.resize(kept);
  objects.object.resize(kept);
}

Vec3 inverse(const Vec3& v) { return {1 / v.x(), 1 / v.y(), 1 / v.z()}; }

}  // namespace

Status check_box(const BoxDef& box) {
  if (box.id == 0 || box.id > kBodyIdMax) return bad_box(box, "found this id, wanted 1 … 2^53 − 1");
  for (const double edge : {box.size.x(), box.size.y(), box.size.z()}) {
    if (!(edge >= kSizeMin && edge <= kSizeMax)) {
      return bad_box(box, "found an edge of " + exact(edge) + " m, wanted " + range(kSizeMin, kSizeMax, "m"));
    }
  }
  if (!(box.mass >= kMassMin && box.mass <= kMassMax)) {
    return bad_box(box, "found a mass of " + exact(box.mass) + " kg, wanted " + range(kMassMin, kMassMax, "kg"));
  }
  if (!within(box.position, kPositionMax)) {
    return bad_box(box, beyond_text("position", box.position, kPositionMax, "m"));
  }
  if (!within(box.velocity, kSpeedMax)) return bad_box(box, beyond_text("velocity", box.velocity, kSpeedMax, "m/s"));
  if (!within(box.spin, kSpeedMax)) return bad_box(box, beyond_text("spin", box.spin, kSpeedMax, "rad/s"));
  const Quat& q = box.orientation;
  const double norm = q.w * q.w + ((q.x * q.x + q.y * q.y) + q.z * q.z);
  if (!(norm > 1e-12 && norm < 1e12)) return bad_box(box, "its orientation has no direction; use [1, 0, 0, 0]");
  if (!material_in_range(box.material)) return bad_box(box, out_of_range(box.material));
  return {};
}

void insert_body(WorldState& state, const BoxDef& box) {
  Bodies& b = state.bodies;
  const auto i = static_cast<BodyIndex>(std::lower_bound(b.id.begin(), b.id.end(), box.id) - b.id.begin());
  SIM_CHECK(i == b.size() || b.id[i] != box.id, box.id);
  SIM_DCHECK(check_box(box).ok(), box.id);
  const bool rests = box.is_static || box.frozen;
  const Vec3 inertia = box_inertia(box.mass, box.size);
  shift_all(state, i, 1);
  insert_at(b.id, i, box.id);
  b.position.insert(i, PositionGrid::round(box.position));
  b.orientation.insert(i, normalised(box.orientation));
  b.velocity.insert(i, rests ? Vec3(Vec3::Zero()) : VelocityGrid::round(box.velocity));
  b.spin.insert(i, rests ? Vec3(Vec3::Zero()) : VelocityGrid::round(box.spin));
  insert_at(b.frozen, i, static_cast<std::uint8_t>(box.frozen && !box.is_static));
  insert_at(b.low_energy_time, i, 0.0);
  b.half_extent.insert(i, box.size * 0.5);
  insert_at(b.mass, i, box.mass);
  insert_at(b.inverse_mass, i, box.is_static ? 0.0 : 1 / box.mass);
  b.inertia.insert(i, box.is_static ? Vec3(Vec3::Zero()) : inertia);
  b.inverse_inertia.insert(i, box.is_static ? Vec3(Vec3::Zero()) : inverse(inertia));
  insert_at(b.friction, i, box.material.friction);
  insert_at(b.friction_dynamic, i, box.material.friction_dynamic);
  insert_at(b.restitution, i, box.material.restitution);
  insert_at(b.is_static, i, static_cast<std::uint8_t>(box.is_static));
}

void erase_body(WorldState& state, BodyIndex i) {
  SIM_CHECK(i < state.bodies.size(), i, state.bodies.size());
  std::vector<BodyIndex> resting = forget_contacts(state, i);
  for (std::size_t k = 0; k < state.contact_objects.size(); ++k) {
    if (state.contact_objects.object[k] == i) resting.push_back(state.contact_objects.body[k]);
  }
  restart_rest(state, i);
  for (const BodyIndex body : resting) wake_body(state, body);
  filter_pairs(state.pairs, [&](BodyIndex a, BodyIndex b) { return a != i && b != i; });
  filter_objects(state.contact_objects, [&](BodyIndex body, BodyIndex) { return body != i; });

  Bodies& b = state.bodies;
  erase_at(b.id, i);
  b.position.erase(i);
  b.orientation.erase(i);
  b.velocity.erase(i);
  b.spin.erase(i);
  b.half_extent.erase(i);
  b.inertia.erase(i);
  b.inverse_inertia.erase(i);
  for (auto* column : {&b.frozen, &b.is_static}) erase_at(*column, i);
  for (auto* column :
       {&b.low_energy_time, &b.mass, &b.inverse_mass, &b.friction, &b.friction_dynamic, &b.restitution}) {
    erase_at(*column, i);
  }
  shift_all(state, i, -1);
}

void wake_body(WorldState& state, BodyIndex i) {
  SIM_CHECK(i < state.bodies.size(), i, state.bodies.size());
  state.bodies.low_energy_time[i] = 0;
  if (state.bodies.frozen[i] == 0) return;
  state.bodies.frozen[i] = 0;
  filter_objects(state.contact_objects, [&](BodyIndex body, BodyIndex) { return body != i; });
}

void restart_rest(WorldState& state, BodyIndex i) {
  SIM_CHECK(i < state.bodies.size(), i, state.bodies.size());
  // A frozen body's timer is zero.
  const auto restart = [&](BodyIndex body) {
    if (body != kGround) state.bodies.low_energy_time[body] = 0;
  };
  const auto restart_partners = [&](const std::vector<BodyIndex>& a, const std::vector<BodyIndex>& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (a[k] == i) restart(b[k]);
      if (b[k] == i) restart(a[k]);
    }
  };
  restart(i);
  restart_partners(state.contact_memory.a, state.contact_memory.b);
  restart_partners(state.pairs.a, state.pairs.b);
}

}  // namespace tumble::sim
