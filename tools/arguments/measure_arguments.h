#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "replay/measure/measure_options.h"
#include "tools/arguments/arguments.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/result.h"

namespace tumble::tools {

/// The choice of bodies, axis and start, for `measure` and `bisect --metric`.
struct MeasureArguments {
  std::string bodies = "all";
  std::string axis;  ///< empty: not given
  std::optional<std::uint64_t> from_step;
};

/// The names of all metrics, which begin a bound.
std::vector<std::string> metric_words();

/// Declares --bodies, --axis and --from-step.
void add_measure(Arguments& arguments, MeasureArguments& target);

/// axes: those of the session, whose horizontal axes --axis names. named: its bodies. Errors (kBadInput): unknown
/// words, bodies or axes.
Result<replay::MeasureOptions> parse_measure(const MeasureArguments& arguments, const replay::EngineAxes& axes = {},
                                             const replay::BodyTable& named = {});

}  // namespace tumble::tools
