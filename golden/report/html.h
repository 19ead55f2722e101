#pragma once

#include <filesystem>
#include <string>

#include "tumble/golden/suite_result.h"

namespace tumble::golden {

/// index.html, for people: one page that needs nothing else and no network. folder: where the failed cases left their
/// files; those that the page shows are taken into it.
std::string report_html(const SuiteResult& result, const std::filesystem::path& folder);

}  // namespace tumble::golden
