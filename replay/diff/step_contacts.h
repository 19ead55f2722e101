#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tumble/replay/divergence.h"
#include "tumble/replay/log_reader.h"
#include "tumble/sim/step.h"
#include "tumble/sim/vec.h"

/// Contacts of a step. No log holds them; this build computes them by taking the step again.
namespace tumble::replay {

/// A contact of two bodies, or of a body and the ground.
struct StepContact {
  std::uint32_t substep = 0;     ///< 0-based; contacts of method layered, found once a step, have its last one
  sim::BodyId a = 0;             ///< the lower id
  std::optional<sim::BodyId> b;  ///< none: the ground
  sim::Vec3 normal = {0, 0, 0};  ///< from a to b; of the ground: up
  double depth = 0;              ///< m, deepest point; negative: about to touch
  double impulse = 0;            ///< N·s, all points
  [[nodiscard]] bool has(sim::BodyId id) const { return a == id || b == id; }
};

/// Collects the contacts of a step, in the order in which the solver visits them.
class ContactCollector : public sim::Observer {
 public:
  void phase_done(std::uint32_t substep, std::size_t phase, const sim::World& world) override;
  [[nodiscard]] const std::vector<StepContact>& contacts() const { return contacts_; }

 private:
  std::vector<StepContact> contacts_;
};

/// A step that this build took again from the log's own state before it.
struct RetakenStep {
  bool same = false;  ///< equal to the log's: phases, state, counters
  StepRecord record;  ///< by this build, with states
  std::vector<StepContact> contacts;
};

/// Takes step k of first_state() + 1 … last_step() again. Errors: Player::at's, Player::step's.
Result<RetakenStep> retake_step(LogReader& log, std::uint64_t k);

/// The two bodies whose contact is the place of a first difference, if that is plain: the first contact between two
/// bodies that differ; else the first differing body and the only body that it touched. differing: ids of the bodies
/// with different states after the step, ascending.
std::optional<std::pair<sim::BodyId, sim::BodyId>> pair_of(const std::vector<sim::BodyId>& differing,
                                                           const std::vector<StepContact>& contacts);

/// One line: "7 and 9: depth 1.2e-05 m, impulse 0.3 N s, normal 0 0 1, substep 0".
std::string describe(const StepContact& contact);

}  // namespace tumble::replay
