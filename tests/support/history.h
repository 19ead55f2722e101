#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "tests/support/program.h"

/// Histories of a small project that stands in for this one: its "build" takes a moment, its program is this build's
/// with what a commit planted in it.
namespace tumble::test {

/// Which commits, counted from 1, are not harmless.
struct HistoryPlan {
  std::size_t commits = 64;
  std::size_t fault = 41;                   ///< from here on a body drifts, and a picture's camera has moved
  std::set<std::size_t> broken = {32, 33};  ///< do not build
  bool with_case = false;                   ///< a golden case with a picture, which takes a while to bless
};

/// A clone in the workshop's folder "project", with a session of its first commit as "session.tumble".
class History {
 public:
  History(const Workshop& shop, const HistoryPlan& plan);

  /// The full name of the n-th commit, from 1.
  [[nodiscard]] std::string commit(std::size_t n) const;

  /// `tumble bisect` from the first commit to the last, with the stand-in's own build and program.
  [[nodiscard]] Outcome bisect(const std::vector<std::string>& more) const;

  /// Likewise, without revisions and program. bin/whole is the program in one file; each build adds a line to "builds".
  [[nodiscard]] Outcome bisect_by(const std::vector<std::string>& more) const;

  /// Everything in the clone that a bisection must leave alone: the index, HEAD, branches, worktrees, all files.
  [[nodiscard]] std::string footprint() const;

  /// Makes the program show the fault in its sixth run, whatever the commit.
  void answer_otherwise_once() const;

  /// Makes the program send its parent, the bisection, an interrupt when it is run the next time.
  void interrupt_next() const;

 private:
  [[nodiscard]] std::string git(const std::string& arguments) const;

  const Workshop& shop_;
  std::vector<std::string> commits_;  // the last first
};

}  // namespace tumble::test
