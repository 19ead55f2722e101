#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "golden/judge/case_result.h"

namespace tumble::golden {

/// Files that failed cases left in the report's folder, taken into the page so that it can be sent as one file. Past a
/// limit for the whole page, what is left is not taken in but stays where it lies.
class ReportFiles {
 public:
  static constexpr std::uintmax_t kBytesMax = 24U << 20U;

  explicit ReportFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// What an <img> has as its source: the picture itself, or past the limit its path. path: relative to the folder.
  std::string image_source(const std::string& path);

  /// JSON that is safe within a page's <script>; empty past the limit, or if there is none.
  std::string json(const std::string& path);

  /// Whether anything was taken in, so that the page needs its script.
  [[nodiscard]] bool is_drawn() const { return is_drawn_; }

 private:
  std::string take(const std::string& path);

  std::filesystem::path folder_;
  std::uintmax_t bytes_ = 0;
  bool is_drawn_ = false;
};

/// Where the script draws plots and trajectories of a failed case, and the numbers for it. Empty if there are none.
std::string drawing_section(const CaseResult& result, ReportFiles& files);

/// The script element at the page's end.
std::string script_section();

}  // namespace tumble::golden
