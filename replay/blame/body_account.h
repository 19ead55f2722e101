#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/blame/body_motion.h"
#include "replay/blame/phase_rules.h"
#include "src/world/scratch.h"
#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

/// Every change of one body's motion within one step, phase by phase, with the parts that its contacts had in it.
namespace tumble::replay {

/// A phase that changed the body's motion, or in which contacts acted on it.
struct Write {
  std::uint32_t substep = 0;
  std::string phase;
  BodyMotion before, after;
  std::vector<ContactPart> parts;  ///< in the order of their first effect
};

/// What the phases of a step left of one contact of the body. Numbers are zero where the method keeps none.
struct ContactFacts {
  std::optional<sim::BodyId> other;  ///< none: the ground
  std::string found_by;              ///< the phase
  unsigned points = 0;
  sim::Vec3 normal = sim::Vec3::Zero();  ///< towards the body
  double separation = 0;                 ///< m, the least of its points, as found; negative where they overlap
  double friction = 0, restitution = 0;
  double recalled = 0;  ///< N·s, impulses that the contact had at the end of the last step
  double load = 0;      ///< N·s a substep, the weight that it bears at rest (carry_weights)
  double started = 0;   ///< N·s that carry_weights gave a new contact to start from
  double approach = 0;  ///< m/s, of the point that meets fastest; negative where the bodies meet (prepare_manifolds)
  double split = 1;     ///< manifolds that share the body's mass in its layer
  std::uint32_t layer = 0;
  int sweeps = 0;
  bool hard = false;  ///< its island is solved with many sweeps (assign_levels)
  bool fast = false;  ///< a fast pair: found anew in every substep
  bool asleep = false;
  bool woke = false;          ///< one of its bodies was woken in this step
  double depth = 0;           ///< m, thesis: of the collision
  bool rests = false;         ///< thesis: friction at rest takes back a part of the way
  std::uint32_t substep = 0;  ///< the last one in which it acted
};

/// A step as one body saw it.
struct BodyAccount {
  std::uint64_t step = 0;
  double dt = 0, substep_s = 0;
  sim::BodyId body = 0;
  BodyMotion start, end;      ///< start: after the inputs
  double mass = 0, lent = 0;  ///< kg; lent: in the solver, above its own mass
  sim::Vec3 gravity = sim::Vec3::Zero();
  double air_drag = 0;
  bool is_static = false;
  std::vector<Write> writes;           ///< in order
  std::vector<ContactFacts> contacts;  ///< by other body, each once, the ground first
  std::size_t near_pairs = 0;          ///< pairs of the body that were near enough to be tested
  std::vector<sim::BodyId> near;       ///< their other bodies, ascending
  bool remembered = false;             ///< the step before left a contact of the body
  std::vector<BrokenRule> broken;      ///< rules that phases did not keep for the body

  [[nodiscard]] const ContactFacts* contact_with(const std::optional<sim::BodyId>& other) const;
};

/// Fills in an account while a step is taken. Give it to the step as its observer, and to the world by watch().
class AccountObserver : public sim::Observer, public sim::LayerObserver {
 public:
  /// The world must stand before the step, its inputs applied; `body` must exist in it.
  AccountObserver(const sim::World& world, sim::BodyId body);

  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override;
  void layer_solved(const sim::Scratch& scratch, const sim::ContactBatches& all, std::size_t layer) override;

  [[nodiscard]] BodyAccount take() {
    account_.broken = rules_.take();
    return std::move(account_);
  }

 private:
  [[nodiscard]] BodyMotion now(const sim::World& world) const;
  ContactPart& part_of(const std::optional<sim::BodyId>& other);
  ContactFacts& facts_of(const std::optional<sim::BodyId>& other);
  void look_layered(const std::string& phase, std::uint32_t substep, const sim::World& world);
  void look_thesis(const std::string& phase, std::uint32_t substep, const sim::World& world);
  void look_at_manifolds(const std::string& phase, const sim::World& world);
  void look_at_weights(const sim::World& world);
  void look_at_batches(const sim::Scratch& scratch, const sim::ContactBatches& all, std::uint32_t substep, bool fast);
  void look_at_near_pairs(const sim::World& world);

  BodyAccount account_;
  PhaseRules rules_;
  sim::BodyIndex row_ = 0;
  std::vector<sim::BodyId> ids_;
  std::vector<std::uint8_t> frozen_;  // at the start of the step
  std::vector<ContactPart> parts_;    // since the last phase
  BodyMotion last_;
  bool parting_ = false;  // within part_overlaps, whose outcomes move places
  bool in_solver_ = false;
};

}  // namespace tumble::replay
