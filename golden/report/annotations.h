#pragma once

#include <string>
#include <vector>

#include "golden/judge/case_json.h"
#include "tumble/golden/suite_result.h"

/// The failures of a check as CI services show them beside a change: one line each.
namespace tumble::golden {

struct Annotation {
  std::string title;    ///< "brick_wall", "comparisons of known outcome"
  std::string message;  ///< one line: the magnitude, then the first difference
  std::string file;     ///< relative to the checkout where it lies below, else to the current folder where below that
};

/// Cases that failed, by name; problems of the suite; canaries that were not caught. Empty if the check passed.
/// checkout: the folder that the CI service has the repository in, from which it knows files; empty: not told.
std::vector<Annotation> annotations(const SuiteResult& result, const std::string& checkout);

/// GitHub's workflow commands, a line for each: "::error file=…,line=1,title=…::…".
std::string github_commands(const std::vector<Annotation>& failures);

/// GitLab's code quality report, an array of findings. A case keeps its fingerprint while its message is the same.
Json gitlab_findings(const std::vector<Annotation>& failures);

}  // namespace tumble::golden
