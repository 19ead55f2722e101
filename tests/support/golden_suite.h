#pragma once

#include <filesystem>
#include <string>

#include "tumble/golden/check.h"

/// Suites made for a test, in a folder of its own.
namespace tumble::golden {

inline constexpr const char* kFallingBoxes = R"(title = "two boxes fall"
category = "stacking"
[world]
method = "thesis"
dt = 0.016666666666666666
steps = 30
[[box]]
position = [0.0, 0.0, 0.7]
[[box]]
position = [0.1, 0.2, 2.0]
spin = [0.5, 1.0, 0.0]
)";

inline constexpr const char* kTwoMetrics = R"([[metric]]
name = "drift_max"
max = 100.0
why = "they fall straight down and topple"

[[metric]]
name = "lost"  # a comment that stays
max = 0
why = "nothing falls through the ground"
)";

/// A suite in a new folder, removed at the end.
class TemporarySuite {
 public:
  TemporarySuite();
  ~TemporarySuite();
  TemporarySuite(const TemporarySuite&) = delete;
  TemporarySuite& operator=(const TemporarySuite&) = delete;

  [[nodiscard]] const std::filesystem::path& root() const { return root_; }
  [[nodiscard]] std::filesystem::path file(const std::string& name, const std::string& which) const {
    return root_ / "cases" / name / which;
  }

  /// A case that was not blessed yet.
  void add(const std::string& name, const std::string& scene = kFallingBoxes,
           const std::string& rules = kTwoMetrics) const;
  /// Blesses all cases; fails the test if that does not work.
  void bless() const;
  void write(const std::filesystem::path& path, const std::string& content) const;
  [[nodiscard]] std::string read(const std::filesystem::path& path) const;
  /// Replaces text in a file of a case; fails the test if it is not there.
  void edit(const std::string& name, const std::string& which, const std::string& what, const std::string& with) const;

  /// Checks the suite, or one case of it.
  [[nodiscard]] SuiteResult check(const std::string& name = "") const;
  /// The result of the only case checked.
  [[nodiscard]] CaseResult check_one(const std::string& name) const;

 private:
  std::filesystem::path root_;
};

}  // namespace tumble::golden
