#include "golden/report/commands.h"

#include <filesystem>
#include <system_error>

#include "golden/run/external_engine.h"

namespace tumble::golden {
namespace {

// Bisection works on a clone's own suite alone: each revision judges the case with its own program, scene and golden.
std::string bisect_command(const CaseResult& result, const std::string& suite) {
  if (suite != "golden") return "";
  bool is_only_image = result.problems.empty() && result.verdict(VerdictKind::kImage).outcome == Outcome::kFail;
  for (const VerdictKind kind : {VerdictKind::kExact, VerdictKind::kBehaviour}) {
    is_only_image = is_only_image && result.verdict(kind).outcome != Outcome::kFail;
  }
  return "tumble bisect --good REV --bad HEAD --case " + shell_quoted(result.name) + (is_only_image ? " --image" : "");
}

// blame explains sessions of this build alone: the one that the command to reproduce records.
std::string blame_command(const CaseResult& result) {
  if (!result.difference || !result.difference->apart || !result.reproduce.starts_with("tumble record ")) return "";
  const Apart& apart = *result.difference->apart;
  return "tumble blame " + shell_quoted(result.name + ".tumble") + " --body " + std::to_string(apart.body) +
         " --step " + std::to_string(apart.step) + " --back 5";
}

// The page shows sessions of this build: likewise.
std::string view_command(const CaseResult& result, const std::string& suite) {
  if (!result.reproduce.starts_with("tumble record ")) return "";
  const std::string rules = (std::filesystem::path(suite) / "cases" / result.name / "metrics.toml").string();
  return "tumble view " + shell_quoted(result.name + ".tumble") + " --bounds " + shell_quoted(rules);
}

}  // namespace

std::string current_folder() {
  std::error_code error;
  return std::filesystem::current_path(error).string();
}

std::vector<NextCommand> next_commands(const CaseResult& result, const std::string& suite) {
  std::vector<NextCommand> commands;
  const auto add = [&](const char* purpose, const std::string& line) {
    if (!line.empty()) commands.push_back({purpose, line});
  };
  add("To reproduce", result.reproduce);
  add("Then, to go back from where a body is to the cause", blame_command(result));
  add("Then, to see it step by step in a browser, with its bounds, and ask any number for its cause",
      view_command(result, suite));
  add("To judge it again", "tumble check " + shell_quoted(result.name) + suite_option(suite));
  add("To accept it, if it is right", result.bless);
  add("To find the commit, REV being one that passed", bisect_command(result, suite));
  return commands;
}

}  // namespace tumble::golden
