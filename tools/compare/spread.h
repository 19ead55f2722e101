#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "replay/measure/metric_list.h"
#include "tools/arguments/measure_arguments.h"
#include "tumble/golden/case_rules.h"
#include "tumble/replay/imported_table.h"

namespace tumble::tools {

/// What several runs of one scene gave for a metric, and bounds that a further run is expected to hold. Lengths in m.
///
/// The bounds are what the runs gave, wider on each side by the runs' own spread, and by a hundredth of the median at
/// least: runs that happened to give one value do not show that all would. Of runs that agree in every bit the bounds
/// are the value, to the 1e-9 by which C libraries differ.
struct MetricSpread {
  const replay::MetricRow* metric = nullptr;
  std::vector<std::optional<double>> values;  ///< one a run
  double least = 0, median = 0, largest = 0;  ///< of those that are there and finite
  std::optional<double> min, max;             ///< proposed; a side beyond which there is no value has none
  double room = 0;            ///< a change up to this, of all runs alike, may hold the bounds in each of them
  std::string without_bound;  ///< why none is proposed; empty: there is one

  [[nodiscard]] double spread() const { return largest - least; }
  /// After a change beyond this, each of the runs is out of bounds.
  [[nodiscard]] double certain() const { return room + spread(); }
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

/// repeats: the runs agree in every bit.
MetricSpread spread_of(const replay::MetricRow& metric, std::vector<std::optional<double>> values, bool repeats);

/// A [[metric]] of metrics.toml with the proposed bounds. Its reason says what the runs gave and what the bounds let
/// pass. over: what was measured. against: the log of the other session, for parting_time; empty: none.
std::string toml_of(const MetricSpread& spread, const MeasureArguments& over, const std::string& against);

}  // namespace tumble::tools
