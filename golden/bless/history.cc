#include "tumble/golden/history.h"

#include <string_view>
#include <system_error>

#include "golden/suite/text_files.h"
#include "tumble/golden/case_result.h"
#include "tumble/golden/change.h"
#include "tumble/golden/provenance.h"
#include "tumble/golden/suite.h"

namespace tumble::golden {
namespace {

constexpr const char* kHeading =
    "# History of the goldens\n\nWritten by `tumble bless`, newest first: what moved, by how much, why.\n";

/// "drift_max 0.1 m → 0.2 m"; empty for a value that did not move.
std::string metric_line(const MetricResult& metric, bool is_new) {
  if (is_new) return metric.rule.name + ' ' + value_text(metric.value, metric.unit);
  return has_moved(metric) ? movement_text(metric) : "";
}

}  // namespace

std::string history_entry(const std::string& reason, const std::vector<Blessing>& blessings) {
  std::string text = "\n## " + utc_now().substr(0, std::string_view("2026-11-22").size()) + ": " + reason + "\n\n";
  for (const Blessing& blessing : blessings) {
    text += "- **" + blessing.name + "**: " + blessing.bits;
    for (const std::string& detail : blessing.details) text += "; " + detail;
    std::string metrics;
    for (const MetricResult& metric : blessing.metrics) {
      const std::string line = metric_line(metric, blessing.is_new);
      if (!line.empty()) metrics += (metrics.empty() ? "" : ", ") + line;
    }
    text += metrics.empty() ? ". No metric moved.\n" : ". " + metrics + ".\n";
  }
  return text;
}

Status add_to_history(const std::filesystem::path& suite, const std::string& entry) {
  const std::filesystem::path path = suite / kHistoryFile;
  std::error_code error;
  std::string old;
  if (std::filesystem::exists(path, error)) {
    Result<std::string> text = read_text(path);
    if (!text.ok()) return text.error();
    old = *std::move(text);
  }
  const std::size_t entries = old.find("\n## ");
  const std::string heading = old.empty() ? kHeading : old.substr(0, entries);
  const std::string rest = entries == std::string::npos ? "" : old.substr(entries);
  return write_file(path, std::string_view(heading + entry + rest));
}

}  // namespace tumble::golden
