#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/bisect/plan.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// A commit as people know it.
struct CommitFacts {
  std::string commit;
  std::string subject;
  std::string author;
  std::string date;  ///< of the author, ISO 8601

  [[nodiscard]] std::string shortly() const { return commit.substr(0, 10); }
};

/// git, as a child process. The repository is only read.
class Git {
 public:
  /// repository: a folder in it. scratch: a folder for git's output.
  Git(std::string repository, std::string scratch) : repository_(std::move(repository)), scratch_(std::move(scratch)) {}

  /// The full name of a commit. Errors (kBadInput): no such revision, no repository; kCannotFinish: no git.
  [[nodiscard]] Result<std::string> resolve(const std::string& revision) const;

  /// The repository's own folder, absolute.
  [[nodiscard]] Result<std::string> common_folder() const;

  [[nodiscard]] Result<bool> is_ancestor(const std::string& older, const std::string& newer) const;

  /// Commits that `bad` has and none of `good`, best first. first_parent: along first parents only.
  [[nodiscard]] Result<std::vector<Candidate>> candidates(const std::vector<std::string>& good, const std::string& bad,
                                                          bool first_parent) const;

  /// How many first parents a commit has one behind another.
  [[nodiscard]] Result<std::uint64_t> depth(const std::string& commit) const;

  [[nodiscard]] Result<CommitFacts> facts(const std::string& commit) const;

  /// Makes `folder` a clone that shares this repository's objects and its own list of ignored files (info/exclude),
  /// with no files in it yet.
  [[nodiscard]] Status clone_to(const std::string& folder) const;

  /// Puts the files of a commit into such a clone. Ignored files stay (a build can use them), unless `from_scratch`;
  /// all other files that are not the commit's are removed.
  [[nodiscard]] Status put(const std::string& folder, const std::string& commit, bool from_scratch) const;

  /// Files and folders of such a clone that put() removes: neither of a commit nor ignored. One line, with commas.
  [[nodiscard]] Result<std::string> left_over(const std::string& folder) const;

  /// For messages where a commit is missing: that the clone is shallow, and how to fetch the rest; empty for a whole
  /// one.
  [[nodiscard]] std::string shallow_advice() const;

 private:
  [[nodiscard]] Result<std::string> run(const std::string& folder, std::vector<std::string> words) const;

  std::string repository_;
  std::string scratch_;
};

}  // namespace tumble::tools::bisect
