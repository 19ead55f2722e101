#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tumble/sim/result.h"

namespace tumble::golden {

/// [engine.table] of a tumble.toml: how a table, or an archive of arrays, that the engine writes is read. As the
/// options of `import`. Paths are from the folder of tumble.toml.
struct TableReading {
  std::vector<std::string> map = {};     ///< "position.x=px"
  std::string map_file;                  ///< a file with such lines; empty: none
  std::vector<std::string> header = {};  ///< "up: y": wins over the table's
  std::string model;                     ///< of MuJoCo, whose joints name qpos; empty: none
  bool scalar_last = false;
  bool channels = false;  ///< every column that the format does not know is a channel of bodies
};

/// Replaces the file of a session by the table that it stands for: an archive of arrays by its table, columns by the
/// names of the format, header lines by those of `reading`. A log, a stream, and a table without anything to change
/// stay as they are. Errors (kBadInput): as replay::read_npz(), table_of_arrays(), add_mapping() and rename_columns().
Status rewrite_table(const std::string& path, const TableReading& reading, const std::filesystem::path& folder);

}  // namespace tumble::golden
