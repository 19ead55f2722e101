#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tumble/replay/byte_io.h"
#include "tumble/replay/extras.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/world.h"

/// Writes the session of another physics engine as a log that diff, measure, dump, render, check and bisect read.
/// docs/other_engines.md has a tutorial. engine_log_c.h is the interface for C.
namespace tumble::replay {

class KnownBodies;
class StepValues;

/// The state of one body after a step. SI units, z up, angular velocity about world axes. Every double is kept to the
/// bit, NaN included. An orientation that is finite and no rotation is refused: its length must be within kLengthOffMax
/// of 1.
struct EngineState {
  static constexpr double kLengthOffMax = 1e-2;
  sim::Vec3 position = {0, 0, 0};
  sim::Quat orientation;
  sim::Vec3 velocity = {0, 0, 0};
  sim::Vec3 spin = {0, 0, 0};
  bool frozen = false;  ///< the engine has put the body to sleep
};

struct EngineDef {
  EngineName engine;
  /// Names of the phases for set_phase_hashes(), in the order in which they run, each once. Empty: steps have no phase
  /// hashes.
  std::vector<std::string> phases = {};
  std::optional<ImportedTable> table = {};  ///< of an import; states are given in SI units, z up, all the same
  /// Channels by ascending names, shapes, names of the bodies of the start, values of state 0.
  Declared declared = {};
  /// States of the start that no scene can hold, to the bit: of bodies of the start, whose boxes have others.
  std::vector<std::pair<sim::BodyId, EngineState>> start_states = {};
  /// The number of the state that the log begins with; above 0 if the steps before it were not kept.
  std::uint64_t first_state = 0;
};

/// Writes the log of another engine, step by step.
///
///     auto log = EngineLog::create("session.tumble", {{"my engine", "1.2"}}, start);
///     for each step: input() for what was done to the bodies before it, set_state() for what they became, end_step()
///     finish()
///
/// Give every moving body a state in every step: a body that is neither static nor frozen and has no state is an error.
/// Static and frozen bodies keep their last state. The log holds the states of all steps. After an error, make no
/// further call but drop_step() and finish(); the steps written before can be read. Not for use by two threads at once.
class EngineLog {
 public:
  ~EngineLog();

  /// Creates the log. start: state 0, kept to the bit. Its boxes (ascending id, see sim::BoxDef), dt, gravity and
  /// ground count; `steps` is the planned number of steps, 0 if unknown; the rest is look. Errors (kBadInput): a body
  /// or a value beyond src/model/limits.h, an orientation that is no rotation, a missing name, two phases of one name,
  /// a table that no log can keep, an existing file that is no log.
  static Result<std::unique_ptr<EngineLog>> create(const std::string& path, const EngineDef& def,
                                                   const sim::SceneDef& start);
  static Result<std::unique_ptr<EngineLog>> create(std::unique_ptr<ByteSink> sink, const EngineDef& def,
                                                   const sim::SceneDef& start);

  /// make_sink is called once the start is known to be sound: an error of it costs no older file.
  using MakeSink = std::function<Result<std::unique_ptr<ByteSink>>()>;
  static Result<std::unique_ptr<EngineLog>> create(const MakeSink& make_sink, const EngineDef& def,
                                                   const sim::SceneDef& start);

  /// Records an input that changes the bodies before the coming step. Inputs of a step come before its states. A push,
  /// a velocity and a wake wake their body; gravity wakes nobody, for the engine decides what sleeps. A push or a
  /// velocity of a static body, or past the speeds of a world, is kept: the states tell what it did. Errors
  /// (kBadInput): an unknown or taken id, the id of a removed body for one of another size, mass or material, a value
  /// beyond the limits, an input after a state.
  Status input(const sim::Command& command);

  /// Sets the state of a body after the coming step. Errors (kBadInput): no body has this id; no
  /// rotation; a second state of the body in one step.
  Status set_state(sim::BodyId id, const EngineState& state);

  /// Sets a value of a channel after the coming step: of a body `a`, of a pair, or of the step as a whole. channel: an
  /// index into Declared::channels. May come before or after inputs and states. Errors (kBadInput): no such channel; a
  /// value of another kind than the channel's; bodies that do not fit its scope; a value that the step has.
  Status set_value(std::size_t channel, const ChannelValue& value, const ChannelKey& key = {});

  /// Sets all values of the step at once. Errors (kBadInput): values of other channels than the log's.
  Status set_values(StepValues& values);

  /// Adds a contact point, a note, a snapshot of the engine's own state or another record of the coming step. Errors
  /// (kBadInput): a body without an id, a text or a snapshot beyond limits.h.
  Status add_contact(const EngineContact& contact);
  Status add_note(std::string_view text);
  Status add_snapshot(std::span<const std::byte> bytes, std::string_view name = {});
  Status add_superseded(const Superseded& before);

  /// Names a body that appears in the coming step, and gives it a shape. A shape that is neither declared nor given
  /// before goes to `shape`; BodyInfo::shape must be its hash, or zero. Errors (kBadInput): as check_body_info(),
  /// check_shape(); a hash of no shape; another name or shape than the body of this id had before.
  Status describe_body(const BodyInfo& info, const Shape* shape = nullptr);

  /// Sets the phase hashes of the coming step: one word per phase, or one row of such words per substep. Errors
  /// (kBadInput): another number of words, more than PhaseHashes::kRowsMax rows, a log without phases.
  Status set_phase_hashes(std::span<const std::uint64_t> words);

  /// Ends the step and writes it. Errors. kBadInput: a moving body without a state, a dt beyond the limits, phase
  /// hashes missing, a value or a contact of a body that neither exists nor was removed before this step (of a value's
  /// pair, the first).
  /// kCannotFinish: writing fails.
  Status end_step(double dt_s);

  /// Drops what was told of the open step, where an error ends the session. Only finish() may follow: the world keeps
  /// the step's inputs and states.
  void drop_step();

  /// Completes the log. Where a call was refused before, the header of a log that was created by its path keeps that
  /// as the reason why the session may have had more steps (Declared::cut_short); else it keeps `why`, if that is not
  /// empty. Errors. kBadInput: inputs or states without end_step(), a second call. kCannotFinish: writing fails, or the
  /// complete log cannot keep the reason.
  Result<LogSummary> finish(const std::string& why = {});

  /// After finish(), whether it succeeded or not.
  [[nodiscard]] bool is_finished() const { return writer_ == nullptr; }

  /// The number of the coming step: 1 before the first end_step().
  [[nodiscard]] std::uint64_t step() const { return world_.state().step + 1; }

  /// The bodies with their last states, ascending by id.
  [[nodiscard]] const sim::Bodies& bodies() const { return world_.bodies(); }

 private:
  EngineLog(sim::World world, const EngineDef& def);
  void close_extras();
  [[nodiscard]] Error at_step(const std::string& message);
  Status check_all_told();

  sim::World world_;     // applies the inputs; takes no steps
  std::string path_;     // empty: the log goes elsewhere than to a file
  std::string refusal_;  // of the first call that was refused
  std::size_t phase_count_;
  std::unique_ptr<LogWriter> writer_;
  std::vector<sim::Command> inputs_;        // of the coming step
  std::vector<std::uint64_t> phase_words_;  // of the coming step
  std::unique_ptr<StepValues> values_;      // of the coming step
  std::unique_ptr<KnownBodies> known_;
  std::set<std::pair<std::uint64_t, std::uint64_t>> shapes_;  // hashes of those that the log holds
  Extras extras_;                                             // of the coming step, but the values
  std::vector<std::uint8_t> told_;  // one flag per row: the state was set; empty before the first
};

}  // namespace tumble::replay
