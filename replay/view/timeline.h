#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "replay/measure/measure_state.h"
#include "replay/session/state_source.h"
#include "replay/view/bound_scan.h"
#include "replay/view/viewed_bodies.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/player.h"

namespace tumble::replay {

/// One step of a session as a timeline shows it. Energies in J, of all bodies.
struct TimelineRow {
  std::uint64_t step = 0;
  double time = 0;    ///< s, since the first state
  bool read = false;  ///< false: the log does not hold the step, and the numbers below have no meaning
  double kinetic = 0;
  double potential = 0;
  double inputs = 0;  ///< put in by the inputs of this step
  std::uint32_t contacts = 0;
  std::uint32_t bodies = 0;
  std::uint32_t frozen = 0;
  std::uint32_t not_finite = 0;  ///< bodies with a value that is infinite or no number
  double speed_max = 0;          ///< m/s, of the bodies that are finite
  sim::BodyId speed_body = 0;    ///< that body; 0: none
  double height_max = 0;         ///< m, highest centre
  std::vector<double> channels;  ///< by index in channel_columns(), the largest of all bodies or pairs; NaN: no number
  std::vector<BoundState> bounds;  ///< of BoundScan; empty: not judged
  double overlap = 0;              ///< m, deepest of two boxes, as `measure` defines overlap_max; NaN after a lost body
};

/// The channels that a timeline shows: those of numbers, in listed_order(). Indices in LogHeader::declared.channels.
std::vector<std::size_t> channel_columns(const LogHeader& header);

/// An input with its step.
struct TimelineInput {
  std::uint64_t step = 0;
  sim::Command input;
};

/// Reads a session from its first state on, a step a call.
class TimelineScan {
 public:
  /// `log` must outlive this object and is read by nobody else meanwhile.
  explicit TimelineScan(LogReader& log, std::vector<ViewedBound> bounds = {});

  /// The step that next() takes.
  [[nodiscard]] std::uint64_t at() const { return next_; }
  [[nodiscard]] bool done() const { return next_ > log_->last_step(); }

  /// Requires !done(). A step that cannot be read gives a row that says so.
  TimelineRow next();

  /// The states of the row that next() returned last; null where it could not be read. Valid until the next call.
  [[nodiscard]] const BodyStates* states() const { return record_ == nullptr ? nullptr : &record_->states; }
  /// Likewise its record.
  [[nodiscard]] const StepRecord* record() const { return record_; }

  /// The reason why that row could not be read; empty where it was.
  [[nodiscard]] const std::string& why_not() const { return why_not_; }

  /// The inputs of that row's step.
  [[nodiscard]] std::vector<sim::Command> inputs() const;

  /// Continues in a longer version of the log, as a session that is being recorded has. `log` as in the constructor.
  void follow(LogReader& log);

 private:
  void measure(const StepRecord& record, TimelineRow& row);

  LogReader* log_;
  std::vector<std::size_t> channels_;
  std::optional<StateSource> source_;
  std::optional<StateMeter> meter_;
  std::optional<BoundScan> bounds_;  // none after a step that could not be read: what came before is not known
  const StepRecord* record_ = nullptr;
  std::string why_not_;
  std::uint64_t next_ = 0;
  double time_ = 0;
};

/// Counts the pairs that begin and cease to touch, by stepping a session of ours again.
class ContactScan {
 public:
  explicit ContactScan(LogReader& log) : log_(&log), taken_(log.first_state()) {}

  struct Row {
    std::uint64_t step = 0;
    std::uint32_t begun = 0;
    std::uint32_t ended = 0;
  };

  /// The next step after the log's first state. Errors: Player's; kCannotFinish where this build computes another
  /// state.
  Result<Row> next();
  [[nodiscard]] bool done() const { return taken_ >= log_->last_step(); }

  /// As TimelineScan::follow().
  void follow(LogReader& log);

 private:
  LogReader* log_;
  std::optional<Player> player_;  // after step taken_
  std::uint64_t taken_ = 0;
  std::vector<std::pair<sim::BodyId, sim::BodyId>> touching_;  // ascending; 0: the ground
};

}  // namespace tumble::replay
