// What a phase of method thesis writes is in its hash.
#include <algorithm>
#include <cstdint>
#include <vector>

#include "src/world/scratch.h"
#include "tests/sim/phase_fields.h"

namespace tumble::sim {
namespace {

Bodies& bodies(World& world) { return world.mutable_state().bodies; }

/// The first body in a collision.
std::size_t touched(const World& world) {
  const std::vector<std::uint8_t>& all = world.scratch().touched;
  const auto found = std::ranges::find(all, 1);
  return found == all.end() ? 0 : static_cast<std::size_t>(found - all.begin());
}

std::vector<Field> thesis_fields() {
  const auto contacts = [](World& world) -> Contacts& { return world.mutable_scratch().contacts; };
  return {
      {"integrate", "spin", [](World& w) { bodies(w).spin.x[0] += 1; }},
      {"find_pairs", "planes taken over", [](World& w) { w.mutable_scratch().old_planes[0] ^= 1; }},
      {"find_pairs", "axes", [](World& w) { w.mutable_scratch().frames[0].axes.axis[0].x() += 1; }},
      {"find_pairs", "aabb_low", [](World& w) { w.mutable_scratch().aabb_low.z[0] += 1; }},
      {"find_planes", "planes", [](World& w) { w.mutable_state().pairs.planes[0] ^= 1; }},
      {"find_contacts", "planes", [=](World& w) { contacts(w).planes[0] ^= 1; }},
      {"find_contacts", "r_b", [=](World& w) { contacts(w).r_b.y[0] += 1; }},
      {"compute_impulses", "gains, velocity",
       [](World& w) { w.mutable_scratch().gains[touched(w)].velocity.z() += 1; }},
      {"compute_impulses", "gains, spin", [](World& w) { w.mutable_scratch().gains[touched(w)].spin.x() += 1; }},
      {"find_contacts", "patch", [=](World& w) { contacts(w).patch[0].z() += 1; }},
      {"find_contacts", "patch_end", [=](World& w) { ++contacts(w).patch_end[0]; }},
      {"compute_impulses", "gains, way back",
       [](World& w) { w.mutable_scratch().gains[touched(w)].way_back.y() += 1; }},
      {"compute_impulses", "hit", [](World& w) { w.mutable_scratch().hit[0] ^= 1; }},
      {"compute_impulses", "touched", [](World& w) { w.mutable_scratch().touched[0] ^= 1; }},
      {"compute_separation", "displacement", [](World& w) { w.mutable_scratch().displacement.z[touched(w)] += 1; }},
      {"apply_outcomes", "position", [](World& w) { bodies(w).position.z[touched(w)] += 1; }},
      {"apply_outcomes", "velocity", [](World& w) { bodies(w).velocity.x[touched(w)] += 1; }},
      {"apply_outcomes", "spin", [](World& w) { bodies(w).spin.y[touched(w)] += 1; }},
      {"apply_outcomes", "removed_energy", [](World& w) { w.mutable_scratch().removed_energy += 1; }},
      {"recheck_planes", "planes", [](World& w) { w.mutable_state().pairs.planes[0] ^= 1; }},
      {"update_freezing", "low_energy_time", [](World& w) { bodies(w).low_energy_time[0] += 1; }},
  };
}

TEST(PhaseHashes, CoverWhatThePhasesOfTheThesisWrite) { try_all(Method::kThesis, thesis_fields()); }

}  // namespace
}  // namespace tumble::sim
