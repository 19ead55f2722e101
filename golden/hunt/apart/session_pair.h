#pragma once

#include <cstdint>
#include <vector>

#include "golden/hunt/apart/apart_bounds.h"
#include "golden/hunt/judge/relation.h"
#include "replay/measure/measure.h"
#include "replay/measure/parting.h"
#include "tumble/replay/step_record.h"

namespace tumble::hunt {

/// A trace as a log has it: records 0 … N, with states, without hashes.
std::vector<replay::StepRecord> records_of(const Trace& trace);

/// One scene's sessions by two builds, with equally many steps.
class SessionPair {
 public:
  /// The trace of this build, and records 0 … N of the other's session, with states; record 0 is state 0.
  /// Precondition: one record a state of the trace.
  SessionPair(const Trace& mine, const std::vector<replay::StepRecord>& other);

  /// Broken: the measure of the whole session, or of `place` any step before a contact, is further apart than its
  /// bound allows. `step` is then the first after which it is, the session being measured up to there; `what` names
  /// both values there and at their farthest, `value` and `bound` are those of the farthest. Held: the distance at the
  /// end. Not applicable: no session has a value.
  [[nodiscard]] Judgement judge(const ApartBound& bound) const;

 private:
  [[nodiscard]] Judgement judge_place(const ApartBound& bound) const;
  [[nodiscard]] Judgement judge_metric(const ApartBound& bound) const;

  std::vector<replay::Farthest> places_;       // by step from state 0
  std::uint64_t free_steps_ = 0;               // before the first in which anything meets in either
  std::vector<replay::Metrics> mine_, other_;  // of the session up to each step from 1 on
};

}  // namespace tumble::hunt
