#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/log/session_clock.h"
#include "replay/measure/channel_metrics.h"
#include "replay/measure/measure_options.h"
#include "replay/measure/measure_state.h"
#include "replay/measure/parting.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

struct SymmetryMetrics {
  double lateral_max = 0;               ///< m
  double lateral_rms = 0;               ///< m
  std::optional<double> column_spread;  ///< m; none without a [[grid]]
  // These compare a mirrored pair (mirrored_pair.h); none for a session alone.
  std::optional<double> mirror_error;  ///< m
  std::optional<double> order_error;   ///< m
  std::optional<double> shift_error;   ///< m
};

struct EnergyMetrics {
  double initial = 0;                        ///< J, kinetic and potential
  double final = 0;                          ///< J
  double gain_max = 0;                       ///< J
  std::optional<double> gain_ratio;          ///< none where something was gained from nothing
  std::optional<double> removed;             ///< J, all steps; none for another engine, which tells no dissipation
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

/// The metrics of a session, computed from its log alone. A number that is none, in a state or in a counter, is never
/// dropped: the value is NaN then. MetricRow::value() also answers so for counts. docs/metrics.md has each formula,
/// unit and meaning; metric_list.h has the table of names.
struct Metrics {
  std::uint64_t bodies = 0;           ///< of the start and thrown in later, chosen or not
  std::uint64_t steps = 0;            ///< the number of the last one
  std::uint64_t measured_steps = 0;   ///< after the state with which the measuring begins
  std::uint64_t measured_bodies = 0;  ///< the most that a state showed of those chosen, static ones left out
  std::uint64_t bodies_at_end = 0;    ///< of those, in the last state
  std::uint64_t of_start_at_end = 0;  ///< of those, the bodies that the start has too
  SymmetryMetrics symmetry;
  EnergyMetrics energy;
  StackingMetrics stacking;
  std::vector<ChannelMetrics> channels;     ///< of the log, by ascending names
  std::vector<Parting> partings;            ///< from another session; the Measurer knows none
  Hash128 final_hash;                       ///< the state hash after the last step
  std::vector<std::string> approximations;  ///< for people: of bodies, and of channels
  std::string told;                         ///< ToldWatch::note(), which measure_log() sets
  std::optional<FirstLost> first_lost;      ///< of StackingMetrics::lost
  LostBodies not_finite;                    ///< bodies that were not finite in a measured state
};

/// One row of `measure --series`: the measures after one step. Energies in J, of all bodies; "since the start" means
/// since MeasureOptions::from_step.
struct SeriesRow {
  std::uint64_t step = 0;
  double time = 0;  ///< s, since state 0 of the log
  double kinetic = 0;
  double potential = 0;
  double inputs = 0;              ///< since the start
  std::optional<double> removed;  ///< since the start; none for another engine
  double gain = 0;                ///< over the running minimum of the energy without the work of inputs
  std::uint64_t lost = 0;
  std::optional<double> overlap;     ///< m, in the steps that MeasureOptions::overlap_every asks for
  std::vector<ChannelRow> channels;  ///< those of the log, by ascending names
  StateMeasures state;
};

/// A row with its lengths in the unit of the session's table.
SeriesRow in_unit_of(const EngineAxes& axes, SeriesRow row);

/// Measures a session step by step.
class Measurer {
 public:
  explicit Measurer(const LogHeader& header, const MeasureOptions& options = {});

  /// Takes the record of the first state, then those of the steps that follow, in order. From MeasureOptions::from_step
  /// on, each record needs states.
  void add(const StepRecord& record);

  /// Whether MeasureOptions::from_step has been reached.
  [[nodiscard]] bool started() const { return meter_.has_value(); }

  /// The row of the step added last. Requires started().
  [[nodiscard]] const SeriesRow& row() const;

  /// Call after the last step; `last` is its states. Errors (kBadInput): from_step was not reached; the choice of
  /// bodies holds none, so nothing was measured, or names bodies that the session does not have at any time.
  Result<Metrics> finish(const BodyStates& last);

 private:
  void start(const StepRecord& record);
  void apply_before_start(const sim::Command& input);
  void measure_state(const StepRecord& record);

  ChannelMeter channels_;
  BodyTable shapes_;     // told before the start
  sim::SceneDef scene_;  // as it was at the last step before the start
  MeasureOptions options_;
  ChoiceWatch watch_;
  std::optional<StateMeter> meter_;
  StateMeter::StartEnergy start_energy_;
  Metrics metrics_;
  SeriesRow row_;  // of the step added last
  SessionClock clock_;
  std::uint64_t records_ = 0;
  std::uint64_t begin_ = 0;           // the step whose state is the start
  double lowest_energy_ = 0;          // running minimum of the energy less the work of inputs, J
  std::optional<double> rest_since_;  // s
  std::size_t bodies_seen_ = 0;       // the most that a state showed of those chosen
};

}  // namespace tumble::replay
