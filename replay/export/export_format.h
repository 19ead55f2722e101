#pragma once

#include <memory>
#include <string>

#include "replay/export/plan/export_writer.h"
#include "src/files/output_file.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// A format of `tumble export`.
struct ExportFormat {
  const char* ending;  ///< ".csv", of the file's name, in any case
  const char* name;    ///< "table of comma-separated values"
  bool to_pipes;       ///< can be written to a device or a pipe: every byte stays as it was written
  std::unique_ptr<ExportWriter> (*make)(files::OutputFile& file);  ///< null: this build has no such format
};

/// The format that the ending of a path names. Errors (kBadInput): another ending, a format that this build lacks; the
/// message names those there are.
Result<const ExportFormat*> export_format(const std::string& path);

}  // namespace tumble::replay
