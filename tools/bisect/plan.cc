#include "tools/bisect/plan.h"

#include <algorithm>
#include <bit>

namespace tumble::tools::bisect {

// git orders candidates by how evenly an answer halves them. Commits that do not build often lie side by side in
// history, and with them at the top of that order: after n skipped ones at the top the choice moves on by n squared, at
// most to the middle of the list, which leaves such a stretch in a few answers.
Plan next_step(std::span<const Candidate> candidates, const std::string& bad, const std::set<std::string>& skipped) {
  Plan plan;
  std::vector<std::string> open;
  std::size_t better_skipped = 0;  // before the first that can be asked
  for (const Candidate& candidate : candidates) {
    if (candidate.commit == bad) continue;
    if (skipped.contains(candidate.commit)) {
      plan.suspects.push_back(candidate.commit);
      if (open.empty()) ++better_skipped;
    } else {
      open.push_back(candidate.commit);
    }
  }
  plan.suspects.push_back(bad);
  plan.left = candidates.size();
  plan.steps = static_cast<unsigned>(std::bit_width(open.size()));
  if (open.empty()) return plan;
  plan.suspects.clear();
  plan.test = open[std::min(better_skipped * better_skipped, open.size() / 2)];
  return plan;
}

}  // namespace tumble::tools::bisect
