#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/golden/case_rules.h"
#include "tumble/sim/result.h"

/// A suite on disk: a folder with `cases/<name>/` in it. docs/goldens.md describes the files.
namespace tumble::golden {

inline constexpr const char* kSceneFile = "scene.toml";
inline constexpr const char* kRulesFile = "metrics.toml";
inline constexpr const char* kExpectedFile = "expected.tumble";
inline constexpr const char* kHistoryFile = "HISTORY.md";

struct CaseFolder {
  std::string name;
  std::filesystem::path path;
  [[nodiscard]] std::filesystem::path file(const char* which) const { return path / which; }
};

struct Suite {
  std::filesystem::path root;         ///< the folder that has `cases` in it
  std::vector<CaseFolder> cases;      ///< by name
  std::vector<std::string> problems;  ///< files that belong to no case; each fails a check
};

/// Errors (kBadInput): no such folder, no folder `cases` in it, no case in that.
Result<Suite> open_suite(const std::filesystem::path& root);

/// A case's name as a folder: letters, digits, '_' and '-'. Errors (kBadInput).
Status check_case_name(const std::string& name);

/// [engine] of a case's rules; none where it has none or its rules cannot be read, which the case's run reports.
std::optional<EngineCase> engine_case(const CaseFolder& folder);

/// Files in a case's folder that nothing reads, and files that are missing, a sentence each.
std::vector<std::string> folder_problems(const CaseFolder& folder);

/// Chooses cases of a suite: the named ones, or all; of these a category; of these a shard.
struct Selection {
  std::vector<std::string> names;
  std::string category;   ///< empty: all
  std::size_t shard = 1;  ///< K of N, 1-based
  std::size_t shards = 1;
};

/// Assigns cases to shards, in the words of report.json and docs/sharding.md.
inline constexpr const char* kAssignment = "1 + low 64 bits of XXH3-128(name) mod N";

/// The shard, 1 … shards, that a case belongs to: by its name alone, so that a case that comes or goes moves no other.
std::size_t shard_of_name(std::string_view name, std::size_t shards);

/// The cases of all shards, by name. Errors (kBadInput): a name that no case has (with the nearest), a selection
/// without a case.
Result<std::vector<CaseFolder>> select_cases(const Suite& suite, const Selection& selection);

/// Those of one shard, by shard_of_name(); none where no name falls to it.
std::vector<CaseFolder> shard_of(const std::vector<CaseFolder>& selected, const Selection& selection);

}  // namespace tumble::golden
