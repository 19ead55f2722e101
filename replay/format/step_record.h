#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/format/body_states.h"
#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/model/scene.h"
#include "src/model/transform.h"
#include "src/step/step.h"

/// What a log holds, as plain data.
namespace tumble::replay {

/// One step of a session: it took state step − 1 to state `step`.
struct StepRecord {
  std::uint64_t step = 0;                  ///< 1 … N; 0 only for state 0, which has neither inputs nor counters
  double dt = 0;                           ///< s, of this step
  std::vector<sim::Command> inputs;        ///< applied before it, in this order
  std::vector<std::uint64_t> phase_words;  ///< sub-step rows × phases (LogHeader::phases), as sim::PhaseHashes has them
  Hash128 state_hash;                      ///< after it
  sim::StepCounters counters;
  bool has_states = false;  ///< a log may hold them for some steps only
  BodyStates states;        ///< after it; empty without has_states
};

/// Which steps' states a log holds in full.
struct StatesMode {
  std::uint32_t every = 1;  ///< 1: all; n: steps that n divides; 0: none, only keyframes and hashes
  [[nodiscard]] bool holds(std::uint64_t step) const { return every != 0 && step % every == 0; }
  friend bool operator==(const StatesMode&, const StatesMode&) = default;
};

/// "all", "every:N" (N >= 1) or "hashes", as the command line says it.
Result<StatesMode> parse_states_mode(const std::string& text);
std::string to_string(const StatesMode& mode);

/// Where a session that goes on from another one's state began.
struct GoesOn {
  std::uint64_t step = 0;     ///< of the other session's state; this one's first step is the next
  std::string log;            ///< the other log, as it was given
  Hash128 continuation_hash;  ///< of that state
  Hash128 chain;              ///< of the other session, after that step
  friend bool operator==(const GoesOn&, const GoesOn&) = default;
};

/// Another engine, whose steps a log holds (engine_log.h).
inline constexpr std::uint32_t kBinary32Bits = 24;
inline constexpr std::uint32_t kBinary64Bits = 53;
struct EngineName {
  std::string name;                              ///< never empty
  std::string version;                           ///< may be empty
  std::uint32_t precision_bits = kBinary64Bits;  ///< of its numbers: 24 (binary32) or 53 (binary64)
  friend bool operator==(const EngineName&, const EngineName&) = default;
};

/// "Bullet 3.24".
std::string to_string(const EngineName& engine);

/// Steps that a recovered log lacks between others.
struct Gap {
  std::uint64_t first_step = 0;
  std::uint64_t step_count = 0;
  [[nodiscard]] std::uint64_t end_step() const { return first_step + step_count; }  ///< the first that is there again
  friend bool operator==(const Gap&, const Gap&) = default;
};

/// "step 7", "steps 7 to 12".
std::string to_string(const Gap& gap);

/// The step that comes after those before `end`: `end` itself, or the first one after a gap that begins there.
std::uint64_t step_after(std::uint64_t end, const std::vector<Gap>& gaps);

/// What a log lacks since it was recovered from a damaged one.
struct Recovered {
  std::string log;           ///< the damaged log, as it was given
  bool header_lost = false;  ///< the header was made from the first keyframe: no names, looks, camera, scene text
  std::vector<Gap> gaps;     ///< ascending; chunks stand before and after each
  friend bool operator==(const Recovered&, const Recovered&) = default;
};

/// What a log says of itself once, at its start.
struct LogHeader {
  std::uint16_t format_major = 0;  ///< of the file; the writer fills both in
  std::uint16_t format_minor = 0;
  std::string tool_version;  ///< of the program that wrote it
  std::string tool_build;    ///< compiler and its version
  std::string method;        ///< "thesis" or "layered"
  std::uint32_t method_version = 0;
  std::string float_format = "binary64, little-endian";
  std::vector<std::string> phases;       ///< names, in the order they run
  std::uint32_t phase_rows_max = 0;      ///< sim::PhaseHashes::kRowsMax of the writer
  std::uint32_t phase_hash_version = 1;  ///< sim::PhaseHashes::kVersion of the writer; 1 for another engine's
  sim::SceneDef scene;                   ///< resolved; of a session that goes on: as it was then
  std::string scene_text;                ///< the TOML file as it was, empty if none
  std::vector<std::string> overrides;    ///< "world.dt=0.01", in order
  sim::Transform transform;              ///< done to the scene of the text; `scene` has it done already
  std::optional<GoesOn> goes_on;         ///< none: the log begins with state 0
  std::optional<EngineName> engine;      ///< none: this project's physics computed the steps
  std::optional<Recovered> recovered;    ///< none: the log is as it was recorded
  StatesMode states;
  std::uint32_t chunk_steps_max = 0;
  std::uint64_t chunk_bytes_max = 0;

  [[nodiscard]] const std::vector<Gap>& gaps() const;  ///< steps that the log lacks between others
};

/// The header of a session that this build records: everything but the scene text and the overrides.
LogHeader header_for(const sim::SceneDef& scene);

/// Whether the phase words of two sessions can be compared: those of the same phases, whose hashes cover the same.
bool same_phase_words(const LogHeader& a, const LogHeader& b);

/// Gives `record` the phase words of `of`, and its count of contacts, for a comparison of the rest: two sessions whose
/// words mean different things may count differently too.
void leave_out_phase_words(const StepRecord& of, StepRecord& record);

/// "phase hashes: …", for people: why the words of two sessions of the same phases were not compared. Empty if they
/// were.
std::string phase_hash_note(const LogHeader& a, const LogHeader& b);

/// The scene format's word for a method.
const char* name_of(sim::Method method);

}  // namespace tumble::replay
