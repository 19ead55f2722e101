#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tumble::golden {

/// One shard of a merged check, as the merged bundle names it.
struct MergedShard {
  std::size_t shard = 1;
  std::size_t cases = 0;
  std::size_t canaries = 0;
  double seconds = 0;   ///< of wall time
  std::string machine;  ///< its class
  std::string date;     ///< UTC
};

inline constexpr std::string_view kGiven = "yes";  ///< the value of an option that takes none

/// Facts on a check that all shards of one suite must agree on, and the cases that fell to this one. Hashes are 32
/// hexadecimal digits of XXH3-128.
struct RunFacts {
  std::string program_hash;   ///< of the program's file
  std::string suite_hash;     ///< of every file of the suite's cases, their names, and the engine's tumble.toml
  std::string engine_hash;    ///< of the engine's files, after its build; empty: no case of this shard runs it
  std::string selected_hash;  ///< of the names of the cases of all shards
  /// Options that can change a verdict, and their values: "require", "exact behaviour"; "heavy", kGiven.
  std::vector<std::pair<std::string, std::string>> options;
  std::vector<std::string> canaries;  ///< names of those of all shards, in order
  std::vector<std::string> expected;  ///< names of this shard's cases, in order, before any was run
  std::vector<MergedShard> merged;    ///< by shard; empty for a check that was run
};

}  // namespace tumble::golden
