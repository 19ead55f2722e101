#include "golden/report/junit.h"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "src/base/text.h"

namespace tumble::golden {
namespace {

/// XML has no way to write control characters.
std::string xml_text(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 && c != '\n' && c != '\t'; }, '?');
  return text;
}

std::string failure_text(const CaseResult& result) {
  std::string text;
  for (const std::string& problem : result.problems) text += "problem: " + problem + '\n';
  for (std::size_t k = 0; k < kVerdictNames.size(); ++k) {
    if (!result.verdicts[k].message.empty())
      text += std::string(kVerdictNames[k]) + ": " + result.verdicts[k].message + '\n';
  }
  for (const MetricResult& metric : result.metrics) {
    if (!metric.pass) text += metric.rule.name + ": " + metric.message + " (" + metric.rule.why + ")\n";
  }
  if (result.difference) {
    for (const std::string& detail : result.difference->details) text += detail + '\n';
  }
  if (!result.reproduce.empty()) text += "reproduce: " + result.reproduce + '\n';
  if (!result.bless.empty()) text += "bless: " + result.bless + '\n';
  return xml_text(text);
}

void add_case(pugi::xml_node suite, const std::string& group, const std::string& name, double seconds,
              const std::string& failure, const std::string& text) {
  pugi::xml_node node = suite.append_child("testcase");
  node.append_attribute("classname") = group.c_str();
  node.append_attribute("name") = xml_text(name).c_str();
  node.append_attribute("time") = fixed(seconds, 3).c_str();
  if (failure.empty()) return;
  pugi::xml_node child = node.append_child("failure");
  child.append_attribute("message") = xml_text(failure).c_str();
  child.text().set(text.c_str());
}

}  // namespace

std::string report_junit(const SuiteResult& result) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
  suite.append_attribute("name") = "tumble";
  const auto missed = static_cast<std::size_t>(
      std::ranges::count_if(result.canaries, [](const CanaryResult& canary) { return !canary.caught; }));
  const std::size_t extra = result.problems.empty() ? 1 : 2;  // the canaries, and what is wrong with the suite itself
  suite.append_attribute("tests") = result.cases.size() + extra;
  suite.append_attribute("failures") =
      result.failed_cases() + (result.canaries_caught() ? 0U : 1U) + (result.problems.empty() ? 0U : 1U);
  suite.append_attribute("time") = fixed(result.seconds, 3).c_str();
  for (const CaseResult& one : result.cases) {
    const std::string group = "tumble." + (one.category.empty() ? "unknown" : one.category);
    add_case(suite, group, one.name, one.seconds, one.passed() ? "" : summary(one), failure_text(one));
  }
  std::string words;
  for (const CanaryResult& canary : result.canaries) {
    if (!canary.caught) words += canary.name + ": " + canary.message + '\n';
  }
  const std::string failure = result.canaries_caught() ? "" : std::to_string(missed) + " canaries were not caught";
  add_case(suite, "tumble.canaries", "comparisons that must fail", 0, failure, xml_text(words));
  if (!result.problems.empty()) {
    std::string text;
    for (const std::string& problem : result.problems) text += problem + '\n';
    add_case(suite, "tumble.suite", "the suite itself", 0, result.problems.front(), xml_text(text));
  }
  std::ostringstream out;
  document.save(out, "  ");
  return out.str();
}

}  // namespace tumble::golden
