#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "replay/log/session_clock.h"
#include "replay/session/state_source.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/result.h"

/// The time at which a session parts from another one: the metric parting_time.D, with a distance D in m.
namespace tumble::replay {

struct Parting {
  double beyond = 0;       ///< m
  bool parted = false;     ///< a body was further than that from its place in the other session
  double time = 0;         ///< s, the end of the first such step; the end of the shorter session where there is none
  std::uint64_t step = 0;  ///< that step
  sim::BodyId body = 0;    ///< the first body that is so far away; 0: none
};

/// The body whose places in two states are farthest apart.
struct Farthest {
  double distance = 0;   ///< m; infinite where only one state has the body, or a place is no number
  sim::BodyId body = 0;  ///< the first of them; 0: none is apart
};
Farthest farthest_apart(const BodyStates& a, const BodyStates& b);

/// The distance of "parting_time.0.01"; none where a text is no such name.
std::optional<double> parse_parting_metric(std::string_view name);

/// Compares the states of a session with those of another one, step by step, by the numbers of the steps. A body that
/// only one of the two has, or that has a position that is no number, is further away than any distance.
class PartingMeter {
 public:
  /// other: outlives this, and is read by nobody else meanwhile. beyond: m, above 0.
  PartingMeter(LogReader& other, const std::vector<double>& beyond);

  /// The first state of the session, then every step in order, with states. Errors: a step of the other session that
  /// cannot be read; the other session does not have the first state.
  Status add(const StepRecord& record);

  [[nodiscard]] const std::vector<Parting>& partings() const { return partings_; }

 private:
  LogReader& other_;
  std::unique_ptr<StateSource> source_;
  std::vector<Parting> partings_;
  SessionClock clock_;
  bool first_ = true;
};

/// Over all steps of a log. Errors: StateSource::read's, PartingMeter::add's; kCannotFinish where `progress` stops.
Result<std::vector<Parting>> measure_partings(LogReader& log, LogReader& other, const std::vector<double>& beyond,
                                              const Progress& progress = {});

}  // namespace tumble::replay
