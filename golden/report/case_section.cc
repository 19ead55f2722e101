#include "golden/report/case_section.h"

#include <algorithm>
#include <cmath>

#include "golden/report/commands.h"
#include "golden/report/html_parts.h"
#include "golden/report/pictures.h"
#include "src/base/text.h"
#include "tumble/golden/change.h"

namespace tumble::golden {
namespace {

std::string bound_text(const MetricResult& metric) {
  std::string text;
  if (metric.rule.min) text += "≥ " + rounded(*metric.rule.min, metric.unit);
  if (metric.rule.max) text += (text.empty() ? "≤ " : ", ≤ ") + rounded(*metric.rule.max, metric.unit);
  return text;
}

/// Distance of the value from its nearer bound; negative outside. A value that is no finite number has none.
std::string margin_text(const MetricResult& metric) {
  if (!metric.value || !std::isfinite(*metric.value)) return "–";
  double margin = INFINITY;
  if (metric.rule.min) margin = std::min(margin, *metric.value - *metric.rule.min);
  if (metric.rule.max) margin = std::min(margin, *metric.rule.max - *metric.value);
  return std::isfinite(margin) ? rounded(margin, metric.unit) : "–";
}

std::string choice_text(const MetricRule& rule) {
  std::string text;
  if (rule.bodies != "all") text += " of " + rule.bodies;
  if (rule.axis != "x") text += " along " + rule.axis;
  if (rule.from_step > 0) text += " from step " + std::to_string(rule.from_step);
  return text;
}

Html metric_row(const MetricResult& metric) {
  const Outcome outcome = metric.pass ? Outcome::kPass : Outcome::kFail;
  const std::string words = metric.pass && has_moved(metric) ? "✓ moved" : words_of(outcome);
  Html out("<tr class=\"");
  out << text(class_of(outcome)) << "\">" << element("<td class=\"mark\">", words, "</td>")
      << cell("metric", metric.rule.name + choice_text(metric.rule))
      << cell("value", value_text(metric.value, metric.unit), true) << cell("bound", bound_text(metric), true)
      << cell("margin", margin_text(metric), true)
      << cell("blessed", metric.rule.value ? value_text(metric.rule.value, metric.unit) : "not yet", true) << "<td>"
      << text(metric.rule.why);
  if (!metric.message.empty()) out << element("<br><strong>", metric.message, "</strong>");
  return out << "</td></tr>\n";
}

Html metric_table(const std::vector<MetricResult>& metrics) {
  if (metrics.empty()) return {};
  Html out(
      "<h3>Metrics</h3>\n<div class=\"scroll\"><table><thead><tr><th>Verdict</th><th>Metric</th><th "
      "class=\"number\">Value</th><th class=\"number\">Bound</th><th class=\"number\">Margin</th><th "
      "class=\"number\">Blessed</th><th>Why the bound</th></tr></thead><tbody>\n");
  for (const MetricResult& metric : metrics) out << metric_row(metric);
  return out << "</tbody></table></div>\n";
}

Html verdict_list(const CaseResult& result) {
  std::vector<std::string> verdicts;
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    const Verdict& verdict = result.verdicts[k];
    const std::string words = verdict.message.empty() ? "not judged" : verdict.message;
    verdicts.push_back(std::string(kVerdictNames[k]) + ": " + words);
  }
  return Html("<h3>Verdicts</h3>\n") << list_of(verdicts);
}

Html command_list(const CaseResult& result, const std::string& suite) {
  Html out;
  for (const NextCommand& next : next_commands(result, suite)) {
    out << element("<h3>", next.purpose, "</h3>\n") << element("<pre tabindex=\"0\">", next.line, "</pre>\n");
  }
  if (!result.bless_refused.empty()) {
    out << "<h3>It cannot be accepted yet</h3>\n"
        << element("<p>", "bless would refuse it: " + result.bless_refused, "</p>\n");
  }
  return out;
}

Html file_list(const CaseResult& result) {
  if (result.artifacts.empty()) return {};
  Html out("<h3>Files</h3>\n<ul>\n");
  for (const std::string& file : result.artifacts) {
    out << "<li><a href=\"" << path(file) << "\">" << text(file) << "</a></li>\n";
  }
  return out << "</ul>\n";
}

Html body_of(const CaseResult& result, const std::string& suite, ReportFiles& files) {
  Html out("<div class=\"inside\">\n");
  out << element("<p class=\"soft\">",
                 (result.title.empty() ? "" : result.title + " · ") + count_text(result.bodies, "body") + ", " +
                     count_text(result.steps, "step") + ", " + fixed(result.seconds, 2) + " s",
                 "</p>\n");
  if (result.blessed_by) {
    out << element("<p class=\"soft\">", "blessed: " + describe(*result.blessed_by), "</p>\n");
  }
  if (!result.problems.empty()) out << "<h3>Problems of the case</h3>\n" << list_of(result.problems);
  if (!result.scene_changes.empty()) {
    std::vector<std::string> lines;
    for (const SceneChange& change : result.scene_changes) lines.push_back(describe(change));
    const char* files_of = lines.front().starts_with("line ") ? "scene.toml" : "its files";  // an engine's have names
    out << element("<h3>Lines of ", files_of, " that changed</h3>\n") << list_of(lines);
  }
  out << verdict_list(result);
  if (result.difference) out << "<h3>How far it went</h3>\n" << list_of(result.difference->details);
  out << picture_section(result, files) << drawing_section(result, files) << metric_table(result.metrics);
  if (!result.notes.empty()) out << "<h3>Notes</h3>\n" << list_of(result.notes);
  if (!result.passed()) out << command_list(result, suite);
  return out << file_list(result) << "</div>\n";
}

}  // namespace

Html case_section(const CaseResult& result, const std::string& suite, ReportFiles& files) {
  const bool passed = result.passed();
  Html out("<details class=\"");
  out << text(class_of(passed ? Outcome::kPass : Outcome::kFail)) << "\" data-verdict=\""
      << text(passed ? key_of(change_of(result)) : "failed") << "\" data-category=\"" << text(result.category) << "\"";
  if (!passed) out << " open";
  out << "><summary><h3 id=\"" << text(result.name) << "\">" << text(mark_of(passed)) << text(result.name)
      << "</h3><span>" << text(summary(result)) << "</span><span class=\"chips\">";
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) out << chip(kVerdictNames[k], result.verdicts[k].outcome);
  return out << "</span></summary>\n" << body_of(result, suite, files) << "</details>\n";
}

}  // namespace tumble::golden
