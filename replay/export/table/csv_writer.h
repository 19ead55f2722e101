#pragma once

#include <memory>
#include <string>

#include "replay/export/plan/export_writer.h"
#include "src/files/output_file.h"

namespace tumble::replay {

/// Comma-separated values, a row a body and step, with lines "# key: value" before them: the table that `import` reads
/// (docs/other_engines.md), to the bit, NaN and infinity included. Axes: TableFrame's. Texts that would
/// break a cell are escaped, since cells have no quotes. `file` outlives the writer.
std::unique_ptr<ExportWriter> make_csv_writer(files::OutputFile& file);

}  // namespace tumble::replay
