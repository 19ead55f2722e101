#pragma once

#include <string>

#include "tools/output/text.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/step_record.h"

namespace tumble::tools {

/// {"up": "y", "handed": "right", "length": "cm", "metres": 0.01}: the axes and the unit in which results are printed.
Json axes_json(const replay::EngineAxes& axes);

/// The lines "# key: value" by which `import` reads a table of dump --csv as the log has it: axes, unit of length and
/// precision of another engine, and the columns that it derived. Each only where it is not what `import` takes anyway.
std::string table_head(const replay::LogHeader& header);

}  // namespace tumble::tools
