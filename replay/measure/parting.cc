#include "replay/measure/parting.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "tumble/replay/body_states.h"
#include "tumble/sim/vec.h"

namespace tumble::replay {
// Walks both states by ascending id.
Farthest farthest_apart(const BodyStates& a, const BodyStates& b) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Farthest found;
  const auto take = [&](sim::BodyId body, double distance) {
    const double known = std::isnan(distance) ? kFar : distance;
    if (known > found.distance) found = {known, body};
  };
  std::size_t i = 0, j = 0;
  while (i < a.size() || j < b.size()) {
    if (i < a.size() && j < b.size() && a.id[i] == b.id[j]) {
      take(a.id[i], sim::length(a.position[i] - b.position[j]));
      ++i;
      ++j;
    } else if (j == b.size() || (i < a.size() && a.id[i] < b.id[j])) {
      take(a.id[i++], kFar);
    } else {
      take(b.id[j++], kFar);
    }
  }
  return found;
}

std::optional<double> parse_parting_metric(std::string_view name) {
  constexpr std::string_view kPrefix = "parting_time.";
  if (!name.starts_with(kPrefix)) return std::nullopt;
  name.remove_prefix(kPrefix.size());
  double beyond = 0;
  const char* end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data(), end, beyond);
  const bool right = error == std::errc() && stop == end && std::isfinite(beyond) && beyond > 0;
  return right ? std::optional<double>(beyond) : std::nullopt;
}

PartingMeter::PartingMeter(LogReader& other, const std::vector<double>& beyond)
    : other_(other), source_(std::make_unique<StateSource>(other)) {
  for (const double distance : beyond) {
    partings_.emplace_back();
    partings_.back().beyond = distance;
  }
}

Status PartingMeter::add(const StepRecord& record) {
  if (!first_) clock_.add_step(record.dt);
  first_ = false;
  if (record.step > other_.last_step()) return {};
  if (record.step < other_.first_state()) {
    return bad_input(other_.name() + ": begins with the state of step " + std::to_string(other_.first_state()) +
                     ", wanted that of step " + std::to_string(record.step) + " too, to compare the session with");
  }
  const Result<const StepRecord*> other = source_->read(record.step);
  if (!other.ok()) return other.error();
  const Farthest found = farthest_apart((*other)->states, record.states);
  for (Parting& parting : partings_) {
    if (parting.parted) continue;
    parting.parted = found.distance > parting.beyond;
    parting.time = clock_.now();
    parting.step = record.step;
    if (parting.parted) parting.body = found.body;
  }
  return {};
}

Result<std::vector<Parting>> measure_partings(LogReader& log, LogReader& other, const std::vector<double>& beyond,
                                              const Progress& progress) {
  StateSource source(log);
  PartingMeter meter(other, beyond);
  for (std::uint64_t k = log.first_state(); k <= log.last_step(); ++k) {
    const Result<const StepRecord*> record = source.read(k);
    if (!record.ok()) return record.error();
    if (Status ok = meter.add(**record); !ok.ok()) return ok.error();
    if (progress && !progress(k - log.first_state(), log.step_count())) return cannot_finish("interrupted");
  }
  return meter.partings();
}

}  // namespace tumble::replay
