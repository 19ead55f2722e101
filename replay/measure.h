#pragma once

#include <cstdint>
#include <optional>

#include "replay/measure_state.h"
#include "replay/session_clock.h"
#include "replay/step_record.h"
#include "src/base/hash.h"

namespace tumble::replay {

struct SymmetryMetrics {
  double lateral_max = 0;               ///< m
  double lateral_rms = 0;               ///< m
  std::optional<double> column_spread;  ///< m; none without a [[grid]]
};

struct EnergyMetrics {
  double initial = 0;                ///< J, kinetic and potential
  double final = 0;                  ///< J
  double gain_max = 0;               ///< J
  std::optional<double> gain_ratio;  ///< none where something was gained from nothing
  double removed = 0;                ///< J, all steps
  double inputs = 0;                 ///< J, all steps
};

struct StackingMetrics {
  double drift_max = 0;               ///< m
  double tilt_max = 0;                ///< degrees
  double top_drop_max = 0;            ///< m
  std::uint64_t lost = 0;             ///< bodies
  double overlap_max = 0;             ///< m
  double ground_penetration_max = 0;  ///< m
  double kinetic_end = 0;             ///< J
  double frozen_fraction = 0;         ///< 0 … 1
  std::optional<double> rest_time;    ///< s; none if it never rests
};

/// How a session behaved, computed from its log alone. docs/metrics.md has each formula, unit and meaning.
struct Metrics {
  std::uint64_t bodies = 0;  ///< of state 0 and thrown in since
  std::uint64_t steps = 0;
  SymmetryMetrics symmetry;
  EnergyMetrics energy;
  StackingMetrics stacking;
  Hash128 final_hash;  ///< the state hash after the last step
};

/// What Measurer saw after one step: a row of `measure --series`. Energies in J.
struct SeriesRow {
  std::uint64_t step = 0;
  double time = 0;  ///< s, since state 0
  double kinetic = 0;
  double potential = 0;
  double inputs = 0;   ///< since state 0
  double removed = 0;  ///< since state 0
  double gain = 0;     ///< over the running minimum of the energy without the work of inputs
  std::uint64_t lost = 0;
  StateMeasures state;
};

/// Measures a session while its steps go by in order.
class Measurer {
 public:
  /// header: of the session. start: the record of step 0, which has states.
  Measurer(const LogHeader& header, const StepRecord& start);

  /// Steps 1, 2, … in order, each with states.
  void add(const StepRecord& record);

  /// What the step added last showed; state 0 before the first.
  [[nodiscard]] const SeriesRow& row() const { return row_; }

  /// After the last step. last: its state.
  [[nodiscard]] Metrics finish(const BodyStates& last);

 private:
  void look_at(const BodyStates& states);

  StateMeter meter_;
  StateMeter::StartEnergy start_energy_;
  Metrics metrics_;
  SeriesRow start_row_;
  SeriesRow row_;  // of the step added last
  SessionClock clock_;
  double lowest_energy_;              // running minimum, work of inputs taken out, J
  std::optional<double> rest_since_;  // s
};

}  // namespace tumble::replay
