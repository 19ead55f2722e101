#include "replay/measure.h"

#include <algorithm>
#include <variant>

namespace tumble::replay {

Measurer::Measurer(const LogHeader& header, const StepRecord& start)
    : meter_(header.scene, start.states), start_energy_(meter_.start_energy()), lowest_energy_(start_energy_.total()) {
  metrics_.bodies = start.states.size();
  metrics_.energy.initial = start_energy_.total();
  metrics_.final_hash = start.state_hash;
  row_.kinetic = start_energy_.kinetic;
  row_.potential = start_energy_.potential;
  look_at(start.states);
}

void Measurer::add(const StepRecord& record) {
  for (const sim::Command& input : record.inputs) {
    const auto* thrown = std::get_if<sim::Throw>(&input);
    if (thrown == nullptr) continue;
    meter_.add_thrown(thrown->box);
    ++metrics_.bodies;
  }
  clock_.add_step(record.dt);

  row_.step = record.step;
  row_.time = clock_.now();
  row_.kinetic = record.counters.kinetic;
  row_.potential = record.counters.potential;
  row_.inputs += record.counters.inputs;
  row_.removed += record.counters.removed;
  const double own = row_.kinetic + row_.potential - row_.inputs;
  lowest_energy_ = std::min(lowest_energy_, own);
  row_.gain = own - lowest_energy_;
  look_at(record.states);

  metrics_.steps = record.step;
  metrics_.final_hash = record.state_hash;
  metrics_.energy.gain_max = std::max(metrics_.energy.gain_max, row_.gain);
}

void Measurer::look_at(const BodyStates& states) {
  row_.state = meter_.measure(states);
  row_.lost = meter_.lost();
  if (!row_.state.at_rest) {
    rest_since_.reset();
  } else if (!rest_since_) {
    rest_since_ = row_.time;
  }
}

Metrics Measurer::finish(const BodyStates& last) {
  const StateMeasures& end = row_.state;
  metrics_.symmetry = {end.lateral_max, end.lateral_rms, end.column_spread};
  EnergyMetrics& energy = metrics_.energy;
  energy.final = row_.kinetic + row_.potential;
  energy.removed = row_.removed;
  energy.inputs = row_.inputs;
  if (energy.gain_max == 0) {
    energy.gain_ratio = 0;
  } else if (start_energy_.above_rest > 0) {
    energy.gain_ratio = energy.gain_max / start_energy_.above_rest;
  }
  metrics_.stacking = {.drift_max = end.drift_max,
                       .tilt_max = end.tilt_max,
                       .top_drop_max = end.top_drop_max,
                       .lost = row_.lost,
                       .overlap_max = meter_.overlap_max(last),
                       .ground_penetration_max = end.ground_penetration_max,
                       .kinetic_end = row_.kinetic,
                       .frozen_fraction = end.frozen_fraction,
                       .rest_time = rest_since_};
  return metrics_;
}

}  // namespace tumble::replay
