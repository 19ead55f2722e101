#include "golden/judge/across_cases.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "src/base/text.h"

namespace tumble::golden {
namespace {

constexpr std::size_t kSentencesMax = 3;

struct Group {
  std::string place;
  std::size_t cases = 0;
};

std::string decimal(std::uint64_t value) { return std::to_string(value); }

/// The cases of one phase: those that share a step where they are more than half, else all with the range of steps.
Group group_of_phase(const std::string& phase, const std::vector<std::uint64_t>& steps) {
  std::map<std::uint64_t, std::size_t> counts;
  for (const std::uint64_t step : steps) ++counts[step];
  const auto [step, count] =
      *std::ranges::max_element(counts, {}, &std::pair<const std::uint64_t, std::size_t>::second);
  if (2 * count > steps.size()) return {"step " + decimal(step) + ", phase " + phase, count};
  return {"phase " + phase + ", in steps " + decimal(counts.begin()->first) + " to " + decimal(counts.rbegin()->first),
          steps.size()};
}

}  // namespace

std::vector<std::string> across_cases(const std::vector<CaseResult>& cases) {
  std::map<std::string, std::vector<std::uint64_t>> steps_of_phase;
  std::size_t moved = 0;
  for (const CaseResult& one : cases) {
    if (!one.difference) continue;
    ++moved;
    steps_of_phase[one.difference->phase].push_back(one.difference->step);
  }
  std::vector<Group> groups;
  for (const auto& [phase, steps] : steps_of_phase) {
    if (steps.size() > 1) groups.push_back(group_of_phase(phase, steps));
  }
  std::ranges::stable_sort(groups, std::ranges::greater(), &Group::cases);
  std::vector<std::string> sentences;
  std::size_t rest = 0;
  for (const Group& group : groups) {
    if (sentences.size() == kSentencesMax) {
      rest += group.cases;
    } else {
      sentences.push_back(decimal(group.cases) + " of " + decimal(moved) + " first differ in " + group.place);
    }
  }
  if (rest > 0)
    sentences.back() += "; " + decimal(rest) + " more in " + count_text(groups.size() - kSentencesMax, "further phase");
  return sentences;
}

std::string gone_on_across(const std::vector<CaseResult>& cases) {
  if (std::ranges::all_of(cases, [](const CaseResult& one) { return one.gone_on.empty(); })) return "";
  std::string others;
  std::size_t done = 0;
  for (const CaseResult& one : cases) {
    done += one.was_gone_on ? 1U : 0U;
    if (!one.was_gone_on) others += (others.empty() ? "" : ", ") + one.name;
  }
  return decimal(done) + " of " + decimal(cases.size()) + " gone on with from each step" +
         (others.empty() ? "" : "; not so: " + others);
}

}  // namespace tumble::golden
