#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "tumble/golden/case_rules.h"
#include "tumble/golden/suite.h"
#include "tumble/golden/suite_result.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// The facts on a check before its first case runs and after its engine was built. all: the cases of all shards; mine:
/// those of this one. require: in place of each case's own. timeout_s: of a case.
RunFacts facts_of_run(const Suite& suite, const std::vector<CaseFolder>& all, const std::vector<CaseFolder>& mine,
                      const std::optional<std::vector<VerdictKind>>& require, double timeout_s);

/// Makes a report folder a bundle: writes bundle.json, at once, when all other files are there. A folder without it is
/// the report of a check that did not come to its end.
Status write_bundle(const SuiteResult& result, const std::filesystem::path& folder);

}  // namespace tumble::golden
