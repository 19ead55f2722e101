#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/blame/body_motion.h"
#include "src/world/scratch.h"
#include "tumble/sim/world.h"

/// Rules of docs/step.md that can be checked from outside, for one body; in method thesis for all bodies, since a step
/// of many substeps passes a mistake on before it ends. Each follows from values before and after a
/// phase, without the code of the phase: a phase that leaves something out shows in no value that it writes, but here.
namespace tumble::replay {

/// The part of one contact in what a phase did to the body.
struct ContactPart {
  std::optional<sim::BodyId> other;  ///< none: the ground
  sim::Vec3 velocity = sim::Vec3::Zero(), spin = sim::Vec3::Zero();
  sim::Vec3 position = sim::Vec3::Zero();  ///< m, by which the contact moved the body out of the other one
};

/// A rule that a phase did not keep for the contact of two bodies.
struct BrokenRule {
  std::uint32_t substep = 0;
  std::string phase = {};
  bool step_before = false;  ///< the state with which the step began shows it: the phase of the step before
  sim::BodyId body = 0;
  std::optional<sim::BodyId> other = {};  ///< none: the ground
  std::string value = {}, unit = {};      ///< of `wanted` and `found`
  double wanted = 0, found = 0;
  std::string text = {};  ///< for people: the rule, and what was found instead
};

/// Checks the rules while a step is taken. Each rule that is broken is told once a phase and contact, those of the body
/// asked about first.
class PhaseRules {
 public:
  /// The world must stand before the step, its inputs applied; `body` must exist in it.
  PhaseRules(const sim::World& world, sim::BodyId body);

  /// parts: what contacts did to the body in the phase.
  void phase_done(std::uint32_t substep, const std::string& phase, const sim::World& world,
                  const std::vector<ContactPart>& parts);

  [[nodiscard]] std::vector<BrokenRule> take();

 private:
  using Other = std::optional<sim::BodyId>;

  [[nodiscard]] Other id_of(sim::BodyIndex row) const {
    return row == sim::kGround || row >= ids_.size() ? std::nullopt : Other(ids_[row]);
  }
  void add(BrokenRule rule);
  void find_pair_list(std::uint32_t substep, const std::string& phase, const sim::World& world);

  // Method layered (layered_rules.cc).
  void look_layered(std::uint32_t substep, const std::string& phase, const sim::World& world,
                    const std::vector<ContactPart>& parts);
  void carries_impulses(std::uint32_t substep, const sim::World& world, const std::vector<ContactPart>& parts);
  void note_points(const sim::World& world);
  void moves_separations(std::uint32_t substep, const sim::World& world);

  // Method thesis (thesis_rules.cc).
  void look_thesis(std::uint32_t substep, const std::string& phase, const sim::World& world);
  void keeps_planes(std::uint32_t substep, const sim::World& world);
  void takes_way_back(std::uint32_t substep, const sim::World& world);
  void takes_way_back_of(std::uint32_t substep, const sim::World& world, std::size_t contact, unsigned side);
  void forgets_planes(std::uint32_t substep, const sim::World& world, bool step_before);
  void note_planes(const sim::World& world);

  sim::BodyIndex row_ = 0;
  std::vector<sim::BodyId> ids_;
  // A point of the body as push_contacts left it, m; its levers, which turn when the bodies have moved.
  struct PointBefore {
    double separation = 0, p = 0, q = 0;
    sim::Vec3 d = sim::Vec3::Zero();
  };
  std::vector<PointBefore> points_;
  std::map<std::pair<sim::BodyIndex, sim::BodyIndex>, std::uint16_t> planes_;  // of all pairs, when a substep ended
  std::vector<BrokenRule> broken_;
};

}  // namespace tumble::replay
