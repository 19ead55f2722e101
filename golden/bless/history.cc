#include "golden/bless/history.h"

#include <array>
#include <ctime>
#include <system_error>

#include "golden/judge/case_result.h"
#include "golden/suite/suite.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

constexpr const char* kHeading =
    "# History of the goldens\n\nWritten by `tumble bless`, newest first: what moved, by how much, why.\n";

std::string value_text(const std::optional<double>& value, const std::string& unit) {
  return value ? rounded(*value, unit) : "null";
}

/// "drift_max 0.1 m → 0.2 m"; empty for a value that did not move.
std::string metric_line(const MetricResult& metric, bool is_new) {
  const std::string after = value_text(metric.value, metric.unit);
  if (is_new) return metric.rule.name + ' ' + after;
  if (metric.value == metric.rule.value) return "";
  return metric.rule.name + ' ' + value_text(metric.rule.value, metric.unit) + " → " + after;
}

}  // namespace

std::string history_entry(const std::string& date, const std::string& reason, const std::vector<Blessing>& blessings) {
  std::string text = "\n## " + date + ": " + reason + "\n\n";
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

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::tm utc = {};
  ::gmtime_r(&now, &utc);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", &utc);
  return text.data();
}

}  // namespace tumble::golden
