#pragma once

#include <filesystem>
#include <vector>

#include "tumble/sim/result.h"

namespace tumble::golden {

/// The file that write_reports() writes JUnit's report to.
std::filesystem::path junit_file(const std::filesystem::path& folder, const std::filesystem::path& junit);

/// The file of a report with GitLab's findings (annotations.h), where they are wanted.
std::filesystem::path findings_file(const std::filesystem::path& folder);

/// Makes a report's place ready, before a check begins. Removes what an earlier check left there: a check that
/// ends early must not leave an old verdict behind. folder, junit: as write_reports() gets them.
/// Errors (kBadInput): a file of the report would replace a file of the suite or lie among the cases.
Status prepare_report(const std::filesystem::path& suite, const std::filesystem::path& folder,
                      const std::filesystem::path& junit);

/// Whether prepare_merged_report() may be called; touches nothing. Errors (kBadInput): the folder lies in a bundle, is
/// one or holds one; prepare_report()'s.
Status check_merged_report(const std::vector<std::filesystem::path>& bundles, const std::filesystem::path& folder,
                           const std::filesystem::path& junit);

/// As prepare_report(), for a report that is merged of these bundles, once all of them are read; none of their files
/// may be replaced.
Status prepare_merged_report(const std::vector<std::filesystem::path>& bundles, const std::filesystem::path& folder,
                             const std::filesystem::path& junit);

}  // namespace tumble::golden
