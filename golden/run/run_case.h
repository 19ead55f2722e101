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
  std::optional<std::vector<VerdictKind>> require;  ///< instead of what the case says
  std::filesystem::path report;                     ///< where a failed case leaves its files; empty: nowhere
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

/// Reads a case's files, runs its scene (or the engine that it names) and judges the session. Everything that goes
/// wrong becomes a problem of the result.
CaseRun run_case(const CaseFolder& folder, const RunOptions& options);

}  // namespace tumble::golden
