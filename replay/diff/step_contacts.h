#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "replay/diff/divergence.h"
#include "replay/log/log_reader.h"
#include "src/math/vec.h"
#include "src/step/step.h"

/// What no log holds and only a step taken again shows: which bodies met, and how.
namespace tumble::replay {

/// Where two bodies, or a body and the ground, touched in a step.
struct StepContact {
  std::uint32_t substep = 0;     ///< 0-based; contacts of method layered, found once a step, have its last one
  sim::BodyId a = 0;             ///< the lower id
  std::optional<sim::BodyId> b;  ///< none: the ground
  sim::Vec3 normal = {0, 0, 0};  ///< from a to b; of the ground: up
  double depth = 0;              ///< m, deepest point; negative: about to touch
  double impulse = 0;            ///< N·s, all points
  [[nodiscard]] bool has(sim::BodyId id) const { return a == id || b == id; }
};

/// Collects the contacts of a step, in the order in which they are solved by.
class ContactCollector : public sim::Observer {
 public:
  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override;
  [[nodiscard]] const std::vector<StepContact>& contacts() const { return contacts_; }

 private:
  std::vector<StepContact> contacts_;
};

/// A step of a log, taken again by this build from the log's own state before it.
struct RetakenStep {
  bool same = false;  ///< as recorded: phases, state, counters
  StepRecord record;  ///< what this build makes of it, with states
  std::vector<StepContact> contacts;
};

/// Retakes step k of first_state() + 1 … last_step(). Errors: as Player::at() and Player::step().
Result<RetakenStep> retake_step(LogReader& log, std::uint64_t k);

/// The two bodies whose meeting a first difference lies in, if it is plain: the first contact of two of the bodies that
/// differ, else the only body that the first of them touched. differing: the bodies with different states after the
/// step, the first one first.
std::optional<std::pair<sim::BodyId, sim::BodyId>> pair_of(const std::vector<sim::BodyId>& differing,
                                                           const std::vector<StepContact>& contacts);

/// Bodies of both states that differ in any bit, ascending.
std::vector<sim::BodyId> differing_bodies(const BodyStates& a, const BodyStates& b);

/// One line: "7 and 9: depth 1.2e-05 m, impulse 0.3 N s, normal 0 0 1, sub-step 0".
std::string describe(const StepContact& contact);

}  // namespace tumble::replay
