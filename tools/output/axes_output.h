#pragma once

#include "tools/output/text.h"
#include "tumble/replay/imported_table.h"

namespace tumble::tools {

/// {"up": "y", "handed": "right", "length": "cm", "metres": 0.01}: the axes and the unit in which results are printed.
Json axes_json(const replay::EngineAxes& axes);

}  // namespace tumble::tools
