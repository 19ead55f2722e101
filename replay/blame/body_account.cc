#include "replay/blame/body_account.h"

#include <algorithm>
#include <utility>

#include "src/base/check.h"

namespace tumble::replay {
namespace {

bool same_values(const BodyMotion& a, const BodyMotion& b) {
  return std::ranges::equal(a.values, b.values, same_value);
}

// Whether a phase that did not move the body leaves the parts for a later phase that does.
bool keeps_parts(const std::string& phase) { return phase == "compute_impulses" || phase == "compute_separation"; }

}  // namespace

const ContactFacts* BodyAccount::contact_with(const std::optional<sim::BodyId>& other) const {
  const auto found = std::ranges::find_if(contacts, [&](const ContactFacts& facts) { return facts.other == other; });
  return found == contacts.end() ? nullptr : &*found;
}

AccountObserver::AccountObserver(const sim::World& world, sim::BodyId body) : rules_(world, body) {
  const sim::WorldState& state = world.state();
  const std::optional<sim::BodyIndex> row = state.bodies.find(body);
  SIM_CHECK(row.has_value(), body);
  row_ = *row;
  ids_ = state.bodies.id;
  frozen_ = state.bodies.frozen;
  account_.step = state.step + 1;
  account_.body = body;
  account_.dt = state.def.dt;
  account_.gravity = state.def.gravity;
  account_.air_drag = state.def.air_drag;
  account_.mass = state.bodies.mass[row_];
  account_.is_static = state.bodies.is_static[row_] != 0;
  account_.substep_s = state.def.dt / state.def.substeps;
  last_ = account_.start = account_.end = motion_of(state.bodies, row_);
  const sim::ContactMemory& memory = state.contact_memory;
  for (std::size_t k = 0; k < memory.size(); ++k) {
    account_.remembered = account_.remembered || memory.a[k] == row_ || memory.b[k] == row_;
  }
}

// In method layered the solver has the velocities of bodies in contact until finish_motion puts them back.
BodyMotion AccountObserver::now(const sim::World& world) const {
  BodyMotion motion = motion_of(world.bodies(), row_);
  const sim::Scratch& scratch = world.scratch();
  if (in_solver_ && row_ < scratch.in_contact.size() && scratch.in_contact[row_] != 0) {
    motion.set(kVelocity, sim::plus_zero(scratch.solver_bodies[row_].velocity));
    motion.set(kSpin, sim::plus_zero(scratch.solver_bodies[row_].spin));
  }
  return motion;
}

ContactPart& AccountObserver::part_of(const std::optional<sim::BodyId>& other) {
  const auto found = std::ranges::find_if(parts_, [&](const ContactPart& part) { return part.other == other; });
  if (found != parts_.end()) return *found;
  parts_.push_back({});
  parts_.back().other = other;
  return parts_.back();
}

ContactFacts& AccountObserver::facts_of(const std::optional<sim::BodyId>& other) {
  std::vector<ContactFacts>& all = account_.contacts;
  const auto at = std::ranges::lower_bound(all, other, {}, &ContactFacts::other);
  if (at != all.end() && at->other == other) return *at;
  ContactFacts facts;
  facts.other = other;
  return *all.insert(at, facts);
}

void AccountObserver::look_at_near_pairs(const sim::World& world) {
  const sim::PairTable& pairs = world.state().pairs;
  account_.near.clear();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs.a[k] != row_ && pairs.b[k] != row_) continue;
    account_.near.push_back(ids_[pairs.a[k] == row_ ? pairs.b[k] : pairs.a[k]]);
  }
  std::ranges::sort(account_.near);
}

void AccountObserver::phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) {
  const sim::Method method = world.state().def.method;
  const std::string name = sim::phase_table(method).phases[phase].name;
  if (name == "prepare_manifolds") in_solver_ = true;
  if (name == "finish_motion") in_solver_ = false;
  parting_ = name == "prepare_manifolds";
  if (name == "find_near_pairs" || name == "find_pairs") look_at_near_pairs(world);
  method == sim::Method::kThesis ? look_thesis(name, substep, world) : look_layered(name, substep, world);
  rules_.phase_done(substep, name, world, parts_);
  const BodyMotion motion = now(world);
  if (!same_values(last_, motion)) account_.writes.push_back({substep, name, last_, motion, std::move(parts_)});
  last_ = account_.end = motion;
  if (!keeps_parts(name)) parts_.clear();
}

}  // namespace tumble::replay
