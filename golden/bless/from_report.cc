#include "golden/bless/from_report.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "golden/judge/case_json.h"
#include "golden/run/run_case.h"
#include "golden/suite/text_files.h"
#include "src/base/parse_hash.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

std::string built_at(const Provenance& program) {
  if (program.commit.empty()) return "does not know its commit";
  return "was built at " + program.commit + (program.tree == "clean" ? "" : " with changed sources");
}

/// The sessions are measured by this program, so it must be the one that ran them.
Status check_commit(const std::string& name, const Provenance& run) {
  if (run.commit.empty() || run.tree.empty()) {
    return bad_input(name + ": does not say which commit its check ran, so nothing of it can be accepted");
  }
  if (run.tree != "clean") {
    return bad_input(name + ": its check ran commit " + run.commit + " with changed sources, wanted a clean one");
  }
  const Provenance here = this_program();
  if (here.commit == run.commit && here.tree == "clean") return {};
  return bad_input(name + ": is of commit " + run.commit + ", but this program " + built_at(here) +
                   "; build that commit first, without changes");
}

Result<RecordedCase> recorded_case(const std::string& name, const Json& json, const fs::path& folder, Provenance run) {
  Result<CaseResult> result = case_from_json(json.dump());
  if (!result.ok()) return bad_input(name + ": " + result.error().message);
  const std::optional<Hash128> continuation = parse_hash(result->continuation);
  if (!continuation) {
    return bad_input(name + ": case " + result->name +
                     ": continuation: " + found_wanted(in_quotes(result->continuation), "32 hexadecimal digits"));
  }
  run.seconds = result->seconds;
  return RecordedCase{folder, *continuation, result->final_hash, std::move(result->pictures), std::move(run)};
}

Result<RecordedCases> read_report(const fs::path& folder) {
  const fs::path file = folder / "report.json";
  const Result<std::string> text = read_text(file);
  if (!text.ok()) return text.error();
  const Json report = Json::parse(*text);
  const Provenance run = provenance_from(report.at("run"));
  if (Status ok = check_commit(file.string(), run); !ok.ok()) return ok.error();
  RecordedCases cases;
  for (const Json& one : report.at("cases")) {
    const std::string name = one.at("name");
    std::error_code error;
    const fs::path place = folder / "cases" / name;
    if (name.find('/') != std::string::npos || !fs::exists(place / kLogFile, error)) continue;
    Result<RecordedCase> recorded = recorded_case(file.string(), one, place, run);
    if (!recorded.ok()) return recorded.error();
    cases[name] = *std::move(recorded);
  }
  if (cases.empty())
    return bad_input(folder.string() + ": holds no session of a failed case, so there is nothing to accept");
  return cases;
}

}  // namespace

Result<RecordedCases> open_report(const fs::path& folder) {
  try {
    return read_report(folder);
  } catch (const Json::exception& error) {
    return bad_input((folder / "report.json").string() + ": is no report of a check by this version: " + error.what());
  }
}

}  // namespace tumble::golden
