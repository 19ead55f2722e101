// The report page takes no text of a case for markup, wherever the text stands: names, titles, reasons, engines.
#include <gtest/gtest.h>

#include <pugixml.hpp>
#include <regex>
#include <vector>

#include "golden/report/html.h"
#include "golden/report/html_text.h"
#include "golden/report/junit.h"
#include "golden/suite/text_files.h"
#include "tests/support/golden_suite.h"
#include "tumble/golden/report.h"

namespace tumble::golden {
namespace {

const std::vector<std::string> kHostile = {
    "</script><script>hacked(1)</script>",
    "\"><img src=x onerror=hacked(2)>",
    "' onmouseover='hacked(3)",
    "<b>&amp;</b>javascript:hacked(4)",
    "]]><!-- \x1b[31mred\x07 \xff\xfe \302\23331m \xe2\x80\xae",
};

/// A check in which every text is hostile.
SuiteResult hostile_result(const std::string& text) {
  SuiteResult suite;
  suite.suite = text;
  suite.problems = {text};
  suite.canaries = {{text, false, text, text}};
  CaseResult& one = suite.cases.emplace_back();
  one.name = one.title = one.category = one.final_hash = one.reproduce = one.bless = one.bless_refused = text;
  one.require = {VerdictKind::kExact};
  for (Verdict& verdict : one.verdicts) verdict = {Outcome::kFail, text};
  one.problems = one.notes = {text, "stale: " + text};
  MetricResult metric;
  metric.rule.name = metric.rule.why = metric.rule.bodies = metric.rule.axis = metric.unit = metric.message = text;
  metric.value = 1;
  one.metrics = {metric};
  PictureResult picture;
  picture.rule.why = picture.message = text;
  picture.pixels = 3;
  one.pictures = {picture};
  one.difference = FirstDifference{
      .step = 1, .substep = {}, .phase = text, .states_from = 1, .details = {text}, .apart = Apart{1.5, 1, 7}};
  for (const char* name : {"series.json", "frame_0000.actual.png", "frame_0000.expected.png"}) {
    one.artifacts.push_back("cases/" + text + "/" + name);
  }
  suite.cases.push_back(one);  // two cases with one phase: the line across cases names the phase
  return suite;
}

/// The page without its script, whose own text may look like anything, and without its style.
std::string without_script(std::string page) {
  for (const char* tag : {"script", "style"}) {
    const std::string begin = std::string("<") + tag + ">", end = std::string("</") + tag + ">";
    const std::size_t at = page.find(begin);
    if (at != std::string::npos) page.erase(at, page.find(end, at) + end.size() - at);
  }
  return page;
}

class HostilePage : public testing::TestWithParam<std::string> {};

TEST_P(HostilePage, HasNoElementAndNoAttributeThatAPageOfPlainTextLacks) {
  const TemporarySuite suite;
  const auto shape_of = [&](const std::string& text) {
    const std::string page = without_script(report_html(hostile_result(text), suite.root()));
    // What a browser makes elements and attributes of: tags with the names of their attributes.
    static const std::regex kTag("<[^>]*>"), kValue("=\"[^\"]*\"");
    std::string shape;
    for (std::sregex_iterator at(page.begin(), page.end(), kTag), end; at != end; ++at) {
      shape += std::regex_replace(at->str(), kValue, "=") + '\n';
    }
    return shape;
  };
  EXPECT_EQ(shape_of(GetParam()), shape_of("plain"));
  const std::string page = without_script(report_html(hostile_result(GetParam()), suite.root()));
  EXPECT_EQ(page.find("<script>hacked"), std::string::npos);
  for (const char c : page) {
    EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') << static_cast<int>(c);
  }
}

TEST_P(HostilePage, JunitStaysXml) {
  pugi::xml_document document;
  const std::string xml = report_junit(hostile_result(GetParam()));
  ASSERT_TRUE(document.load_string(xml.c_str())) << xml;
  const pugi::xml_node suite = document.child("testsuites").child("testsuite");
  const auto cases = suite.children("testcase");
  EXPECT_EQ(std::distance(cases.begin(), cases.end()), suite.attribute("tests").as_int());
  EXPECT_EQ(clean_text(xml), xml) << "control characters, or bytes that are no UTF-8";
}

INSTANTIATE_TEST_SUITE_P(Texts, HostilePage, testing::ValuesIn(kHostile));

TEST(ReportPolicy, ForbidsHandlersAndEveryScriptButThePagesOwn) {
  const TemporarySuite suite;
  const std::string page = report_html(hostile_result("plain"), suite.root());
  static const std::regex kPolicy("Content-Security-Policy\" content=\"([^\"]*)\"");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(page, found, kPolicy));
  const std::string policy = found[1];
  EXPECT_NE(policy.find("default-src 'none'"), std::string::npos) << policy;
  EXPECT_NE(policy.find("script-src 'sha256-"), std::string::npos) << policy;
  EXPECT_EQ(policy.find("script-src 'unsafe"), std::string::npos) << policy;
  EXPECT_LT(page.find("Content-Security-Policy"), page.find("<title>")) << "before any text of a case";
  SuiteResult passed;
  passed.canaries = {{"seen", true, "", "suite"}};
  EXPECT_NE(report_html(passed, suite.root()).find("script-src 'none'"), std::string::npos);
}

TEST(CleanText, KeepsWhatIsShownAndNothingElse) {
  EXPECT_EQ(clean_text("15 → 14, ≤ 2 µm\t\n"), "15 → 14, ≤ 2 µm\t\n");
  EXPECT_EQ(clean_text("a\x1b[2Jb"), "a\xEF\xBF\xBD[2Jb");
  EXPECT_EQ(clean_text("\xC0\xAF|\xED\xA0\x80|\xF4\x90\x80\x80|\xE2\x82").find('\xC0'), std::string::npos);
  EXPECT_EQ(clean_text(clean_text("\xff\xfe\xe2\x80\xae")), clean_text("\xff\xfe\xe2\x80\xae"));
}

}  // namespace
}  // namespace tumble::golden
