#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"
#include "replay/log/log_writer.h"
#include "src/base/result.h"
#include "src/world/world.h"

/// The log of another engine: what it computes, written so that diff, measure, dump, render, check and bisect
/// understand it. docs/other_engines.md shows how; engine_log_c.h is the same for C.
namespace tumble::replay {

struct EngineDef {
  EngineName engine;
  /// Names for set_phase_hashes(), in the order in which the engine runs them. Empty: steps have no phase hashes.
  std::vector<std::string> phases = {};
};

/// What one body is after a step. SI units, z up, spin about world axes. Any double is kept to the bit, NaN too.
struct EngineState {
  sim::Vec3 position = {0, 0, 0};
  sim::Quat orientation;
  sim::Vec3 velocity = {0, 0, 0};
  sim::Vec3 spin = {0, 0, 0};
  bool frozen = false;  ///< the engine lets it sleep
};

/// Writes the log of another engine, step by step:
///
///     auto log = EngineLog::create("session.tumble", {{"my engine", "1.2"}}, start);
///     for each step: input() for what was done to the bodies before it, set_state() for what they became, end_step()
///     finish()
///
/// Every body that is neither static nor frozen must be given its state in every step, so that none is forgotten in
/// silence; the others keep theirs until it is given. All states are kept. After an error the log is not to be used on;
/// what was written before it can be read. Not to be called from two threads at once.
class EngineLog {
 public:
  /// Begins a log. `start` is state 0, taken to the bit: its boxes (ascending id, see sim::BoxDef), dt, gravity,
  /// whether there is a ground; steps is how many are planned, 0 if nobody knows. The rest of it is look. Errors
  /// (kBadInput): a body or a value beyond src/model/limits.h, a name that is missing, a file that is no log already.
  static Result<std::unique_ptr<EngineLog>> create(const std::string& path, const EngineDef& def,
                                                   const sim::SceneDef& start);
  static Result<std::unique_ptr<EngineLog>> create(std::unique_ptr<ByteSink> sink, const EngineDef& def,
                                                   const sim::SceneDef& start);

  /// Something done to the bodies before the coming step; of a step, inputs come before states. Errors (kBadInput): an
  /// unknown or taken id, a value beyond the limits.
  Status input(const sim::Command& command);

  /// Errors (kBadInput): no such body.
  Status set_state(sim::BodyId id, const EngineState& state);

  /// Hashes of what each phase of the step wrote: as many words as there are phases, or that for each sub-step in turn.
  /// Errors (kBadInput): another count, or more than the log has room for.
  Status set_phase_hashes(std::span<const std::uint64_t> words);

  /// Ends the step and writes it. Errors: a body without a state, a dt beyond the limits (kBadInput); writing.
  Status end_step(double dt_s);

  /// Completes the log. Errors: inputs or states of a step that was not ended (kBadInput); writing.
  Result<LogSummary> finish();

  /// The step that is being told of: 1 before the first end_step().
  [[nodiscard]] std::uint64_t step() const { return world_.state().step + 1; }

  /// The bodies as they were told last, ascending by id.
  [[nodiscard]] const sim::Bodies& bodies() const { return world_.bodies(); }

 private:
  EngineLog(sim::World world, std::size_t phase_count) : world_(std::move(world)), phase_count_(phase_count) {}
  [[nodiscard]] Error at_step(const std::string& message) const;
  Status check_all_told() const;

  sim::World world_;  // what inputs mean for the bodies that exist; it never steps
  std::size_t phase_count_;
  std::unique_ptr<LogWriter> writer_;
  std::vector<sim::Command> inputs_;        // before the step that is being told of
  std::vector<std::uint64_t> phase_words_;  // of it
  std::vector<std::uint8_t> told_;          // a flag a row: its state was given; empty before the first
};

}  // namespace tumble::replay
