#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "golden/bundle/manifest.h"
#include "golden/judge/case_json.h"
#include "tests/support/golden_suite.h"
#include "tumble/golden/suite_result.h"

/// Bundles of shards, to be merged or spoiled.
namespace tumble::golden {

/// Runs one shard of a suite and leaves its bundle.
SuiteResult check_shard(const TemporarySuite& suite, std::size_t shard, std::size_t shards,
                        const std::filesystem::path& report);

/// The bundles of 200 cases in 20 shards whose results are made up: no case is run. case_7 failed and left a file.
class MadeShards : public testing::Test {
 public:
  ~MadeShards() override;

 protected:
  static constexpr std::size_t kCases = 200;
  static constexpr std::size_t kShards = 20;

  MadeShards();

  [[nodiscard]] std::filesystem::path shard(std::size_t k) const { return root_ / ("shard-" + std::to_string(k)); }
  [[nodiscard]] std::filesystem::path out() const { return root_ / "merged"; }

  /// Merges folders_ into out().
  Result<SuiteResult> merge();
  /// Changes a manifest and gives it the hash of its new text, as a program would that writes such a bundle.
  void edit(std::size_t k, const std::function<void(Manifest& manifest)>& change);
  /// Changes report.json, and the manifest with it.
  void edit_report(std::size_t k, const std::function<void(Json& report)>& change);
  /// The merge fails so, its message has all parts, and it leaves no bundle, not even an earlier one.
  void expect_error(ErrorKind kind, const std::vector<std::string>& parts);

  static void write(const std::filesystem::path& path, const std::string& text);
  static std::string read(const std::filesystem::path& path);

  std::filesystem::path root_;
  std::vector<std::filesystem::path> folders_;

 private:
  void make_shard(std::size_t k);
};

}  // namespace tumble::golden
