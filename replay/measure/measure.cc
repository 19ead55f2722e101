#include "replay/measure/measure.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "replay/format/not_finite.h"
#include "src/base/check.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

/// The energies of the whole world, to which a lost body belongs.
void spoil(EnergyMetrics& energy) {
  for (double* value : {&energy.initial, &energy.final, &energy.gain_max, &energy.inputs}) *value = kNotANumber;
  energy.gain_ratio = energy.removed = kNotANumber;
}

}  // namespace

SeriesRow in_unit_of(const EngineAxes& axes, SeriesRow row) {
  StateMeasures& state = row.state;
  for (double* length : {&state.lateral_max, &state.lateral_rms, &state.drift_max, &state.top_drop_max,
                         &state.ground_penetration_max, &state.height_max, &state.height_min, &state.height_mean}) {
    *length = axes.their_metres(*length);
  }
  for (std::optional<double>* length : {&state.column_spread, &row.overlap}) {
    if (*length) *length = axes.their_metres(**length);
  }
  return row;
}

Measurer::Measurer(const LogHeader& header, const MeasureOptions& options)
    : channels_(header.declared.channels), scene_(header.scene), options_(options), watch_(options.bodies) {
  for (const sim::BoxDef& box : scene_.boxes) watch_.add(box);
  shapes_.add(header.declared.bodies, header.declared.shapes);
  if (!header.engine) row_.removed = 0;  // no recorder of another engine tells what it dissipates
}

void Measurer::add(const StepRecord& record) {
  if (meter_) meter_->describe(record.extras);
  if (!meter_) shapes_.add(record.extras.bodies, record.extras.shapes);
  for (const sim::Command& input : record.inputs) {
    if (const auto* thrown = std::get_if<sim::Throw>(&input)) watch_.add(thrown->box);
    if (meter_) meter_->apply(input);
    if (!meter_) apply_before_start(input);
    if (meter_ && std::holds_alternative<sim::Throw>(input)) ++metrics_.bodies;
  }
  if (records_++ > 0) clock_.add_step(record.dt);  // the first record is a state, not a step
  SIM_CHECK(records_ == 1 || record.step > metrics_.steps, record.step, metrics_.steps);
  metrics_.steps = record.step;
  metrics_.final_hash = record.state_hash;
  if (!meter_) {
    if (record.step >= options_.from_step) start(record);
    return;
  }
  row_.step = record.step;
  row_.time = clock_.now();
  row_.kinetic = meter_->kinetic_by_shapes(record.states).value_or(record.counters.kinetic);
  row_.potential = record.counters.potential;
  row_.inputs += record.counters.inputs;
  if (row_.removed) *row_.removed += record.counters.removed;
  // Energy put in by inputs is no gain of the solver's, so it is subtracted before the minimum is taken. The minimum
  // runs along with the session: a gain after a loss counts, even if the total stays below that of the start.
  const double own = row_.kinetic + row_.potential - row_.inputs;
  lowest_energy_ = least(lowest_energy_, own);
  row_.gain = own - lowest_energy_;
  metrics_.energy.gain_max = largest(metrics_.energy.gain_max, row_.gain);
  measure_state(record);
}

// Keeps the scene current until measuring starts: its bodies and its gravity.
void Measurer::apply_before_start(const sim::Command& input) {
  if (const auto* thrown = std::get_if<sim::Throw>(&input)) scene_.boxes.push_back(thrown->box);
  if (const auto* gravity = std::get_if<sim::SetGravity>(&input)) scene_.world.gravity = gravity->gravity;
}

const SeriesRow& Measurer::row() const {
  SIM_CHECK(started());
  return row_;
}

void Measurer::start(const StepRecord& record) {
  // Of a body that was removed and came back the last box counts.
  std::ranges::reverse(scene_.boxes);
  std::ranges::stable_sort(scene_.boxes, {}, &sim::BoxDef::id);
  const auto same_id = [](const sim::BoxDef& a, const sim::BoxDef& b) { return a.id == b.id; };
  scene_.boxes.erase(std::unique(scene_.boxes.begin(), scene_.boxes.end(), same_id), scene_.boxes.end());
  meter_.emplace(scene_, record.states, options_, shapes_);
  if (!row_.removed) meter_->take_told_speeds();  // another engine's, whose motors and controls are no inputs
  start_energy_ = meter_->start_energy();
  lowest_energy_ = start_energy_.total();
  metrics_.bodies = record.states.size();
  begin_ = record.step;
  metrics_.energy.initial = start_energy_.total();
  row_.step = record.step;
  row_.time = clock_.now();
  row_.kinetic = start_energy_.kinetic;
  row_.potential = start_energy_.potential;
  measure_state(record);
}

void Measurer::measure_state(const StepRecord& record) {
  row_.state = meter_->measure(record.states, record.step, row_.step == begin_ ? 0 : record.dt);
  channels_.add(record.extras);
  row_.channels = channels_.row();
  row_.lost = meter_->lost();
  bodies_seen_ = std::max(bodies_seen_, row_.state.bodies);
  row_.overlap.reset();
  if (options_.overlap_every != 0 && record.step % options_.overlap_every == 0) {
    row_.overlap = meter_->overlap_max(record.states);
  }
  StackingMetrics& stacking = metrics_.stacking;
  stacking.overlap_peak = largest(stacking.overlap_peak, row_.overlap.value_or(0));
  stacking.ground_penetration_peak = largest(stacking.ground_penetration_peak, row_.state.ground_penetration_max);
  if (!row_.state.at_rest) {
    rest_since_.reset();
  } else if (!rest_since_) {
    rest_since_ = row_.time;
  }
}

Result<Metrics> Measurer::finish(const BodyStates& last) {
  if (!meter_) {
    return bad_input("found no step " + std::to_string(options_.from_step) +
                     " to measure from, the session ends with " + std::to_string(metrics_.steps));
  }
  if (bodies_seen_ == 0 && !options_.bodies.all()) {
    return bad_input("bodies: found none of \"" + to_string(options_.bodies) +
                     "\" that is not static, wanted some to measure");
  }
  if (const std::vector<std::string> missing = watch_.missing(); !missing.empty()) {
    return bad_input("bodies: found no " + joined(missing, ", no ") + " in the session up to step " +
                     std::to_string(metrics_.steps) + ", wanted bodies that it has");
  }
  metrics_.measured_steps = metrics_.steps - begin_;
  metrics_.measured_bodies = bodies_seen_;
  const StateMeasures& end = row_.state;
  metrics_.bodies_at_end = end.bodies;
  metrics_.of_start_at_end = end.of_start;
  SymmetryMetrics& symmetry = metrics_.symmetry;
  symmetry.lateral_max = end.lateral_max;
  symmetry.lateral_rms = end.lateral_rms;
  symmetry.column_spread = end.column_spread;
  const StateMeter::Keeping keeping = meter_->keeping();
  EnergyMetrics& energy = metrics_.energy;
  energy.final = row_.kinetic + row_.potential;
  energy.removed = row_.removed;
  energy.inputs = row_.inputs;
  energy.bounce_height_loss = keeping.bounce_height_loss;
  energy.bounces = keeping.bounces;
  energy.momentum_drift = keeping.momentum_drift;
  energy.spin_energy_gain = keeping.spin_energy_gain;
  if (energy.gain_max == 0) {
    energy.gain_ratio = 0;
  } else if (!(start_energy_.above_rest <= 0)) {
    energy.gain_ratio = energy.gain_max / start_energy_.above_rest;
  }
  StackingMetrics& stacking = metrics_.stacking;
  stacking.drift_max = end.drift_max;
  stacking.tilt_max = end.tilt_max;
  stacking.top_drop_max = end.top_drop_max;
  stacking.lost = row_.lost;
  stacking.overlap_max = meter_->overlap_max(last);
  stacking.overlap_peak = largest(stacking.overlap_peak, stacking.overlap_max);
  stacking.ground_penetration_max = end.ground_penetration_max;
  stacking.kinetic_linear_end = end.kinetic_linear;
  stacking.kinetic_rotational_end = end.kinetic_rotational;
  stacking.frozen_fraction = end.frozen_fraction;
  stacking.rest_time = rest_since_;
  metrics_.channels = channels_.metrics();
  metrics_.first_lost = meter_->first_lost();
  metrics_.not_finite = meter_->not_finite();
  metrics_.approximations = meter_->approximations();
  for (std::string& note : approximations(metrics_.channels)) metrics_.approximations.push_back(std::move(note));
  if (metrics_.not_finite.any) spoil(energy);
  return metrics_;
}

}  // namespace tumble::replay
