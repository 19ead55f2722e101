#include "golden/report/junit.h"

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "golden/report/html_text.h"
#include "src/base/text.h"
#include "tumble/golden/change.h"

namespace tumble::golden {
namespace {

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
  if (!result.bless_refused.empty()) text += "bless would refuse it: " + result.bless_refused + '\n';
  return text;
}

/// One <testcase>. failure, skipped: the reason, if it failed or judged nothing; text: the details of the failure;
/// said: what a reader of a case that passed should know.
struct TestCase {
  std::string group;
  std::string name;
  double seconds = 0;
  std::string failure;
  std::string text;
  std::string skipped;
  std::string said;
};

void add_case(pugi::xml_node suite, const TestCase& one) {
  pugi::xml_node node = suite.append_child("testcase");
  node.append_attribute("classname") = clean_text(one.group).c_str();
  node.append_attribute("name") = clean_text(one.name).c_str();
  node.append_attribute("time") = fixed(one.seconds, 3).c_str();
  if (!one.skipped.empty()) node.append_child("skipped").append_attribute("message") = clean_text(one.skipped).c_str();
  if (!one.failure.empty()) {
    pugi::xml_node child = node.append_child("failure");
    child.append_attribute("message") = clean_text(one.failure).c_str();
    child.text().set(clean_text(one.text).c_str());
  }
  if (!one.said.empty()) node.append_child("system-out").text().set(clean_text(one.said).c_str());
}

TestCase test_case(const CaseResult& result) {
  TestCase one{.group = "tumble." + (result.category.empty() ? "unknown" : result.category),
               .name = result.name,
               .seconds = result.seconds,
               .failure = {},
               .text = {},
               .skipped = {},
               .said = {}};
  if (!result.passed()) {
    one.failure = summary(result);
    one.text = failure_text(result);
  } else if (change_of(result) != Change::kNone) {
    one.said = std::string(to_string(change_of(result))) + ": " + summary(result);
  }
  return one;
}

TestCase canary_case(const SuiteResult& result) {
  TestCase one{.group = "tumble.canaries",
               .name = "comparisons of known outcome",
               .seconds = 0,
               .failure = {},
               .text = {},
               .skipped = {},
               .said = {}};
  std::size_t missed = 0;
  for (const CanaryResult& canary : result.canaries) {
    if (!canary.missed()) continue;
    ++missed;
    one.text += canary.name + ": " + canary.message + '\n';
  }
  if (result.canaries.empty() && result.shards > 1) one.skipped = "no canary fell to this shard";
  if (!result.canaries_caught()) one.failure = std::to_string(missed) + " canaries were not caught";
  return one;
}

/// What is wrong with the suite, or that this shard of it has no case.
TestCase suite_case(const SuiteResult& result) {
  TestCase one{.group = "tumble.suite",
               .name = "the suite itself",
               .seconds = 0,
               .failure = {},
               .text = {},
               .skipped = {},
               .said = {}};
  for (const std::string& problem : result.problems) one.text += problem + '\n';
  if (!result.problems.empty()) one.failure = result.problems.front();
  if (result.is_empty_shard()) one.skipped = headline(result);
  return one;
}

/// Where this run comes from, and where the golden of each case does.
void add_properties(pugi::xml_node suite, const SuiteResult& result) {
  pugi::xml_node properties = suite.append_child("properties");
  const auto add = [&](const std::string& name, const std::string& value) {
    pugi::xml_node property = properties.append_child("property");
    property.append_attribute("name") = clean_text(name).c_str();
    property.append_attribute("value") = clean_text(value).c_str();
  };
  add("run", describe(result.run));
  for (const CaseResult& one : result.cases) {
    if (one.blessed_by) add("blessed " + one.name, describe(*one.blessed_by));
  }
}

}  // namespace

std::string report_junit(const SuiteResult& result) {
  pugi::xml_document document;
  pugi::xml_node declaration = document.append_child(pugi::node_declaration);
  declaration.append_attribute("version") = "1.0";
  declaration.append_attribute("encoding") = "UTF-8";
  std::vector<TestCase> cases;
  for (const CaseResult& one : result.cases) cases.push_back(test_case(one));
  cases.push_back(canary_case(result));
  if (!result.problems.empty() || result.is_empty_shard()) cases.push_back(suite_case(result));
  pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
  suite.append_attribute("name") = "tumble";
  suite.append_attribute("tests") = cases.size();
  suite.append_attribute("failures") =
      std::ranges::count_if(cases, [](const TestCase& one) { return !one.failure.empty(); });
  suite.append_attribute("skipped") =
      std::ranges::count_if(cases, [](const TestCase& one) { return !one.skipped.empty(); });
  suite.append_attribute("time") = fixed(result.seconds, 3).c_str();
  add_properties(suite, result);
  for (const TestCase& one : cases) add_case(suite, one);
  std::ostringstream out;
  document.save(out, "  ");
  return out.str();
}

}  // namespace tumble::golden
