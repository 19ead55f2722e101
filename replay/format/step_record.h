#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tumble/replay/body_states.h"
#include "tumble/replay/extras.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/step.h"
#include "tumble/sim/transform.h"

/// The content of a log, as plain data.
namespace tumble::replay {

/// One step of a session, from state step − 1 to state `step`.
struct StepRecord {
  std::uint64_t step = 0;                  ///< 1 … N; 0 only for state 0, which has no inputs and no counters
  double dt = 0;                           ///< s, of this step
  std::vector<sim::Command> inputs;        ///< applied before the step, in this order
  std::vector<std::uint64_t> phase_words;  ///< substep rows × phases (LogHeader::phases), as in sim::PhaseHashes
  Hash128 state_hash;                      ///< after the step
  sim::StepCounters counters;
  bool has_states = false;  ///< false for steps whose states the log leaves out
  BodyStates states;        ///< after the step; empty without has_states
  Extras extras;            ///< of another engine's step, mostly; empty of ours, but for views
};

/// The steps whose states a log holds in full.
struct StatesMode {
  std::uint32_t every = 1;  ///< 1: all steps; n: multiples of n; 0: none, only keyframes and hashes
  [[nodiscard]] bool holds(std::uint64_t step) const { return every != 0 && step % every == 0; }
  friend bool operator==(const StatesMode&, const StatesMode&) = default;
};

/// Reads "all", "every:N" (N >= 1) or "hashes", the words of the command line. Errors (kBadInput): other text.
Result<StatesMode> parse_states_mode(const std::string& text);
std::string to_string(const StatesMode& mode);

/// The steps whose phase words a log holds. Every step has its state hash.
struct HashesMode {
  std::uint32_t every = 1;  ///< 1: all steps; n: multiples of n; 0: none
  [[nodiscard]] bool holds(std::uint64_t step) const { return every != 0 && step % every == 0; }
  friend bool operator==(const HashesMode&, const HashesMode&) = default;
};

/// Reads "all", "every:N" (N >= 1) or "states", the words of the command line. Errors (kBadInput): other text.
Result<HashesMode> parse_hashes_mode(const std::string& text);
std::string to_string(const HashesMode& mode);

/// The origin of a continued session: a state of another session.
struct GoesOn {
  std::uint64_t step = 0;     ///< of that state; the continued session begins with the step after
  std::string log;            ///< path of the other log, as the user gave it
  Hash128 continuation_hash;  ///< of that state
  Hash128 chain;              ///< of the other session, after that step
  friend bool operator==(const GoesOn&, const GoesOn&) = default;
};

/// Bits of the significand of a number.
inline constexpr std::uint32_t kBinary32Bits = 24;
inline constexpr std::uint32_t kBinary64Bits = 53;

/// The physics engine whose steps a log holds (engine_log.h).
struct EngineName {
  std::string name;                              ///< not empty
  std::string version;                           ///< empty if unknown
  std::uint32_t precision_bits = kBinary64Bits;  ///< of the engine's numbers: 24 (binary32) or 53 (binary64)
  friend bool operator==(const EngineName&, const EngineName&) = default;
};

/// "Bullet 3.24".
std::string to_string(const EngineName& engine);

/// A run of steps that a recovered log lacks between others.
struct MissingSteps {
  std::uint64_t first_step = 0;
  std::uint64_t step_count = 0;
  [[nodiscard]] std::uint64_t end_step() const { return first_step + step_count; }  ///< the first step behind the run
  friend bool operator==(const MissingSteps&, const MissingSteps&) = default;
};

/// "step 7", "steps 7 to 12".
std::string to_string(const MissingSteps& run);

/// The next step that the log holds from step `end` on: `end` itself, or the step behind the missing run that begins
/// there.
std::uint64_t step_after(std::uint64_t end, const std::vector<MissingSteps>& missing);

/// The losses of a log that was recovered from a damaged one.
struct Recovered {
  std::string log;  ///< path of the damaged log, as the user gave it
  /// The header was rebuilt from the first keyframe, without names, looks, camera and scene text.
  bool header_lost = false;
  std::vector<MissingSteps> missing;  ///< ascending; chunks stand before and after each run
  friend bool operator==(const Recovered&, const Recovered&) = default;
};

/// The header of a log: everything that holds for all its steps.
struct LogHeader {
  std::uint16_t format_major = 0;  ///< of the file; RecordWriter fills in both
  std::uint16_t format_minor = 0;
  std::string tool_version;  ///< of the program that wrote the log
  std::string tool_build;    ///< compiler and its version
  std::string method;        ///< "thesis" or "layered"
  std::uint32_t method_version = 0;
  std::string float_format = "binary64, little-endian";
  std::vector<std::string> phases;       ///< names, in the order in which the phases run
  std::uint32_t phase_rows_max = 0;      ///< sim::PhaseHashes::kRowsMax of the writer
  std::uint32_t phase_hash_version = 1;  ///< sim::PhaseHashes::kVersion of the writer; 1 in another engine's log
  sim::SceneDef scene;                   ///< resolved; of a continued session: at its first state
  std::string scene_text;                ///< the TOML file, byte for byte; empty without one
  std::vector<std::string> overrides;    ///< "world.dt=0.01", in order
  sim::Transform transform;              ///< applied to the scene of the text; `scene` is the result
  std::optional<GoesOn> goes_on;         ///< none: the log begins with state 0
  std::optional<EngineName> engine;      ///< none: the steps were computed by this project
  std::optional<ImportedTable> table;    ///< none: no table was imported, or it had our axes and no column too many
  Declared declared;                     ///< empty: the source of the steps declares nothing beyond states
  std::optional<Recovered> recovered;    ///< none: the log was not recovered
  StatesMode states;
  HashesMode hashes;
  std::uint32_t chunk_steps_max = 0;
  std::uint64_t chunk_bytes_max = 0;

  [[nodiscard]] EngineAxes axes() const { return table ? table->axes : EngineAxes{}; }  ///< of the session's source
  [[nodiscard]] const std::vector<MissingSteps>& missing() const;  ///< steps that the log lacks between others
};

/// Lines "# key: value" before a table, by which `import` reads what its columns do not show.
using TableSettings = std::vector<std::pair<std::string, std::string>>;
std::string setting_lines(const TableSettings& settings);

/// How many bits an engine's numbers have; none for ours and for doubles.
TableSettings precision_settings(const LogHeader& header);

/// The columns that were derived, "velocity spin"; empty: none.
std::string derived_columns(const Declared& declared);

/// The header of a session that this build records, without scene text and overrides.
LogHeader header_for(const sim::SceneDef& scene);

/// Whether the phase words of two sessions can be compared: both have the same phases, and the phase hashes cover the
/// same fields.
bool same_phase_words(const LogHeader& a, const LogHeader& b);

/// Likewise for one step: both sessions also hold the words of that step.
bool same_phase_words(const LogHeader& a, const LogHeader& b, std::uint64_t step);

/// Prepares a comparison of one step of sessions `a` and `b`: copies from `of` into `record` what cannot be compared.
/// These are the phase words unless same_phase_words() of the step, and the contact count where the words mean
/// different things, because such sessions may count contacts differently too.
void leave_out_phase_words(const LogHeader& a, const LogHeader& b, const StepRecord& of, StepRecord& record);

/// For people: the reason why phase words were not compared, "phase hashes: …". Empty where both sessions have the same
/// version of phase hashes.
std::string phase_hash_note(const LogHeader& a, const LogHeader& b);

}  // namespace tumble::replay
