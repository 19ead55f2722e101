#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

/// The logic of a bisection, apart from git, files and processes.
namespace tumble::tools::bisect {

/// A commit that may be the first bad one, as `git rev-list --bisect-all` lists it.
struct Candidate {
  std::string commit;
  std::uint64_t distance = 0;  ///< the smaller part of the candidates that an answer about it leaves or takes away
};

/// The next step.
struct Plan {
  std::string test;                   ///< the commit to ask about; empty: no answer can narrow it further
  std::vector<std::string> suspects;  ///< then: the first bad commit, or several that no answer can tell apart
  std::uint64_t left = 0;             ///< commits that may still be the first bad one
  unsigned steps = 0;                 ///< answers still needed, about
};

/// candidates: the best first, `bad` among them; `bad` is known to be bad, all commits before the candidates are good.
/// skipped: commits that could not be asked. If the best one was skipped, a commit further off is chosen, the
/// further the more were skipped: commits that do not build often lie side by side.
Plan next_step(std::span<const Candidate> candidates, const std::string& bad, const std::set<std::string>& skipped);

}  // namespace tumble::tools::bisect
