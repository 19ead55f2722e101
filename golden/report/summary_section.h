#pragma once

#include <string>

#include "golden/report/html_text.h"
#include "tumble/golden/suite_result.h"

namespace tumble::golden {

/// "✓ 45 cases passed", "– nothing was judged: …".
std::string title_of(const SuiteResult& result);

/// The top of the page: the verdict on the whole, what the failures have in common, a tile for each kind of verdict.
Html banner(const SuiteResult& result);
Html tiles(const SuiteResult& result);

/// A table of the cases that failed or moved, the failed ones and the largest distance first; the page's script sorts
/// and filters it. Empty if there is none.
Html overview(const SuiteResult& result);

/// The comparisons of known outcome, and whether it came.
Html canary_list(const SuiteResult& result);

}  // namespace tumble::golden
