// Rules of method thesis.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "replay/blame/phase_rules.h"
#include "src/base/text.h"
#include "src/collide/box_pair.h"

namespace tumble::replay {
namespace {

constexpr double kWayPart = 1e-6;  // of a way, that rounding explains
constexpr double kWayOff = 1e-10;  // m

sim::BoxFrame frame_of(const sim::Bodies& bodies, sim::BodyIndex i) {
  return {bodies.position[i], sim::axes_of(bodies.orientation[i]), bodies.half_extent[i]};
}

// m, half of the way at a speed in one substep. The observer is not told how often the step was halved: of the lengths
// that a substep can have, the one that explains the way taken back best.
double likely_way(const sim::WorldDef& def, double speed, double back) {
  double best = 0.5 * def.dt * speed;
  for (std::uint32_t parts = 2; parts <= def.substeps; parts *= 2) {
    const double way = 0.5 * def.dt / parts * speed;
    if (std::fabs(way - back) < std::fabs(best - back)) best = way;
  }
  return best;
}

}  // namespace

void PhaseRules::note_planes(const sim::World& world) {
  planes_.clear();
  const sim::PairTable& pairs = world.state().pairs;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    planes_.emplace_hint(planes_.end(), std::pair(pairs.a[k], pairs.b[k]), pairs.planes[k]);
  }
}

// A pair that was in the list keeps its planes; any other pair has none.
void PhaseRules::keeps_planes(std::uint32_t substep, const sim::World& world) {
  const sim::PairTable& pairs = world.state().pairs;
  const std::vector<std::uint16_t>& old = world.scratch().old_planes;
  for (std::size_t k = 0; k < std::min(pairs.size(), old.size()); ++k) {
    const auto before = planes_.find({pairs.a[k], pairs.b[k]});
    const std::uint16_t wanted = before == planes_.end() ? std::uint16_t{0} : before->second;
    if (old[k] == wanted) continue;
    add({.substep = substep,
         .phase = "find_pairs",
         .body = ids_[pairs.a[k]],
         .other = ids_[pairs.b[k]],
         .value = "planes",
         .wanted = static_cast<double>(wanted),
         .found = static_cast<double>(old[k]),
         .text = "the pair begins this substep with the planes " + std::to_string(old[k]) +
                 ", but the one before it left " + std::to_string(wanted)});
  }
}

// Where friction holds a resting body it takes back half of a substep's way as well.
void PhaseRules::takes_way_back(std::uint32_t substep, const sim::World& world) {
  const sim::Scratch& scratch = world.scratch();
  const sim::Contacts& contacts = scratch.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    for (const unsigned side : {0U, 1U}) {
      const sim::BodyIndex row = side == 0 ? contacts.a[k] : contacts.b[k];
      if (row == sim::kGround || row >= scratch.hit.size() || !world.bodies().moves(row)) continue;
      if ((scratch.hit[row] & sim::kHit) == 0) takes_way_back_of(substep, world, k, side);
    }
  }
}

void PhaseRules::takes_way_back_of(std::uint32_t substep, const sim::World& world, std::size_t contact, unsigned side) {
  const sim::Contacts& contacts = world.scratch().contacts;
  const sim::Gain& gain = world.scratch().split.gains[2 * contact + side];
  const sim::Vec3 normal = contacts.normal[contact];
  const sim::Vec3 slowed = gain.velocity - normal * sim::dot(gain.velocity, normal);
  const double back = gain.way_back.norm(), way = likely_way(world.state().def, slowed.norm(), back);
  if (!(std::fabs(way - back) > kWayPart * way + kWayOff)) return;
  add({.substep = substep,
       .phase = "compute_impulses",
       .body = ids_[side == 0 ? contacts.a[contact] : contacts.b[contact]],
       .other = id_of(side == 0 ? contacts.b[contact] : contacts.a[contact]),
       .value = "way back",
       .unit = "m",
       .wanted = way,
       .found = back,
       .text = "rests, and friction takes " + rounded(slowed.norm(), "m/s") + ", so half of that way, " +
               rounded(way, "m") + ", is taken back too; found " + rounded(back, "m")});
}

// A plane that does not separate its pair any more is forgotten when a substep ends.
void PhaseRules::forgets_planes(std::uint32_t substep, const sim::World& world, bool step_before) {
  const sim::Bodies& bodies = world.bodies();
  const sim::PairTable& pairs = world.state().pairs;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const sim::BodyIndex a = pairs.a[k], b = pairs.b[k];
    if (pairs.planes[k] == 0) continue;
    const sim::AxisSet kept = pairs.planes[k], right = sim::separating(frame_of(bodies, a), frame_of(bodies, b), kept);
    if (right == kept) continue;
    add({.substep = substep,
         .phase = "recheck_planes",
         .step_before = step_before,
         .body = ids_[a],
         .other = ids_[b],
         .value = "planes",
         .wanted = static_cast<double>(right),
         .found = static_cast<double>(kept),
         .text = "keeps the planes " + std::to_string(kept) + ", of which " + std::to_string(right) +
                 " still separate the two"});
  }
}

void PhaseRules::look_thesis(std::uint32_t substep, const std::string& phase, const sim::World& world) {
  if (phase == "find_pairs") keeps_planes(substep, world);
  if (phase == "compute_impulses") takes_way_back(substep, world);
  if (phase != "recheck_planes") return;
  note_planes(world);
  forgets_planes(substep, world, false);
}

}  // namespace tumble::replay
