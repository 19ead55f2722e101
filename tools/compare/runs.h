#pragma once

#include <string>
#include <vector>

#include "tools/arguments/measure_arguments.h"
#include "tools/output/exit.h"
#include "tumble/sim/result.h"

/// `tumble measure` of several runs of one scene, as of an engine whose runs differ by their own noise.
namespace tumble::tools {

struct RunsQuestion {
  std::vector<std::string> logs;
  MeasureArguments over;
  std::string against;  ///< the log of another session, for parting_time; empty: none
  std::string propose;  ///< names of metrics with commas between, or "all"; empty: nothing is proposed as TOML
  std::string bounds;   ///< a case's metrics.toml, whose bounds judge the runs; empty: their spread is told
  bool json = false;
};

/// Tells the spread of each metric and proposes bounds, or judges every run by bounds. Status: a difference where a run
/// breaks one. Errors (kBadInput): a single run to propose from, runs with different axes, an unknown metric.
Result<Exit> measure_runs(const RunsQuestion& question);

}  // namespace tumble::tools
