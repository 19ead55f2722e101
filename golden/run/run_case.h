#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "golden/run/case_run.h"
#include "golden/run/failed_case_files.h"
#include "golden/run/recorded_case.h"
#include "tumble/golden/suite.h"

namespace tumble::golden {

struct RunOptions {
  std::filesystem::path suite;                      ///< its root
  std::optional<std::vector<VerdictKind>> require;  ///< overrides the case's own list
  std::filesystem::path report;                     ///< folder for the files of a failed case; empty: none
  bool to_bless = false;                            ///< runs an engine once more where its case requires exact
  bool heavy = false;                               ///< go_on_from_each_step() for every case
  std::filesystem::path scratch =
      {};                       ///< folder for temporary files, which outlives a process that is ended; empty: none
  RecordedCases recorded = {};  ///< sessions to judge instead of running their cases; empty: every case is run
};

/// Reads a case's files, runs its scene (or the external engine that it names) and judges the session. Every failure
/// becomes a problem of the result.
CaseRun run_case(const CaseFolder& folder, const RunOptions& options);

/// The command line that records a case's session, with its own engine.
std::string reproduce_command(const CaseFolder& folder, const std::filesystem::path& suite, const CaseRules& rules,
                              bool converts = false);

}  // namespace tumble::golden
