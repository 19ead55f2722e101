#pragma once

#include <cstdint>
#include <optional>

#include "replay/format/step_record.h"
#include "replay/log/session_clock.h"
#include "replay/measure/measure_options.h"
#include "replay/measure/measure_state.h"
#include "src/base/hash.h"
#include "src/base/result.h"

namespace tumble::replay {

struct SymmetryMetrics {
  double lateral_max = 0;               ///< m
  double lateral_rms = 0;               ///< m
  std::optional<double> column_spread;  ///< m; none without a [[grid]]
  // Of a mirrored pair (mirrored_pair.h); none for a session alone.
  std::optional<double> mirror_error;  ///< m
  std::optional<double> order_error;   ///< m
  std::optional<double> shift_error;   ///< m
};

struct EnergyMetrics {
  double initial = 0;                        ///< J, kinetic and potential
  double final = 0;                          ///< J
  double gain_max = 0;                       ///< J
  std::optional<double> gain_ratio;          ///< none where something was gained from nothing
  double removed = 0;                        ///< J, all steps
  double inputs = 0;                         ///< J, all steps
  std::optional<double> bounce_height_loss;  ///< of the first height; none without a bounce
  std::uint64_t bounces = 0;
  std::optional<double> momentum_drift;    ///< of the first angular momentum; none without spin at the start
  std::optional<double> spin_energy_gain;  ///< of the first rotational energy; none without spin at the start
};

struct StackingMetrics {
  double drift_max = 0;                            ///< m
  double tilt_max = 0;                             ///< degrees
  double top_drop_max = 0;                         ///< m
  std::uint64_t lost = 0;                          ///< bodies
  double overlap_max = 0;                          ///< m
  double overlap_peak = 0;                         ///< m
  double ground_penetration_max = 0;               ///< m
  double ground_penetration_peak = 0;              ///< m
  double kinetic_linear_end = 0;                   ///< J
  double kinetic_rotational_end = 0;               ///< J
  double frozen_fraction = 0;                      ///< 0 … 1
  std::optional<double> rest_time = std::nullopt;  ///< s; none if it never rests
  [[nodiscard]] double kinetic_end() const { return kinetic_linear_end + kinetic_rotational_end; }
};

/// How a session behaved, computed from its log alone. docs/metrics.md has each formula, unit and meaning;
/// metric_list.h names them all.
struct Metrics {
  std::uint64_t bodies = 0;  ///< of the start and thrown in since, chosen or not
  std::uint64_t steps = 0;   ///< the last one's number
  SymmetryMetrics symmetry;
  EnergyMetrics energy;
  StackingMetrics stacking;
  Hash128 final_hash;  ///< the state hash after the last step
};

/// What Measurer saw after one step: a row of `measure --series`. Energies in J, of all bodies; "since the start" means
/// since MeasureOptions::from_step.
struct SeriesRow {
  std::uint64_t step = 0;
  double time = 0;  ///< s, since state 0 of the log
  double kinetic = 0;
  double potential = 0;
  double inputs = 0;   ///< since the start
  double removed = 0;  ///< since the start
  double gain = 0;     ///< over the running minimum of the energy without the work of inputs
  std::uint64_t lost = 0;
  std::optional<double> overlap;  ///< m, in the steps that MeasureOptions::overlap_every asks for
  StateMeasures state;
};

/// Measures a session while its steps go by in order.
class Measurer {
 public:
  /// header: of the session.
  explicit Measurer(const LogHeader& header, const MeasureOptions& options = {});

  /// The record of state 0, then those of steps 1, 2, … in order (a log that starts later: from its first state on).
  /// Each needs states from MeasureOptions::from_step on.
  void add(const StepRecord& record);

  /// Whether the step from which on is measured has been reached.
  [[nodiscard]] bool started() const { return meter_.has_value(); }

  /// What the step added last showed. Only when started().
  [[nodiscard]] const SeriesRow& row() const { return row_; }

  /// After the last step. last: its states. Errors (kBadInput): a from_step that was not reached, a choice of bodies
  /// that holds none, so that nothing would have been measured.
  Result<Metrics> finish(const BodyStates& last);

 private:
  void start(const StepRecord& record);
  void apply_before_start(const sim::Command& input);
  void look_at(const StepRecord& record);

  sim::SceneDef scene_;  // as it was at the last step before the start
  MeasureOptions options_;
  std::optional<StateMeter> meter_;
  StateMeter::StartEnergy start_energy_;
  Metrics metrics_;
  SeriesRow row_;  // of the step added last
  SessionClock clock_;
  std::uint64_t records_ = 0;
  double lowest_energy_ = 0;          // running minimum, work of inputs taken out, J
  std::optional<double> rest_since_;  // s
  std::size_t bodies_seen_ = 0;       // the most that a state showed of those chosen
};

}  // namespace tumble::replay
