#pragma once

#include "tools/output/text.h"
#include "tumble/replay/divergence.h"
#include "tumble/replay/imported_table.h"

namespace tumble::tools {

/// {"up": "y", "handed": "right", "length": "cm", "metres": 0.01}: the axes and the unit in which results are printed.
Json axes_json(const replay::EngineAxes& axes);

/// A difference in the axes and the unit of the sessions' table: its field, and both values. Other fields stay.
replay::Divergence in_axes(const replay::EngineAxes& axes, replay::Divergence difference);

}  // namespace tumble::tools
