#include "golden/report/files.h"

#include <algorithm>
#include <string_view>

#include "golden/judge/case_series.h"
#include "golden/report/page/script.h"
#include "golden/suite/text_files.h"
#include "replay/measure/metric_list.h"

namespace tumble::golden {
namespace {

/// The groups of the metrics that a case judges, "energy stacking": the page draws their plots and no other.
std::string groups_of(const CaseResult& result) {
  std::string groups;
  for (const char* group : {"energy", "symmetry", "stacking"}) {
    const bool is_judged = std::ranges::any_of(result.metrics, [&](const MetricResult& metric) {
      const replay::MetricRow* row = replay::find_metric(metric.rule.name);
      return row != nullptr && std::string_view(row->group) == group;
    });
    if (is_judged) groups += (groups.empty() ? "" : " ") + std::string(group);
  }
  return groups;
}

}  // namespace

std::string ReportFiles::take(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(folder_ / path, error);
  if (error || size > kBytesMax - bytes_) return "";
  const Result<std::string> text = read_text(folder_ / path);
  if (!text.ok()) return "";
  bytes_ += size;
  is_drawn_ = true;
  return *text;
}

Html ReportFiles::image_source(const std::string& path) {
  const std::string bytes = take(path);
  return bytes.empty() ? golden::path(path) : Html("data:image/png;base64,") << base64_text(bytes);
}

Html ReportFiles::json(const std::string& path) { return json_text(take(path)); }

Html drawing_section(const CaseResult& result, ReportFiles& files) {
  const std::string path = "cases/" + result.name + "/" + kSeriesFile;
  if (std::ranges::find(result.artifacts, path) == result.artifacts.end()) return {};
  const Html json = files.json(path);
  if (json.empty()) {
    return Html(
        "<p class=\"soft\">Its plots are not in this page, which has enough of them; check the case alone.</p>\n");
  }
  Html out("<div class=\"drawing\"");
  if (result.difference) out << " data-first=\"" << text(std::to_string(result.difference->step)) << "\"";
  return out << " data-groups=\"" << text(groups_of(result)) << "\">"
             << "<p class=\"soft\">Plots and trajectories need JavaScript.</p><script type=\"application/json\">"
             << json << "</script></div>\n";
}

Html script_hash() {
  const std::string_view digits = report_script_sha256();
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    bytes += static_cast<char>(std::stoi(std::string(digits.substr(i, 2)), nullptr, 16));
  }
  return base64_text(bytes);
}

Html script_section() {
  Html out("<script>");
  for (const std::string_view piece : report_script_pieces()) out << script_of_this_program(piece);
  return out << "</script>\n";
}

}  // namespace tumble::golden
