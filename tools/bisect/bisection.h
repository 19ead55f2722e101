#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/bisect/ask_all.h"
#include "tools/bisect/git.h"
#include "tools/bisect/revision.h"
#include "tumble/sim/result.h"

namespace tumble::tools::bisect {

/// A revision that was asked.
struct Tested {
  enum class Verdict { kGood, kBad, kSkip };
  CommitFacts commit;
  Answer answer;
  Verdict verdict = Verdict::kSkip;
  double seconds = 0;  ///< of wall time: build and question
};
const char* name_of(Tested::Verdict verdict);  ///< "good", "bad", "skip"

/// The result of a bisection.
struct Finding {
  std::vector<CommitFacts>
      suspects;                ///< one: the commit looked for; more: nothing that could be asked tells them apart
  std::vector<Tested> tested;  ///< in order: the good end, the bad end, what lay between; where the good end was
                               ///< looked for: the bad end, then back from it
  std::size_t good = 0;        ///< the closest good revision, in `tested`
  std::size_t bad = 0;         ///< the first bad one that was asked
  [[nodiscard]] bool found() const { return suspects.size() == 1; }
};

/// Called after each revision: commits that are left, and about how many answers are still needed.
using EachTested = std::function<void(const Tested& tested, std::uint64_t left, unsigned steps)>;
/// Called before each revision.
using EachBegun = std::function<void(const CommitFacts& commit)>;

/// Finds the first commit between good and bad whose answer is not good's. Where the settings name no good one, goes
/// back from the bad one along first parents, in steps of 1, 2, 4 …, to one with another answer. Which commits decide
/// does not depend on settings.jobs. Writes the workplace's state after every answer, and reads it first. Errors:
/// kBadInput where the revisions cannot be ends (unknown, not in line, the same answer of both); kCannotFinish for an
/// interruption, an end that cannot be asked, git, disk.
Result<Finding> find_commit(const Settings& settings, const Workplace& place, const Git& git,
                            const Asker::Cancel& cancel, const EachBegun& begun, const EachTested& each);

}  // namespace tumble::tools::bisect
