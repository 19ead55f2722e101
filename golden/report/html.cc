#include "golden/report/html.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "golden/report/commands.h"
#include "golden/report/files.h"
#include "golden/report/page/style.h"
#include "golden/report/pictures.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

constexpr std::array<const char*, 3> kOutcomeClass = {"none", "pass", "fail"};
constexpr std::array<const char*, 3> kOutcomeMark = {"–", "✓", "✕"};
constexpr std::array<const char*, 3> kOutcomeWord = {"none", "passed", "failed"};

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string element(const std::string& tag, std::string_view text) {
  return "<" + tag + ">" + escaped(text) + "</" + tag.substr(0, tag.find(' ')) + ">\n";
}

std::string chip(const char* name, Outcome outcome) {
  const auto k = static_cast<std::size_t>(outcome);
  return std::string("<span class=\"chip ") + kOutcomeClass[k] + "\">" + kOutcomeMark[k] + " " + name + " " +
         kOutcomeWord[k] + "</span>";
}

std::string value_text(const std::optional<double>& value, const std::string& unit) {
  return value ? rounded(*value, unit) : "null";
}

std::string bound_text(const MetricResult& metric) {
  std::string text;
  if (metric.rule.min) text += "≥ " + rounded(*metric.rule.min, metric.unit);
  if (metric.rule.max) text += (text.empty() ? "≤ " : ", ≤ ") + rounded(*metric.rule.max, metric.unit);
  return text;
}

/// Distance of the value from its nearer bound; negative outside.
std::string margin_text(const MetricResult& metric) {
  if (!metric.value) return "–";
  double margin = INFINITY;
  if (metric.rule.min) margin = std::min(margin, *metric.value - *metric.rule.min);
  if (metric.rule.max) margin = std::min(margin, *metric.rule.max - *metric.value);
  return rounded(margin, metric.unit);
}

std::string cell(const char* name, const std::string& text, bool is_number) {
  return std::string("<td") + (is_number ? " class=\"number\"" : "") + " data-name=\"" + name + "\">" + escaped(text) +
         "</td>";
}

std::string choice_text(const MetricRule& rule) {
  std::string text;
  if (rule.bodies != "all") text += " of " + rule.bodies;
  if (rule.axis != "x") text += " along " + rule.axis;
  if (rule.from_step > 0) text += " from step " + std::to_string(rule.from_step);
  return text;
}

std::string metric_table(const std::vector<MetricResult>& metrics) {
  if (metrics.empty()) return "";
  std::string out =
      "<h3>Metrics</h3>\n<div class=\"scroll\"><table><thead><tr><th>Verdict</th><th>Metric</th><th "
      "class=\"number\">Value</th><th class=\"number\">Bound</th><th class=\"number\">Margin</th><th "
      "class=\"number\">Blessed</th><th>Why the bound</th></tr></thead><tbody>\n";
  for (const MetricResult& metric : metrics) {
    const Outcome outcome = metric.pass ? Outcome::kPass : Outcome::kFail;
    const auto k = static_cast<std::size_t>(outcome);
    const std::string words = std::string(kOutcomeMark[k]) + " " + kOutcomeWord[k];
    out += std::string("<tr class=\"") + kOutcomeClass[k] + "\"><td class=\"mark\">" + words + "</td>" +
           cell("metric", metric.rule.name + choice_text(metric.rule), false) +
           cell("value", value_text(metric.value, metric.unit), true) + cell("bound", bound_text(metric), true) +
           cell("margin", margin_text(metric), true) +
           cell("blessed", metric.rule.value ? value_text(metric.rule.value, metric.unit) : "not yet", true) + "<td>" +
           escaped(metric.rule.why);
    if (!metric.message.empty()) out += "<br><strong>" + escaped(metric.message) + "</strong>";
    out += "</td></tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string list_of(const std::vector<std::string>& texts) {
  if (texts.empty()) return "";
  std::string out = "<ul>\n";
  for (const std::string& text : texts) out += element("li", text);
  return out + "</ul>\n";
}

std::string command(const NextCommand& next) {
  return element("h3", next.purpose) + "<pre tabindex=\"0\">" + escaped(next.line) + "</pre>\n";
}

std::string case_body(const CaseResult& result, const std::string& suite, ReportFiles& files) {
  std::string out = "<div class=\"inside\">\n";
  out += "<p class=\"soft\">" + escaped(result.title) + " · " + std::to_string(result.bodies) + " bodies, " +
         std::to_string(result.steps) + " steps, " + fixed(result.seconds, 2) + " s" + "</p>\n";
  if (!result.problems.empty()) out += element("h3", "Problems of the case") + list_of(result.problems);
  std::vector<std::string> verdicts;
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    const Verdict& verdict = result.verdicts[k];
    const std::string words = verdict.message.empty() ? "not judged" : verdict.message;
    verdicts.push_back(std::string(kVerdictNames[k]) + ": " + words);
  }
  out += element("h3", "Verdicts") + list_of(verdicts);
  if (result.difference) out += element("h3", "How far it went") + list_of(result.difference->details);
  out += picture_section(result, files) + drawing_section(result, files) + metric_table(result.metrics);
  if (!result.notes.empty()) out += element("h3", "Notes") + list_of(result.notes);
  if (!result.passed()) {
    for (const NextCommand& next : next_commands(result, suite)) out += command(next);
  }
  if (!result.artifacts.empty()) {
    out += element("h3", "Files");
    out += "<ul>\n";
    for (const std::string& file : result.artifacts) {
      out += "<li><a href=\"" + escaped(file) + "\">" + escaped(file) + "</a></li>\n";
    }
    out += "</ul>\n";
  }
  return out + "</div>\n";
}

std::string case_block(const CaseResult& result, const std::string& suite, ReportFiles& files) {
  const bool passed = result.passed();
  std::string out = std::string("<details class=\"") + (passed ? "pass" : "fail") + (passed ? "\">" : "\" open>");
  out += std::string("<summary><h3 id=\"") + escaped(result.name) + "\">" + (passed ? "✓ " : "✕ ") +
         escaped(result.name) + "</h3><span>" + escaped(summary(result)) + "</span><span class=\"chips\">";
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) out += chip(kVerdictNames[k], result.verdicts[k].outcome);
  return out + "</span></summary>\n" + case_body(result, suite, files) + "</details>\n";
}

std::string tiles(const SuiteResult& result) {
  std::string out = "<ul class=\"tiles\">\n";
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    const auto kind = static_cast<VerdictKind>(k);
    const auto judged = static_cast<std::size_t>(std::ranges::count_if(
        result.cases, [&](const CaseResult& c) { return c.verdict(kind).outcome != Outcome::kNone; }));
    const std::size_t failed = result.failed(kind);
    std::string words = judged == 0 ? "– none yet" : "✓ " + std::to_string(judged) + " passed";
    if (failed > 0) words = "✕ " + std::to_string(failed) + " of " + std::to_string(judged) + " failed";
    out += std::string("<li>") + kVerdictNames[k] + " verdict<strong>" + words + "</strong></li>\n";
  }
  const auto caught = std::ranges::count_if(result.canaries, &CanaryResult::caught);
  out += "<li>canaries caught<strong>" + std::string(result.canaries_caught() ? "✓ " : "✕ ") + std::to_string(caught) +
         " of " + std::to_string(result.canaries.size()) + "</strong></li>\n";
  return out + "</ul>\n";
}

std::string canary_list(const SuiteResult& result) {
  std::string out = std::string("<details") + (result.canaries_caught() ? ">" : " class=\"fail\" open>") +
                    "<summary><h3>Canaries</h3><span>comparisons that must fail, made in every run</span></summary>\n"
                    "<div class=\"inside\"><div class=\"scroll\"><table><thead><tr><th>Caught</th><th>Fault made "
                    "on purpose</th><th>Finding of the judge</th></tr></thead><tbody>\n";
  for (const CanaryResult& canary : result.canaries) {
    out += std::string("<tr class=\"") + (canary.caught ? "pass" : "fail") + "\"><td class=\"mark\">" +
           (canary.caught ? "✓ caught" : "✕ not caught") + "</td><td>" + escaped(canary.name) + "</td><td>" +
           escaped(canary.message) + "</td></tr>\n";
  }
  return out + "</tbody></table></div></div></details>\n";
}

/// The worst fault in one line: the case's own problem, a metric and its excess, or the place where bits moved.
std::string worst_of(const CaseResult& result) {
  std::string text;
  const auto add = [&](const std::string& more) { text += (text.empty() ? "" : "; ") + more; };
  if (!result.problems.empty()) add(result.problems.front().substr(0, result.problems.front().find(';')));
  for (const MetricResult& metric : result.metrics) {
    if (!metric.pass) add(metric.rule.name + " " + value_text(metric.value, metric.unit) + ", " + metric.message);
  }
  if (result.difference)
    add("bits differ from step " + std::to_string(result.difference->step) + ", phase " + result.difference->phase);
  return text;
}

/// A table of the failed cases: fault, verdict, size and command.
std::string overview(const SuiteResult& result) {
  std::string rows;
  for (const CaseResult& one : result.cases) {
    if (one.passed()) continue;
    std::string failed;
    for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
      if (one.verdicts[k].outcome == Outcome::kFail) failed += chip(kVerdictNames[k], Outcome::kFail) + " ";
    }
    rows += "<tr><td><a href=\"#" + escaped(one.name) + "\">" + escaped(one.name) + "</a></td><td>" +
            (failed.empty() ? std::string("– none: the case itself is wrong") : failed) + "</td>" +
            cell("by how much", worst_of(one), false) + "<td><code tabindex=\"0\">" + escaped(one.reproduce) +
            "</code></td></tr>\n";
  }
  if (rows.empty()) return "";
  return "<h2>Failed cases at a glance</h2>\n<div class=\"scroll\"><table "
         "class=\"glance\"><thead><tr><th>Case</th><th>Failed "
         "verdicts</th><th>By how much</th><th>To reproduce</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string cases_section(const SuiteResult& result, bool passed, const char* title, ReportFiles& files) {
  std::string blocks;
  for (const CaseResult& one : result.cases) {
    if (one.passed() == passed) blocks += case_block(one, result.suite, files);
  }
  return blocks.empty() ? "" : element("h2", title) + blocks;
}

}  // namespace

std::string report_html(const SuiteResult& result, const std::filesystem::path& folder) {
  ReportFiles files(folder);
  const bool passed = result.passed();
  std::string out =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n";
  out += element("title", (passed ? "✓ " : "✕ ") + headline(result));
  out += std::string("<style>") + kReportStyle + "</style>\n</head>\n<body>\n<main>\n";
  out += std::string("<div class=\"banner ") + (passed ? "pass" : "fail") + "\" role=\"status\">";
  out += element("h1", (passed ? "✓ " : "✕ ") + headline(result));
  std::string about = "suite " + result.suite + ", " + fixed(result.seconds, 2) + " s";
  if (result.shards > 1) about += ", shard " + std::to_string(result.shard) + " of " + std::to_string(result.shards);
  out += element("p class=\"soft\"", about) + list_of(result.problems) + "</div>\n" + tiles(result) + overview(result);
  out +=
      cases_section(result, false, "Failed cases in full", files) + cases_section(result, true, "Passed cases", files);
  out += element("h2", "The check itself") + canary_list(result);
  return out + "</main>\n" + (files.is_drawn() ? script_section() : "") + "</body>\n</html>\n";
}

}  // namespace tumble::golden
