#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "replay/import/csv/csv_reader.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The columns of a table under other names than the format's: what `--map` and a mapping file give.
struct TableMap {
  struct Entry {
    std::string field;   ///< a column of the format: "position.x", "channel.knee", "_ignored"
    std::string column;  ///< its name in the table
    std::string place;   ///< for messages: "--map", "mine.map:3"
  };
  std::vector<Entry> entries;
  bool others_are_channels = false;  ///< every other column of the table becomes a channel of bodies
};

/// Reads "FIELD=COLUMN". place: for messages. Errors (kBadInput): no '=', an empty side, a field that is mapped
/// already.
Status add_mapping(TableMap& map, std::string_view text, const std::string& place);

/// Reads lines "FIELD = COLUMN". A line that begins with # is a remark. Errors: as add_mapping(); a file that cannot be
/// read.
Status read_map_file(TableMap& map, const std::string& path);

/// Gives the columns of a table the names of the format. Errors (kBadInput): a column that the table lacks.
Status rename_columns(const TableMap& map, CsvReader& table);

}  // namespace tumble::replay
