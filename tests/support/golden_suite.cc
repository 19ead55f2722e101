#include "tests/support/golden_suite.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "golden/suite/text_files.h"
#include "tumble/golden/bless.h"

namespace tumble::golden {

TemporarySuite::TemporarySuite() {
  std::string pattern = testing::TempDir() + "tumble-suite-XXXXXX";
  if (::mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder " + pattern);
  root_ = pattern;
}

TemporarySuite::~TemporarySuite() {
  std::error_code ignored;
  std::filesystem::remove_all(root_, ignored);
}

void TemporarySuite::add(const std::string& name, const std::string& scene, const std::string& rules) const {
  write(file(name, kSceneFile), scene);
  write(file(name, kRulesFile), rules);
}

void TemporarySuite::bless() const {
  const Result<BlessReport> report = bless_cases({root_, {}, "a test", false, {}});
  ASSERT_TRUE(report.ok()) << report.error().message;
}

void TemporarySuite::write(const std::filesystem::path& path, const std::string& content) const {
  const Status ok = write_file(path, std::string_view(content));
  ASSERT_TRUE(ok.ok()) << ok.error().message;
}

std::string TemporarySuite::read(const std::filesystem::path& path) const {
  const Result<std::string> text = read_text(path);
  EXPECT_TRUE(text.ok()) << path;
  return text.ok() ? *text : "";
}

void TemporarySuite::edit(const std::string& name, const std::string& which, const std::string& what,
                          const std::string& with) const {
  std::string text = read(file(name, which));
  const std::size_t at = text.find(what);
  ASSERT_NE(at, std::string::npos) << what << " is not in\n" << text;
  write(file(name, which), text.replace(at, what.size(), with));
}

SuiteResult TemporarySuite::check(const std::string& name) const {
  CheckOptions options;
  options.suite = root_;
  if (!name.empty()) options.selection.names = {name};
  options.report = root_ / "report";
  const Result<SuiteResult> result = check_suite(options);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().message);
  return result.ok() ? *result : SuiteResult();
}

CaseResult TemporarySuite::check_one(const std::string& name) const {
  const SuiteResult result = check(name);
  EXPECT_EQ(result.cases.size(), 1U);
  return result.cases.empty() ? CaseResult() : result.cases.front();
}

}  // namespace tumble::golden
