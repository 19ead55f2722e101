#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/replay/log_reader.h"
#include "tumble/replay/tolerance.h"

namespace tumble::replay {

/// The parts that an answer "identical" or "the same" speaks of, for people and programs.
struct ComparisonScope {
  std::vector<std::string> compared;      ///< "inputs", "phase hashes", "states of 40 steps"
  std::vector<std::string> not_compared;  ///< in the logs, and passed over; each with its reason

  /// The parts that were not compared though steps depend on them: not_compared without never_compared().
  [[nodiscard]] std::vector<std::string> passed_over() const;
  /// "every bit"; "every compared bit" where something was passed over.
  [[nodiscard]] std::string every_bit() const;
};

/// What several comparisons of logs looked at: the parts that all of them compared, and all that any passed over, with
/// the names of the logs where not all did.
class CommonScope {
 public:
  void add(const ComparisonScope& scope, const std::string& logs);
  [[nodiscard]] ComparisonScope scope() const;

 private:
  struct Part {
    std::string text;
    std::size_t count = 0;
    std::string logs;  // of the first comparison with it
  };
  static void count(const std::string& text, const std::string& logs, std::vector<Part>& parts);
  std::vector<Part> compared_, not_compared_;
  std::size_t comparisons_ = 0;
};

/// The way in which two logs were compared.
struct DiffFacts {
  std::uint64_t from = 0;             ///< the first state of both
  std::uint64_t last = 0;             ///< the last step of both
  bool hashes_only = false;           ///< chunks with equal chains were not read
  bool states_only = false;           ///< two engines: dt and states alone
  PhaseMatch phases;                  ///< whose words mean the same in both
  bool imported = false;              ///< one log at least is another engine's
  bool no_contacts = false;           ///< known: one engine at least told of no contact
  bool one_scene = false;             ///< scenes and method versions are equal, so complete states were compared
  std::uint64_t worlds = 0;           ///< complete states compared
  std::uint64_t zeros = 0;            ///< whose sign alone differs, counted as equal
  std::uint64_t states_read = 0;      ///< steps whose states were read because their hashes differ
  std::vector<std::string> channels;  ///< names of those compared
  std::vector<std::string> left_out;  ///< channels and derived values that were not compared, each with its reason
};

/// Steps after `from`, up to `last`.
struct StepRange {
  std::uint64_t from = 0;
  std::uint64_t last = 0;
};

/// Adds which steps' phase hashes are compared. a and b may be one log, which is compared with this build.
void add_phase_hashes(const LogReader& a, const LogReader& b, const StepRange& range, ComparisonScope& scope);

ComparisonScope scope_of(const LogReader& a, const LogReader& b, const Tolerances& tolerances, const DiffFacts& facts);

/// "torn.tumble is not whole: torn: complete up to byte 59321, …", or that its recorder was stopped; empty for a whole
/// log of a session that came to its end.
std::string not_whole(const LogReader& log);

/// not_whole() of two logs, each text once.
std::vector<std::string> notes_on_wholeness(const LogReader& a, const LogReader& b);

/// The bytes of a log that no intact record holds, which nothing compares; empty for a sound log.
std::string not_intact(const LogReader& log);

/// The parts of any log that no comparison looks at.
std::string never_compared();

}  // namespace tumble::replay
