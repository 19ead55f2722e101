#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/arguments/measure_arguments.h"
#include "tools/compare/spread.h"
#include "tools/output/exit.h"
#include "tools/output/text.h"
#include "tumble/golden/case_rules.h"
#include "tumble/replay/imported_table.h"
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

/// What all runs have in common.
struct RunsFacts {
  std::vector<std::string> logs;
  replay::EngineAxes axes;
  std::size_t different = 0;       ///< sessions among them no two of which agree in every bit
  std::size_t once = 0;            ///< of these, those that came once: about as often a further run is a new one
  std::vector<std::string> notes;  ///< for people
  [[nodiscard]] bool repeats() const { return different == 1; }
};

/// A bound of a case, and what the runs gave for its metric. Lengths in m.
struct JudgedBound {
  golden::MetricRule rule;
  std::vector<std::optional<double>> values;  ///< one a run
  std::size_t broken = 0;                     ///< in how many runs
};

/// Tells the spread of each metric and proposes bounds, or judges every run by bounds. Status: a difference where a run
/// breaks one. Errors (kBadInput): a single run to propose from, runs with different axes, an unknown metric.
Result<Exit> measure_runs(const RunsQuestion& question);

}  // namespace tumble::tools
