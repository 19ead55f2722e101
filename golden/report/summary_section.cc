#include "golden/report/summary_section.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "golden/judge/across_cases.h"
#include "golden/report/commands.h"
#include "golden/report/html_parts.h"
#include "src/base/text.h"
#include "tumble/golden/change.h"

namespace tumble::golden {
namespace {

/// How far the bodies went, m: what the overview is sorted by. A place that is no number is further than any.
double distance_of(const CaseResult& result) {
  if (!result.difference || !result.difference->apart) return 0;
  const double metres = result.difference->apart->metres;
  return std::isfinite(metres) ? metres : std::numeric_limits<double>::max();
}

std::string first_difference_of(const CaseResult& result) {
  if (!result.difference) return "–";
  const std::string& phase = result.difference->phase;
  if (phase == kSetup) return "told otherwise";
  if (!result.difference->told.empty()) return result.difference->told;
  const bool is_extra = phase.starts_with("channel.") || phase == "contacts";
  return "step " + std::to_string(result.difference->step) + (is_extra ? ", " : ", phase ") + phase;
}

Html verdict_cell(const CaseResult& one) {
  Html out("<td>");
  out << text(mark_of(one.passed())) << text(one.passed() ? to_string(change_of(one)) : "failed") << "<br>";
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    if (one.verdicts[k].outcome == Outcome::kFail) out << chip(kVerdictNames[k], Outcome::kFail) << " ";
  }
  return out << "</td>";
}

Html overview_row(const CaseResult& one) {
  Html out("<tr data-verdict=\"");
  out << text(one.passed() ? key_of(change_of(one)) : "failed") << "\" data-category=\"" << text(one.category)
      << "\" data-magnitude=\"" << text(exact(distance_of(one))) << "\" data-name=\"" << text(one.name)
      << "\"><td><a href=\"#" << path(one.name) << "\">" << text(one.name) << "</a></td>" << verdict_cell(one)
      << cell("by how much", summary(one)) << cell("first difference", first_difference_of(one))
      << cell("category", one.category) << "<td><code tabindex=\"0\">" << text(one.reproduce) << "</code></td></tr>\n";
  return out;
}

Html tile(std::string_view name, std::string_view words) {
  return Html("<li>") << text(name) << "<strong>" << text(words) << "</strong></li>\n";
}

}  // namespace

Html banner(const SuiteResult& result) {
  const Outcome outcome = result.is_empty_shard() ? Outcome::kNone : result.passed() ? Outcome::kPass : Outcome::kFail;
  std::string about = "suite " + result.suite + ", " + fixed(result.seconds, 2) + " s";
  if (result.shards > 1) about += ", shard " + std::to_string(result.shard) + " of " + std::to_string(result.shards);
  Html out("<div class=\"banner ");
  out << text(class_of(outcome)) << "\" role=\"status\">" << element("<h1>", title_of(result), "</h1>\n")
      << list_of(across_cases(result.cases)) << element("<p class=\"soft\">", about, "</p>\n")
      << element("<p class=\"soft\">", "this run: " + describe(result.run), "</p>\n")
      << element("<p class=\"soft\">", "commands work from the folder " + current_folder(), "</p>\n")
      << list_of(result.problems) << "</div>\n";
  return out;
}

std::string title_of(const SuiteResult& result) {
  const std::string mark = result.is_empty_shard() ? "– " : mark_of(result.passed());
  return mark + headline(result);
}

Html tiles(const SuiteResult& result) {
  Html out("<ul class=\"tiles\">\n");
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    const auto kind = static_cast<VerdictKind>(k);
    const auto judged = static_cast<std::size_t>(std::ranges::count_if(
        result.cases, [&](const CaseResult& c) { return c.verdict(kind).outcome != Outcome::kNone; }));
    const auto failed = static_cast<std::size_t>(std::ranges::count_if(
        result.cases, [&](const CaseResult& c) { return c.verdict(kind).outcome == Outcome::kFail; }));
    std::string words = judged == 0 ? "– none yet" : "✓ " + std::to_string(judged) + " passed";
    if (failed > 0) words = "✕ " + std::to_string(failed) + " of " + std::to_string(judged) + " failed";
    out << tile(std::string(kVerdictNames[k]) + " verdict", words);
  }
  for (const Change change : {Change::kNone, Change::kWithinBounds}) {
    out << tile(to_string(change), std::to_string(result.with(change)) + " of " + std::to_string(result.cases.size()));
  }
  const auto caught = std::ranges::count_if(result.canaries, &CanaryResult::caught);
  const auto asked = std::ranges::count_if(result.canaries, &CanaryResult::asked);
  const std::string mark = result.canaries.empty() && result.shards > 1 ? "– " : mark_of(result.canaries_caught());
  out << tile("canaries caught", mark + std::to_string(caught) + " of " + std::to_string(asked));
  return out << "</ul>\n";
}

Html overview(const SuiteResult& result) {
  std::vector<const CaseResult*> rows;
  for (const CaseResult& one : result.cases) {
    if (!one.passed() || change_of(one) != Change::kNone) rows.push_back(&one);
  }
  if (rows.empty()) return {};
  std::ranges::stable_sort(rows, [](const CaseResult* a, const CaseResult* b) {
    if (a->passed() != b->passed()) return b->passed();
    return distance_of(*a) > distance_of(*b);
  });
  Html out(
      "<h2>Failed and moved cases at a glance</h2>\n<div class=\"scroll\"><table class=\"glance\"><thead><tr>"
      "<th data-sort=\"name\">Case</th><th data-sort=\"verdict\">Verdict</th><th data-sort=\"magnitude\">By how "
      "much</th><th>First difference</th><th data-sort=\"category\">Category</th><th>To "
      "reproduce</th></tr></thead><tbody>\n");
  for (const CaseResult* one : rows) out << overview_row(*one);
  return out << "</tbody></table></div>\n";
}

Html canary_list(const SuiteResult& result) {
  Html out("<details");
  if (!result.canaries_caught()) out << " class=\"fail\" open";
  out << "><summary><h3>Canaries</h3><span>comparisons of known outcome, each made once in every "
         "check</span></summary>\n"
         "<div class=\"inside\"><div class=\"scroll\"><table><thead><tr><th>Caught</th><th>Fault made on "
         "purpose</th><th>Finding of the judge</th></tr></thead><tbody>\n";
  for (const CanaryResult& canary : result.canaries) {
    out << "<tr class=\""
        << text(class_of(canary.caught  ? Outcome::kPass
                         : canary.asked ? Outcome::kFail
                                        : Outcome::kNone))
        << "\"><td class=\"mark\">"
        << text(canary.caught  ? "✓ caught"
                : canary.asked ? "✕ not caught"
                               : "– not asked")
        << "</td><td>" << text(canary.name) << "</td><td>" << text(canary.message) << "</td></tr>\n";
  }
  return out << "</tbody></table></div></div></details>\n";
}

}  // namespace tumble::golden
