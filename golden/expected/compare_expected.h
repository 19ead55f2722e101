#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tumble/golden/expected.h"
#include "tumble/replay/body_table.h"
#include "tumble/replay/step_record.h"

namespace tumble::golden {

/// The largest distance found between a body and its expected position.
struct Apart {
  double metres = 0;  ///< infinite where a position is not a number
  std::uint64_t step = 0;
  sim::BodyId body = 0;
  friend bool operator==(const Apart&, const Apart&) = default;
};

/// "2.4 m apart (body 71, step 300)", "not a number (body 71, step 300)".
std::string describe(const Apart& apart, const replay::BodyTable& names = {});

/// FirstDifference::phase where only what the engine was told differs: gravity, a mass, names, phases.
inline constexpr const char* kSetup = "setup";

/// The first difference between a session and its golden, for people and programs.
struct FirstDifference {
  std::uint64_t step = 0;
  std::optional<std::uint32_t> substep;  ///< if the golden has words for each substep
  /// "find_contacts", …; "setup" where only what the engine was told differs; "start", "inputs or counters", "step",
  /// "hidden state"; "channel.knee" or "contacts" where these of another engine differ and its states do not.
  std::string phase;
  std::string told = {};  ///< "before step 7, dt: 0.0166 → 0.02": of an engine's session, where the golden keeps it
  std::optional<std::uint64_t> states_from;  ///< the first step whose state differs; none: no state does
  std::vector<std::string> details;  ///< sentences: bodies and fields at the nearest stored state, how far apart
  std::optional<Apart>
      apart;  ///< none: no position that the golden keeps differs, to the millimetre between its states
};

/// One sentence: "step 12, phase find_contacts; states differ from step 13".
std::string describe(const FirstDifference& difference);

/// Compares every step of a session with a golden: state hash, phase words, dt, inputs and counters. Golden and header
/// must outlive it.
class ExpectedComparer {
 public:
  ExpectedComparer(const Expected& expected, const replay::LogHeader& header);

  /// State 0, then every step in order, with states.
  void add(const replay::StepRecord& record);

  /// After the last step. continuation: of the last state, zero where it is not known.
  std::optional<FirstDifference> finish(const Hash128& continuation);

  /// Channels of the golden that the session lacks or has in another type, a sentence each.
  [[nodiscard]] std::vector<std::string> lost_channels() const;

  /// Bodies of another shape than in the golden, or in one of the two alone, a sentence each; of all steps given.
  [[nodiscard]] std::vector<std::string> other_shapes() const;

  /// The channels, contacts, shapes and the setup that were compared, in words.
  [[nodiscard]] std::vector<std::string> extras() const;

  /// Reasons why something could not be compared, such as phase words of another version.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

 private:
  void compare_words(const replay::StepRecord& record);
  void note_told(const replay::StepRecord& record);
  void compare_extras(const replay::StepRecord& record);
  void look_closer(const replay::StepRecord& record);
  void follow_track(const replay::StepRecord& record);
  void follow_state(const replay::StepRecord& record);
  void note_apart(double metres, std::uint64_t step, sim::BodyId body);
  void note_first(std::uint64_t step, const std::string& phase, std::optional<std::uint32_t> substep = {});

  const Expected& expected_;
  std::vector<std::string> setup_;  // what was told otherwise
  bool same_phases_;
  bool same_words_;                       // and their hashes cover the same fields
  std::optional<ExtrasComparer> extras_;  // none: the golden is older than channels
  bool in_binary32_;                      // ULPs are those of floats
  replay::EngineAxes axes_;               // that name fields
  ShapesKeeper shapes_;
  std::optional<FirstDifference> first_;
  std::uint64_t steps_ = 0;
  std::uint64_t next_step_ = 0;  // that add() expects
  std::string bodies_detail_;
  std::string field_detail_;
  std::vector<std::string> extra_fields_;  // channels and contacts that differ in the first step in which any does
  std::uint64_t extra_step_ = 0;
  std::vector<std::string> extra_details_;
  std::vector<std::string> notes_;
  Apart apart_;
};

}  // namespace tumble::golden
