#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "tumble/golden/provenance.h"
#include "tumble/golden/run_facts.h"
#include "tumble/sim/result.h"

/// bundle.json of a report folder: which shard of which check it holds, and the hash of every file that a merge reads.
/// docs/sharding.md describes the keys.
namespace tumble::golden {

inline constexpr const char* kBundleFile = "bundle.json";
inline constexpr const char* kReportFile = "report.json";
inline constexpr int kBundleFormat = 2;  ///< 1: every shard asked all canaries

struct BundleFile {
  std::string path;  ///< relative to the folder
  std::uint64_t bytes = 0;
  std::string hash;  ///< XXH3-128
};

struct Manifest {
  std::string suite;  ///< its folder, as given to the check; may differ from machine to machine
  std::size_t shard = 1;
  std::size_t shards = 1;
  std::string assignment;    ///< the rule: kAssignment
  std::size_t selected = 0;  ///< cases of all shards together
  Provenance run;
  RunFacts facts;
  std::vector<std::string> judged;    ///< names, in order
  std::vector<std::string> canaries;  ///< names of those that the shard asked, in order
  std::vector<BundleFile> files;
};

/// The text of bundle.json. Its last key is the hash of all text before that key.
std::string manifest_text(const Manifest& manifest);

/// Reads DIR/bundle.json. Errors name the file. kBadInput: no such folder or file, or another format. kDamaged: text
/// that is not as it was written, or that names a file outside the folder.
Result<Manifest> read_manifest(const std::filesystem::path& folder);

}  // namespace tumble::golden
