#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "golden/expected/compare_expected.h"
#include "golden/suite/case_rules.h"

/// The result of judging one case: plain data, as report.json has it.
namespace tumble::golden {

/// Keys stay in the order in which they are set.
using Json = nlohmann::ordered_json;

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
  std::optional<double> value;  ///< measured now; none: null
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
  std::vector<MetricResult> metrics;
  std::vector<PictureResult> pictures;
  std::optional<FirstDifference> difference;
  std::string final_hash;              ///< of the session judged; empty if there was none
  std::vector<std::string> artifacts;  ///< files left for a person, relative to the report folder
  std::string reproduce;               ///< the command line that records the session
  std::string bless;                   ///< the command line that accepts it

  [[nodiscard]] const Verdict& verdict(VerdictKind kind) const { return verdicts[static_cast<std::size_t>(kind)]; }
  Verdict& verdict(VerdictKind kind) { return verdicts[static_cast<std::size_t>(kind)]; }
  /// No problem, and every required verdict passed.
  [[nodiscard]] bool passed() const;
};

/// The case in a few words: "same bits, same behaviour"; "bits moved, behaviour same"; "crashed: SIGSEGV".
std::string summary(const CaseResult& result);

Json to_json(const CaseResult& result);
/// Errors (kCannotFinish): text that to_json() did not make.
Result<CaseResult> case_from_json(const std::string& text);

}  // namespace tumble::golden
