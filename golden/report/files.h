#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "golden/report/html_text.h"
#include "tumble/golden/case_result.h"

namespace tumble::golden {

/// Embeds the files of failed cases, which lie in the report's folder, in the page, so that it can be sent as one file.
/// Past a limit for the whole page, further files stay in the folder.
class ReportFiles {
 public:
  static constexpr std::uintmax_t kBytesMax = 24U << 20U;

  explicit ReportFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The source of an <img>: the picture itself, or past the limit its path. path: relative to the folder.
  Html image_source(const std::string& path);

  /// JSON for the page's <script>; empty past the limit, or if there is none.
  Html json(const std::string& path);

  /// True if anything was embedded: then the page needs its script.
  [[nodiscard]] bool is_drawn() const { return is_drawn_; }

 private:
  std::string take(const std::string& path);

  std::filesystem::path folder_;
  std::uintmax_t bytes_ = 0;
  bool is_drawn_ = false;
};

/// The place for plots and trajectories of a failed case, and the numbers for them. Empty if there are none.
Html drawing_section(const CaseResult& result, ReportFiles& files);

/// The script element at the page's end.
Html script_section();

/// The SHA-256 of that script in base 64, by which a page's policy knows it.
Html script_hash();

}  // namespace tumble::golden
