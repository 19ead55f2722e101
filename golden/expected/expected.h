#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/golden/expected_extras.h"
#include "tumble/golden/expected_setup.h"
#include "tumble/golden/provenance.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"

/// The golden of a session as plain data: hashes of all steps, some states, a coarse track.
namespace tumble::golden {

/// A hash of each body's visible state at a step: tells which bodies differ.
struct BodyHashes {
  std::uint64_t step = 0;
  std::vector<sim::BodyId> id;      ///< ascending
  std::vector<std::uint32_t> hash;  ///< low half of XXH3-128's low word
  friend bool operator==(const BodyHashes&, const BodyHashes&) = default;
};

struct KeyState {
  std::uint64_t step = 0;
  replay::BodyStates states;
  friend bool operator==(const KeyState&, const KeyState&) = default;
};

/// Positions to the millimetre, for reports; no verdict depends on them.
struct TrackPoint {
  std::uint64_t step = 0;
  std::vector<sim::BodyId> id;
  std::vector<std::int32_t> x, y, z;  ///< mm
  friend bool operator==(const TrackPoint&, const TrackPoint&) = default;
};

enum class PhaseDetail : std::uint8_t { kNone = 0, kStep = 1, kSubstep = 2 };

struct Expected {
  std::string method;
  std::uint32_t method_version = 0;
  Hash128 scene;                          ///< scene_hash()
  std::vector<Hash128> state_hashes;      ///< of states 0 … N
  std::vector<std::uint32_t> step_words;  ///< of steps 1 … N: step_word()
  std::vector<std::string> phases;        ///< names of the phase words
  PhaseDetail phase_detail = PhaseDetail::kSubstep;
  std::uint32_t phase_hash_version = 1;  ///< LogHeader::phase_hash_version: the meaning of phase and step words
  std::vector<std::vector<std::uint16_t>> phase_words;  ///< of steps 1 … N: phase_words_of()
  Hash128 continuation;                  ///< of state N, hidden parts included; zero where it was not known
  std::vector<BodyHashes> body_hashes;   ///< ascending step
  std::vector<KeyState> states;          ///< ascending step
  std::vector<TrackPoint> track;         ///< ascending step
  std::optional<ExpectedExtras> extras;  ///< channels and contacts; none: blessed before goldens kept them
  /// Of bodies of another engine; none: of Tumble, or blessed before goldens kept them.
  std::optional<std::vector<BodyShape>> shapes;
  std::optional<ExpectedSetup> setup;  ///< likewise
  std::string scene_text;              ///< scene.toml when it was blessed; empty: not kept
  Provenance provenance;               ///< of the run that was blessed; an old golden has a version alone

  [[nodiscard]] std::uint64_t steps() const { return state_hashes.empty() ? 0 : state_hashes.size() - 1; }
  friend bool operator==(const Expected&, const Expected&) = default;
};

/// A step without its states (dt, inputs, phase words, state hash, counters) in 32 bits. with_extras: also the channels
/// and contacts, as in goldens that do not keep them.
std::uint32_t step_word(const replay::StepRecord& record, bool with_extras);

/// The phase words of a step as a golden keeps them: 16 bits of each, at kStep the substeps folded into one row.
/// phase_count: words in a row.
std::vector<std::uint16_t> phase_words_of(const replay::StepRecord& record, std::size_t phase_count,
                                          PhaseDetail detail);

/// Makes a golden smaller. Precondition: its detail is PhaseDetail::kSubstep.
void reduce_phase_words(Expected& expected, PhaseDetail detail);

/// A hash of each body's visible state.
BodyHashes hash_bodies(std::uint64_t step, const replay::BodyStates& states);

/// Steps for which a golden keeps more than a hash, ascending, 0 and the last included.
struct Milestones {
  std::vector<std::uint64_t> states;  ///< full states; empty if one state is too large for a golden
  std::vector<std::uint64_t> body_hashes;
  std::vector<std::uint64_t> track;
};
Milestones choose_milestones(std::uint64_t steps, std::size_t bodies);

/// Collects a golden from a session: state 0, then every step in order, all with states.
class ExpectedBuilder {
 public:
  ExpectedBuilder(const replay::LogHeader& header, std::uint64_t steps, const Hash128& scene);

  void add(const replay::StepRecord& record);

  /// After the last step. continuation: zero where it is not known.
  Expected finish(const Hash128& continuation);

 private:
  Expected expected_;
  Milestones milestones_;
  ExtrasKeeper extras_;
  ShapesKeeper shapes_;
  SetupKeeper setup_;
};

}  // namespace tumble::golden
