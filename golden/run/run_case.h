#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/judge/judge.h"
#include "golden/judge/judge_pictures.h"
#include "golden/suite/suite.h"

namespace tumble::golden {

struct RunOptions {
  std::filesystem::path suite;                      ///< its root
  std::optional<std::vector<VerdictKind>> require;  ///< overrides the case's own list
  std::filesystem::path report;                     ///< folder for the files of a failed case; empty: none
};

/// A case, run and judged.
struct CaseRun {
  CaseResult result;
  CaseRules rules;
  Expected actual;
  std::vector<std::optional<double>> values;
  std::vector<DrawnPicture> pictures;
  bool complete = false;  ///< the session ran to its end and was measured: it could be blessed
};

/// Reads a case's files, runs its scene (or the external engine that it names) and judges the session. Every failure
/// becomes a problem of the result.
CaseRun run_case(const CaseFolder& folder, const RunOptions& options);

}  // namespace tumble::golden
