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
  add("To judge it again", "tumble check " + shell_quoted(result.name) + suite_option(suite));
  add("To accept it, if it is right", result.bless);
  add("To find the commit, REV being one that passed", bisect_command(result, suite));
  return commands;
}

}  // namespace tumble::golden
