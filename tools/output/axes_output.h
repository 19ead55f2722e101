#pragma once

#include "replay/diff/difference_report.h"
#include "tools/output/text.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/imported_table.h"

namespace tumble::tools {

/// {"up": "y", "handed": "right", "length": "cm", "metres": 0.01}: the axes and the unit in which results are printed.
Json axes_json(const replay::EngineAxes& axes);

/// The axes of both sessions' tables where these are the same, else ours. Lengths stay in m.
replay::EngineAxes common_axes(const replay::LogHeader& a, const replay::LogHeader& b);

/// A difference in the axes and the unit of the sessions' table: its field, and both values. Other fields stay.
replay::Divergence in_axes(const replay::EngineAxes& axes, replay::Divergence difference);

/// Likewise each difference of a report, and the field of a body that is lost.
replay::DifferenceReport in_axes(const replay::EngineAxes& axes, replay::DifferenceReport report);

}  // namespace tumble::tools
