#include "golden/report/annotations.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>
#include <system_error>

#include "golden/report/html_text.h"
#include "src/base/text.h"
#include "tumble/golden/change.h"
#include "tumble/golden/suite.h"
#include "tumble/sim/hash.h"

namespace tumble::golden {
namespace {

/// Text as one line of characters that show.
std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : clean_text(std::string(text))) line += c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
  return line;
}

std::string message_of(const CaseResult& result) {
  std::string text = summary(result);
  if (result.difference) {
    text += "; first difference: " + describe(*result.difference);
    const std::vector<std::string>& details = result.difference->details;
    const std::size_t shown = result.difference->apart ? 1 : 0;  // the distance comes first there, and in the summary
    if (result.difference->phase != kSetup && shown < details.size()) text += "; " + details[shown];
  }
  for (const MetricResult& metric : result.metrics) {
    if (!metric.pass) text += "; " + metric.rule.name + ": " + metric.message;
  }
  return one_line(text);
}

/// The file to look at in a case's folder: its scene, or its rules where another engine has the scene.
std::string file_of(const SuiteResult& result, const std::string& name, const std::string& checkout) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path folder = fs::path(result.suite) / "cases" / name;
  const fs::path file = folder / (fs::exists(folder / kSceneFile, error) ? kSceneFile : kRulesFile);
  for (const fs::path& base : {fs::path(checkout), fs::current_path(error)}) {
    if (base.empty()) continue;
    const fs::path below = fs::relative(file, base, error);
    if (!error && !below.empty() && *below.begin() != "..") return below.generic_string();
  }
  return file.string();
}

/// In a workflow command '%', line ends and, in a property, ':' and ',' are escaped.
std::string escaped(std::string_view text, bool property) {
  std::string out;
  for (const char c : text) {
    if (c == '%') {
      out += "%25";
    } else if (property && c == ':') {
      out += "%3A";
    } else if (property && c == ',') {
      out += "%2C";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace

std::vector<Annotation> annotations(const SuiteResult& result, const std::string& checkout) {
  std::vector<Annotation> out;
  for (const CanaryResult& canary : result.canaries) {
    if (!canary.missed()) continue;
    out.push_back({"comparisons of known outcome", one_line("not caught: " + canary.name + ": " + canary.message), {}});
  }
  for (const std::string& problem : result.problems) out.push_back({"the suite itself", one_line(problem), {}});
  for (const CaseResult& one : result.cases) {
    if (!one.passed()) out.push_back({one_line(one.name), message_of(one), file_of(result, one.name, checkout)});
  }
  return out;
}

std::string github_commands(const std::vector<Annotation>& failures) {
  std::string out;
  for (const Annotation& one : failures) {
    out += "::error ";
    if (!one.file.empty()) out += "file=" + escaped(one.file, true) + ",line=1,";
    out += "title=" + escaped(one.title, true) + "::" + escaped(one.title + ": " + one.message, false) + '\n';
  }
  return out;
}

Json gitlab_findings(const std::vector<Annotation>& failures) {
  Json out = Json::array();
  for (const Annotation& one : failures) {
    const std::string text = one.title + ": " + one.message;
    out.push_back({{"description", text},
                   {"check_name", "tumble check"},
                   {"fingerprint", to_string(hash_bytes(std::as_bytes(std::span(text))))},
                   {"severity", "major"},
                   {"location", {{"path", one.file.empty() ? "golden" : one.file}, {"lines", {{"begin", 1}}}}}});
  }
  return out;
}

}  // namespace tumble::golden
