#include "tools/output/check_output.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "golden/judge/across_cases.h"
#include "tools/output/text.h"
#include "tumble/golden/change.h"
#include "tumble/golden/report.h"

namespace tumble::tools {
namespace {

constexpr std::size_t kNameColumns = 24;
constexpr const char* kIndent = "    ";

std::string bound_text(const golden::MetricRule& rule, const std::string& unit) {
  std::string text;
  if (rule.min) text += "at least " + rounded(*rule.min, unit);
  if (rule.max) text += (text.empty() ? "" : ", ") + ("at most " + rounded(*rule.max, unit));
  return text;
}

// Text of several lines, as an engine prints it, goes on below.
void print_line(std::string label, const std::string& text) {
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (at == 0 || end > at) std::cout << kIndent << padded(label, 11) << printable(text.substr(at, end - at)) << '\n';
    label.clear();
    at = end + 1;
  }
}

void print_failure(const golden::CaseResult& result) {
  for (const std::string& problem : result.problems) print_line("problem", problem);
  for (std::size_t k = 0; k < golden::kVerdictNames.size(); ++k) {
    if (!result.verdicts[k].message.empty()) print_line(golden::kVerdictNames[k], result.verdicts[k].message);
  }
  for (const golden::MetricResult& metric : result.metrics) {
    if (metric.pass) continue;
    const std::string value = golden::value_text(metric.value, metric.unit);
    print_line("  metric", metric.rule.name + " " + value + ", wanted " + bound_text(metric.rule, metric.unit) + ": " +
                               metric.message);
    print_line("", "why: " + metric.rule.why);
  }
  if (result.difference) {
    for (const std::string& detail : result.difference->details) print_line("", detail);
  }
  for (const std::string& note : result.notes) print_line("note", note);
  if (!result.reproduce.empty()) print_line("reproduce", result.reproduce);
  if (!result.bless.empty()) print_line("bless", result.bless);
  if (!result.bless_refused.empty()) print_line("no bless", "bless would refuse it: " + result.bless_refused);
}

}  // namespace

void print_case(const golden::CaseResult& result) {
  std::cout << (result.passed() ? "passed  " : "FAILED  ") << padded(printable(result.name), kNameColumns) << ' '
            << padded(printable(golden::summary(result)), 34) << ' ' << seconds_text(result.seconds) << '\n';
  if (!result.passed()) print_failure(result);
}

void print_sum(const golden::SuiteResult& result, const std::string& suite, const std::string& report) {
  for (const std::string& problem : result.problems) std::cout << "FAILED  " << printable(problem) << '\n';
  for (const std::string& sentence : golden::across_cases(result.cases))
    std::cout << "across  " << printable(sentence) << '\n';
  if (const std::string sentence = golden::gone_on_across(result.cases); !sentence.empty())
    std::cout << "heavy   " << printable(sentence) << '\n';
  for (const golden::CanaryResult& canary : result.canaries) {
    if (canary.missed()) {
      std::cout << "CANARY NOT CAUGHT: " << canary.name << ": " << printable(canary.message) << '\n';
    }
  }
  std::cout << '\n'
            << printable(golden::headline(result)) << "  (" << seconds_text(result.seconds) << "; "
            << result.canaries_text();
  if (result.shards > 1) std::cout << "; shard " << result.shard << " of " << result.shards;
  std::cout << ")\nsuite:  " << printable(suite) << '\n';
  if (!report.empty()) std::cout << "report: " << report << "/index.html\n";
}

void print_blessings(const golden::BlessReport& report, bool dry_run) {
  for (const golden::Blessing& blessing : report.blessed) {
    std::cout << (dry_run ? "would bless  " : "blessed  ") << padded(printable(blessing.name), kNameColumns) << ' '
              << printable(blessing.bits) << '\n';
    for (const std::string& detail : blessing.details) print_line("", detail);
    for (const golden::MetricResult& metric : blessing.metrics) {
      if (!golden::has_moved(metric)) continue;
      const std::string bound = bound_text(metric.rule, metric.unit);  // a new case has its bounds in its metrics.toml
      print_line("  metric", golden::movement_text(metric) + (bound.empty() ? "" : " (" + bound + ")"));
    }
  }
  if (report.blessed.empty()) std::cout << "nothing to bless: bits and values are those of the goldens\n";
}

golden::Json blessings_json(const golden::BlessReport& report, bool dry_run) {
  golden::Json json = {{"dry_run", dry_run}, {"unchanged", report.unchanged}, {"blessed", golden::Json::array()}};
  for (const golden::Blessing& blessing : report.blessed) {
    golden::Json metrics = golden::Json::array();
    for (const golden::MetricResult& metric : blessing.metrics) {
      const auto number = [](const std::optional<double>& v) { return v ? golden::Json(*v) : golden::Json(nullptr); };
      metrics.push_back(
          {{"name", metric.rule.name}, {"before", number(metric.rule.value)}, {"after", number(metric.value)}});
    }
    json["blessed"].push_back({{"name", blessing.name},
                               {"new", blessing.is_new},
                               {"bits", blessing.bits},
                               {"details", blessing.details},
                               {"metrics", metrics}});
  }
  return json;
}

}  // namespace tumble::tools
