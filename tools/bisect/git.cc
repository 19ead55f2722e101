#include "tools/bisect/git.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/process/run_child.h"

namespace tumble::tools::bisect {
namespace {

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// The first line of what git said, and the command that it advises: of a folder that another user owns, as in a
/// container.
std::string gist_of(const std::string& text) {
  const std::size_t advice = text.find("git config ");
  return first_line(text) + (advice == std::string::npos ? "" : "; git advises: " + first_line(text.substr(advice)));
}

/// Status 1 of a git command that answers a question.
constexpr const char* kNo = "no";

}  // namespace

Result<std::string> Git::run(const std::string& folder, std::vector<std::string> words) const {
  process::Program task;
  task.words = {"git", "-C", folder, "-c", "core.hooksPath=/dev/null", "-c", "advice.detachedHead=false"};
  task.words.insert(task.words.end(), words.begin(), words.end());
  task.out = scratch_ + "/git.out";
  task.err = scratch_ + "/git.err";
  task.more = {{"GIT_TERMINAL_PROMPT", "0"}};
  const Result<process::ChildEnd> end = process::run_child(task);
  if (!end.ok()) return cannot_finish("bisect needs git: " + end.error().message);
  const Result<std::string> words_of_git = golden::read_text(task.err);
  if (!end->well()) {
    const std::string said = words_of_git.ok() ? gist_of(*words_of_git) : "";
    if (end->exit == 1 && said.empty()) return bad_input(kNo);
    return cannot_finish("git " + words.front() + ' ' + end->text() + (said.empty() ? "" : ": " + said));
  }
  Result<std::string> printed = golden::read_text(task.out);
  if (!printed.ok()) return printed.error();
  std::string text = *std::move(printed);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

Result<std::string> Git::resolve(const std::string& revision) const {
  Result<std::string> commit =
      run(repository_, {"rev-parse", "--verify", "--quiet", "--end-of-options", revision + "^{commit}"});
  if (commit.ok()) return commit;
  if (commit.error().message != kNo) return bad_input(commit.error().message);
  return bad_input("found no revision " + in_quotes(revision) + " in " + repository_ + shallow_advice());
}

std::string Git::shallow_advice() const {
  const Result<std::string> answer = run(repository_, {"rev-parse", "--is-shallow-repository"});
  if (!answer.ok() || *answer != "true") return "";
  return "; this clone is shallow and lacks the older commits: fetch them ('git fetch --unshallow', in a GitHub "
         "workflow 'fetch-depth: 0' of actions/checkout)";
}

Result<std::string> Git::common_folder() const {
  Result<std::string> folder = run(repository_, {"rev-parse", "--path-format=absolute", "--git-common-dir"});
  if (folder.ok()) return folder;
  return bad_input(repository_ + ": is no clone of a git repository; give one with --repo: " + folder.error().message);
}

Result<bool> Git::is_ancestor(const std::string& older, const std::string& newer) const {
  const Result<std::string> answer = run(repository_, {"merge-base", "--is-ancestor", older, newer});
  if (answer.ok()) return true;
  if (answer.error().message == kNo) return false;
  return answer.error();
}

Result<std::vector<Candidate>> Git::candidates(const std::vector<std::string>& good, const std::string& bad,
                                               bool first_parent) const {
  std::vector<std::string> words = {"rev-list", "--bisect-all"};
  if (first_parent) words.emplace_back("--first-parent");
  words.push_back(bad);
  for (const std::string& commit : good) words.push_back('^' + commit);
  const Result<std::string> text = run(repository_, words);
  if (!text.ok()) return text.error();
  std::vector<Candidate> all;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {  // "<commit> (dist=7)", with the names of branches in between
    Candidate candidate;
    candidate.commit = line.substr(0, line.find(' '));
    const std::size_t at = line.find("dist=");
    if (at == std::string::npos)
      return cannot_finish("git rev-list --bisect-all: found \"" + line + "\", wanted a distance");
    std::from_chars(line.data() + at + 5, line.data() + line.size(), candidate.distance);
    all.push_back(std::move(candidate));
  }
  return all;
}

Result<std::uint64_t> Git::depth(const std::string& commit) const {
  const Result<std::string> text = run(repository_, {"rev-list", "--count", "--first-parent", commit});
  if (!text.ok()) return text.error();
  std::uint64_t count = 0;
  std::from_chars(text->data(), text->data() + text->size(), count);
  return count == 0 ? 0 : count - 1;
}

Result<CommitFacts> Git::facts(const std::string& commit) const {
  const Result<std::string> text =
      run(repository_, {"show", "--no-show-signature", "--no-patch", "--format=%H%n%s%n%an%n%aI", commit});
  if (!text.ok()) return text.error();
  CommitFacts facts;
  std::istringstream lines(*text);
  std::getline(lines, facts.commit);
  std::getline(lines, facts.subject);
  std::getline(lines, facts.author);
  std::getline(lines, facts.date);
  return facts;
}

Status Git::clone_to(const std::string& folder) const {
  const Result<std::string> source = common_folder();
  if (!source.ok()) return source.error();
  const Result<std::string> done = run(".", {"clone", "--quiet", "--shared", "--no-checkout", *source, folder});
  if (!done.ok()) return done.error();
  // A list of the user's own may be missing, which is as good as an empty one.
  std::error_code none;
  std::filesystem::copy_file(*source + "/info/exclude", folder + "/.git/info/exclude",
                             std::filesystem::copy_options::overwrite_existing, none);
  return {};
}

Result<std::string> Git::left_over(const std::string& folder) const {
  Result<std::string> names =
      run(folder, {"ls-files", "--others", "--exclude-standard", "--directory", "--no-empty-directory"});
  if (!names.ok()) return names;
  std::string line = *std::move(names);
  for (std::size_t at = line.find('\n'); at != std::string::npos; at = line.find('\n', at)) line.replace(at, 1, ", ");
  return line;
}

Status Git::put(const std::string& folder, const std::string& commit, bool from_scratch) const {
  const Result<std::string> moved = run(folder, {"checkout", "--quiet", "--force", "--detach", commit});
  if (!moved.ok()) return moved.error();
  const Result<std::string> cleaned = run(folder, {"clean", "--quiet", "-ffd" + std::string(from_scratch ? "x" : "")});
  return cleaned.ok() ? Status() : cleaned.error();
}

}  // namespace tumble::tools::bisect
