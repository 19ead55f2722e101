#include "replay/blame/phase_rules.h"

#include <algorithm>

#include "src/base/check.h"

namespace tumble::replay {
namespace {

bool overlap(const sim::Scratch& scratch, sim::BodyIndex i, sim::BodyIndex j) {
  const sim::Vec3 low_i = scratch.aabb_low[i], high_i = scratch.aabb_high[i];
  const sim::Vec3 low_j = scratch.aabb_low[j], high_j = scratch.aabb_high[j];
  return (low_i.array() < high_j.array()).all() && (low_j.array() < high_i.array()).all();
}

}  // namespace

PhaseRules::PhaseRules(const sim::World& world, sim::BodyId body) : ids_(world.bodies().id) {
  const std::optional<sim::BodyIndex> row = world.bodies().find(body);
  SIM_CHECK(row.has_value(), body);
  row_ = *row;
  if (world.state().def.method != sim::Method::kThesis) return;
  note_planes(world);
  forgets_planes(0, world, true);
}

void PhaseRules::add(BrokenRule rule) {
  const bool told = std::ranges::any_of(broken_, [&](const BrokenRule& one) {
    return one.phase == rule.phase && one.value == rule.value && one.body == rule.body && one.other == rule.other &&
           one.step_before == rule.step_before;
  });
  if (!told) broken_.push_back(std::move(rule));
}

std::vector<BrokenRule> PhaseRules::take() {
  const sim::BodyId own = ids_[row_];
  std::stable_partition(broken_.begin(), broken_.end(),
                        [&](const BrokenRule& rule) { return rule.body == own || rule.other == own; });
  return std::move(broken_);
}

// Boxes that overlap along all three axes are a pair, where one of them moves.
void PhaseRules::find_pair_list(std::uint32_t substep, const std::string& phase, const sim::World& world) {
  const sim::Scratch& scratch = world.scratch();
  const sim::Bodies& bodies = world.bodies();
  if (scratch.aabb_low.size() != bodies.size()) return;
  const sim::PairTable& pairs = world.state().pairs;
  std::vector<sim::BodyIndex> listed;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs.a[k] == row_) listed.push_back(pairs.b[k]);
    if (pairs.b[k] == row_) listed.push_back(pairs.a[k]);
  }
  for (sim::BodyIndex j = 0; j < bodies.size(); ++j) {
    if (j == row_ || (!bodies.moves(j) && !bodies.moves(row_)) || !overlap(scratch, row_, j)) continue;
    if (std::ranges::find(listed, j) != listed.end()) continue;
    add({.substep = substep,
         .phase = phase,
         .body = ids_[row_],
         .other = id_of(j),
         .value = "pair",
         .wanted = 1,
         .text = "their boxes along the axes overlap, but the pair is not in the list"});
  }
}

void PhaseRules::phase_done(std::uint32_t substep, const std::string& phase, const sim::World& world,
                            const std::vector<ContactPart>& parts) {
  if (phase == "find_pairs" || phase == "find_near_pairs") find_pair_list(substep, phase, world);
  world.state().def.method == sim::Method::kThesis ? look_thesis(substep, phase, world)
                                                   : look_layered(substep, phase, world, parts);
}

}  // namespace tumble::replay
