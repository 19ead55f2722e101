#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/golden/case_rules.h"
#include "tumble/golden/compare_expected.h"
#include "tumble/golden/provenance.h"
#include "tumble/golden/scene_changes.h"

/// The result of judging one case: plain data, as report.json has it.
namespace tumble::golden {

enum class Outcome : std::uint8_t {
  kNone = 0,  ///< nothing to judge yet; a failure where it is required
  kPass = 1,
  kFail = 2,
};

struct Verdict {
  Outcome outcome = Outcome::kNone;
  std::string message;  ///< "same bits in all 301 states", "1 of 6 metrics out of bounds"
};

struct MetricResult {
  MetricRule rule;
  std::string unit;
  std::optional<double> value;   ///< measured now; none: null
  std::optional<double> spread;  ///< of repeated runs of an engine that differ: largest − least; value is their median
  bool pass = false;
  std::string message;  ///< why it failed, or by how much it moved; may be empty
};

struct PictureResult {
  PictureRule rule;
  std::uint64_t pixels = 0;   ///< that are not as blessed
  std::uint64_t far_off = 0;  ///< of these, by more than render::kFarOffLevels
  bool pass = false;
  std::string message;  ///< the difference; empty if there is none
};

struct CaseResult {
  std::string name;
  std::string title;
  std::string category;
  std::uint64_t steps = 0;
  std::uint64_t bodies = 0;
  double seconds = 0;                 ///< of wall time
  std::vector<VerdictKind> require;   ///< which verdicts decide
  std::array<Verdict, 3> verdicts;    ///< by VerdictKind
  std::vector<std::string> problems;  ///< each fails the case whatever it requires: missing, stale, damaged, crashed …
  std::vector<std::string> notes;     ///< fail nothing
  std::uint64_t runs = 1;             ///< of the engine, judged together
  std::string runs_message;           ///< of more than one: whether they agree, or by how much they differ
  std::string gone_on;                ///< of `check --heavy`: from how many steps, or why from none; empty: not asked
  bool was_gone_on = false;           ///< the session was gone on with from its steps, well or not
  std::vector<MetricResult> metrics;
  std::vector<PictureResult> pictures;
  std::optional<FirstDifference> difference;
  std::vector<SceneChange> scene_changes;  ///< of scene.toml since it was blessed; empty where the golden has no text
  std::optional<Provenance> blessed_by;    ///< none: there is no golden
  std::string continuation;            ///< hash of the hidden state after the last step; zeros where it is not known
  std::string final_hash;              ///< of the session judged; empty if there was none
  std::vector<std::string> artifacts;  ///< files left for a person, relative to the report folder
  std::string reproduce;               ///< the command line that records the session
  std::string bless;                   ///< the command line that accepts it; empty if bless would refuse
  std::string bless_refused;           ///< why bless would refuse, or how its process ended; empty if neither

  [[nodiscard]] const Verdict& verdict(VerdictKind kind) const { return verdicts[static_cast<std::size_t>(kind)]; }
  Verdict& verdict(VerdictKind kind) { return verdicts[static_cast<std::size_t>(kind)]; }
  /// No problem, and every required verdict passed.
  [[nodiscard]] bool passed() const;
};

}  // namespace tumble::golden
