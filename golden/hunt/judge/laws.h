#pragma once

#include "golden/hunt/judge/relation.h"

/// Laws of physics, judged from states, inputs and contacts of a session alone. Each computes with its own arithmetic
/// and none of the solver's. docs/hunting.md gives their bounds.
namespace tumble::hunt {

Judgement judge_finishes(const Trace& trace);
Judgement judge_start(const Trace& trace);  ///< state 0 is the scene's
Judgement judge_numbers(const Trace& trace);
Judgement judge_energy(const Trace& trace);
Judgement judge_momentum(const Trace& trace);
Judgement judge_angular_momentum(const Trace& trace);
Judgement judge_cone(const Trace& trace);
Judgement judge_overlap(const Trace& trace);
Judgement judge_parting(const Trace& trace);  ///< boxes that begin inside one another
Judgement judge_unmet(const Trace& trace);    ///< no impulse between shapes that do not meet
Judgement judge_flight(const Trace& trace);   ///< ballistic; angular momentum and energy of spin stay
Judgement judge_halved(const Trace& trace);   ///< flights with half of dt end in one place
Judgement judge_slope(const Trace& trace);
Judgement judge_bounce(const Trace& trace);
Judgement judge_standing(const Trace& trace);

/// The worst value of a law so far, against its bound.
class Worst {
 public:
  explicit Worst(std::string unit) : unit_(std::move(unit)) {}

  /// A value found in the step that leads to state `step`. A value that is no number breaks the law, and so
  /// does a bound that is none or overflows: it bounds nothing.
  void add(std::uint64_t step, sim::BodyId body, double value, double bound, const char* what);

  /// Broken at the first step in which a value was beyond its bound; held: the value nearest to its bound.
  [[nodiscard]] Judgement judgement() const { return worst_; }
  [[nodiscard]] bool is_broken() const { return worst_.outcome == Outcome::kBroken; }

 private:
  std::string unit_;
  Judgement worst_;
};

}  // namespace tumble::hunt
