#include "golden/report/report_place.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "golden/suite/suite.h"
#include "golden/suite/text_files.h"
#include "src/files/output_guard.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCases = "cases";  // in a suite, and in a report
constexpr const char* kJson = "report.json";
constexpr const char* kPage = "index.html";
constexpr const char* kJunit = "junit.xml";

files::OutputGuard guard_of(const fs::path& suite) {
  files::OutputGuard guard;
  guard.keep_folder(suite / kCases, "the suite's cases");
  guard.keep(suite / kHistoryFile, "the suite's history");
  return guard;
}

/// "cases/NAME/FILE" and nothing that leads elsewhere: a report may come from another machine.
bool is_in_cases(const fs::path& artifact) {
  return artifact.is_relative() && *artifact.begin() == kCases &&
         std::ranges::none_of(artifact, [](const fs::path& part) { return part == ".."; });
}

std::vector<fs::path> files_of_earlier_report(const fs::path& folder) {
  std::vector<fs::path> files;
  const Result<std::string> text = read_text(folder / kJson);
  const nlohmann::json old = nlohmann::json::parse(text.ok() ? *text : "", nullptr, false);
  if (!old.is_object() || !old.contains(kCases) || !old[kCases].is_array()) return files;
  for (const nlohmann::json& one : old[kCases]) {
    if (!one.is_object() || !one.contains("artifacts") || !one["artifacts"].is_array()) continue;
    for (const nlohmann::json& artifact : one["artifacts"]) {
      if (artifact.is_string() && is_in_cases(artifact.get<std::string>())) {
        files.push_back(folder / artifact.get<std::string>());
      }
    }
  }
  return files;
}

void remove_earlier_report(const fs::path& folder, const fs::path& junit) {
  std::error_code ignored;
  for (const fs::path& file : files_of_earlier_report(folder)) {
    fs::remove(file, ignored);
    fs::remove(file.parent_path(), ignored);  // once it is empty
  }
  for (const fs::path& file : {folder / kJson, folder / kPage, folder / kJunit, junit_file(folder, junit)}) {
    if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);
  }
}

}  // namespace

fs::path junit_file(const fs::path& folder, const fs::path& junit) { return junit.empty() ? folder / kJunit : junit; }

Status prepare_report(const fs::path& suite, const fs::path& folder, const fs::path& junit) {
  files::OutputGuard guard = guard_of(suite);
  if (Status ok = guard.claim_folder("--report", folder / kCases); !ok.ok()) return ok;
  for (const char* name : {kJson, kPage}) {
    if (Status ok = guard.claim("--report", folder / name); !ok.ok()) return ok;
  }
  const char* option = junit.empty() ? "--report" : "--junit";
  if (Status ok = guard.claim(option, junit_file(folder, junit)); !ok.ok()) return ok;
  remove_earlier_report(folder, junit);
  return {};
}

}  // namespace tumble::golden
