#include "tumble/golden/case_result.h"

#include <algorithm>

namespace tumble::golden {

bool CaseResult::passed() const {
  if (!problems.empty() || require.empty()) return false;
  return std::ranges::all_of(require, [&](VerdictKind kind) { return verdict(kind).outcome == Outcome::kPass; });
}

}  // namespace tumble::golden
