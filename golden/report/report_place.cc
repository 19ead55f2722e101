#include "golden/report/report_place.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string>
#include <system_error>
#include <vector>

#include "golden/bundle/manifest.h"
#include "golden/judge/case_series.h"
#include "golden/run/run_case.h"
#include "golden/suite/text_files.h"
#include "src/base/schema_name.h"
#include "src/base/text.h"
#include "src/files/file_kind.h"
#include "src/files/output_file.h"
#include "src/files/output_guard.h"
#include "tumble/golden/suite.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCases = "cases";  // in a suite, and in a report
constexpr const char* kPage = "index.html";
constexpr const char* kJunit = "junit.xml";
constexpr const char* kFindings = "gl-code-quality-report.json";
/// Is there from the beginning of a check on, so that one that is stopped leaves a folder that the next may clear.
constexpr const char* kMark = ".tumble-report";

files::OutputGuard guard_of(const fs::path& suite) {
  files::OutputGuard guard;
  guard.keep_folder(suite / kCases, "the suite's cases");
  guard.keep(suite / kHistoryFile, "the suite's history");
  return guard;
}

files::OutputGuard guard_of_bundles(const std::vector<fs::path>& bundles) {
  files::OutputGuard guard;
  for (const fs::path& bundle : bundles) guard.keep_folder(bundle, "a shard's report");
  return guard;
}

/// Whether a canonical path is that of a folder, or lies below it.
bool is_in(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::ranges::mismatch(folder, path);
  return end == folder.end() || (std::next(end) == folder.end() && end->empty());
}

/// Whether run_case() leaves a file of that name in a report. The pictures of a golden have other names.
bool is_left_of_a_case(const std::string& name) {
  if (name == kLogFile || name == kTrackFile || name == kSeriesFile) return true;
  return name.starts_with("frame_") &&
         std::ranges::any_of(std::array{".actual.png", ".expected.png", ".difference.png"},
                             [&](const char* end) { return name.ends_with(end); });
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    entries.push_back(at->path());
  }
  return entries;
}

/// Of folder/cases/*/. A folder that a link leads to is not the report's.
std::vector<fs::path> files_of_cases(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code ignored;
  if (!fs::is_directory(fs::symlink_status(folder / kCases, ignored))) return found;
  for (const fs::path& one : entries_of(folder / kCases)) {
    if (!fs::is_directory(fs::symlink_status(one, ignored))) continue;
    for (const fs::path& file : entries_of(one)) {
      if (is_left_of_a_case(file.filename().string())) found.push_back(file);
    }
  }
  return found;
}

void remove_files_of_cases(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::path& file : files_of_cases(folder)) {
    fs::remove(file, ignored);
    fs::remove(file.parent_path(), ignored);  // once it is empty
  }
}

bool held_a_report(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder / kMark, ignored) || read_manifest(folder).ok()) return true;
  const Result<std::string> report = read_text(folder / kReportFile);
  return report.ok() && report->find('"' + schema_name("check") + '"') != std::string::npos;
}

/// A person may have files of those names.
Status check_files_of_cases(const fs::path& folder) {
  if (held_a_report(folder)) return {};
  const std::vector<fs::path> files = files_of_cases(folder);
  if (files.empty()) return {};
  return bad_input("--report: " + printable(files.front().string()) + ": exists, and " + printable(folder.string()) +
                   " holds no earlier report whose file it could be; name another folder, or remove it first");
}

void remove_earlier_report(const fs::path& folder, const fs::path& junit) {
  std::error_code ignored;
  fs::remove(folder / kBundleFile, ignored);  // first: without it the rest is no bundle
  remove_files_of_cases(folder);
  for (const fs::path& file :
       {folder / kReportFile, folder / kPage, folder / kJunit, folder / kFindings, junit_file(folder, junit)}) {
    if (fs::is_regular_file(file, ignored)) fs::remove(file, ignored);
  }
}

/// A page of somebody's own is not removed as an earlier report.
Status claim(files::OutputGuard& guard, const char* option, const fs::path& path, files::FileKind kind) {
  if (Status ok = guard.claim(option, path); !ok.ok()) return ok;
  return files::replaces_its_kind(option, path, kind);
}

/// Now, so that a folder that cannot be written costs no run of the suite.
Status make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return files::cannot_open(folder.string(), error.value());
  return ::access(folder.c_str(), W_OK) == 0 ? Status() : files::cannot_open(folder.string(), errno);
}

/// Asks for all places.
Status claim_all(files::OutputGuard& guard, const fs::path& folder, const fs::path& junit) {
  if (Status ok = guard.claim_folder("--report", folder / kCases); !ok.ok()) return ok;
  for (const char* name : {kReportFile, kPage, kFindings, kBundleFile}) {
    if (Status ok = claim(guard, "--report", folder / name, files::kind_by_name(name)); !ok.ok()) return ok;
  }
  const char* option = junit.empty() ? "--report" : "--junit";
  if (Status ok = claim(guard, option, junit_file(folder, junit), files::FileKind::kJunit); !ok.ok()) return ok;
  return check_files_of_cases(folder);
}

/// Asks for all places, makes the folder, then removes the earlier report.
Status prepare(files::OutputGuard& guard, const fs::path& folder, const fs::path& junit) {
  if (Status ok = claim_all(guard, folder, junit); !ok.ok()) return ok;
  if (Status ok = make_folder(folder); !ok.ok()) return ok;
  if (Status ok = files::write_whole_file((folder / kMark).string(), ""); !ok.ok()) return ok;
  remove_earlier_report(folder, junit);
  return {};
}

}  // namespace

fs::path junit_file(const fs::path& folder, const fs::path& junit) { return junit.empty() ? folder / kJunit : junit; }

fs::path findings_file(const fs::path& folder) { return folder / kFindings; }

Status prepare_report(const fs::path& suite, const fs::path& folder, const fs::path& junit) {
  files::OutputGuard guard = guard_of(suite);
  return prepare(guard, folder, junit);
}

Status check_merged_report(const std::vector<fs::path>& bundles, const fs::path& folder, const fs::path& junit) {
  std::error_code error;
  const fs::path place = fs::weakly_canonical(fs::absolute(folder, error), error);
  for (const fs::path& bundle : bundles) {
    const fs::path inner = fs::weakly_canonical(fs::absolute(bundle, error), error);
    if (!is_in(inner, place)) continue;
    return bad_input("--report: " + printable(folder.string()) + ": holds " + printable(bundle.string()) +
                     ", a shard's report, which this command only reads; name another folder");
  }
  files::OutputGuard guard = guard_of_bundles(bundles);
  return claim_all(guard, folder, junit);
}

Status prepare_merged_report(const std::vector<fs::path>& bundles, const fs::path& folder, const fs::path& junit) {
  files::OutputGuard guard = guard_of_bundles(bundles);
  return prepare(guard, folder, junit);
}

}  // namespace tumble::golden
