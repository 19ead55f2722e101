#include "golden/bless/from_report.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "golden/judge/case_json.h"
#include "golden/suite/temporary_folder.h"
#include "golden/suite/text_files.h"
#include "src/process/run_child.h"

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

/// The commit that the suite's clone is at; empty where git does not say.
std::string head_of(const fs::path& suite) {
  const TemporaryFolder folder("tumble-head");
  if (folder.path().empty()) return "";
  process::Program git;
  git.words = {"git", "rev-parse", "--verify", "HEAD"};
  git.folder = suite.string();
  git.out = folder.path() / "out.txt";
  git.err = folder.path() / "err.txt";
  const Result<process::ChildEnd> end = process::run_child(git);
  const Result<std::string> text = read_text(folder.path() / "out.txt");
  if (!end.ok() || !end->well() || !text.ok()) return "";
  return text->substr(0, text->find('\n'));
}

Status check_commit(const std::string& name, const Provenance& run, const fs::path& suite) {
  if (run.commit.empty() || run.tree.empty()) {
    return bad_input(name + ": does not say which commit its check ran, so nothing of it can be accepted");
  }
  if (run.tree != "clean") {
    return bad_input(name + ": its check ran commit " + run.commit + " with changed sources, wanted a clean one");
  }
  const std::string head = head_of(suite);
  if (head.empty()) {
    return bad_input(suite.string() + ": git does not say at which commit it is, wanted " + run.commit + ", that of " +
                     name);
  }
  if (head == run.commit) return {};
  return bad_input(name + ": is of commit " + run.commit + ", but " + suite.string() + " is at " + head +
                   "; check that commit out first");
}

/// 32 hexadecimal digits; zero for anything else.
Hash128 hash_from(const std::string& digits) {
  Hash128 hash;
  const char* text = digits.data();
  if (digits.size() != 32) return hash;
  std::from_chars(text, text + 16, hash.high, 16);
  std::from_chars(text + 16, text + 32, hash.low, 16);
  return hash;
}

Result<RecordedCases> read_report(const fs::path& folder, const fs::path& suite) {
  const fs::path file = folder / "report.json";
  const Result<std::string> text = read_text(file);
  if (!text.ok()) return text.error();
  const Json report = Json::parse(*text);
  const Provenance run = provenance_from(report.at("run"));
  if (Status ok = check_commit(file.string(), run, suite); !ok.ok()) return ok.error();
  RecordedCases cases;
  for (const Json& one : report.at("cases")) {
    const std::string name = one.at("name");
    std::error_code error;
    const fs::path place = folder / "cases" / name;
    if (name.find('/') != std::string::npos || !fs::exists(place / "actual.tumble", error)) continue;
    cases[name] = {place, hash_from(one.at("continuation")), one.at("final_hash"), run};
  }
  if (cases.empty())
    return bad_input(folder.string() + ": holds no session of a failed case, so there is nothing to accept");
  return cases;
}

}  // namespace

Result<RecordedCases> open_report(const fs::path& folder, const fs::path& suite) {
  try {
    return read_report(folder, suite);
  } catch (const Json::exception& error) {
    return bad_input((folder / "report.json").string() + ": is no report of a check by this version: " + error.what());
  }
}

}  // namespace tumble::golden
