#pragma once

#include <cstddef>
#include <string>

#include "tumble/replay/channel.h"

/// Columns and cells of channels in a table, as `import` reads them: those of `export` and of `dump --csv`.
namespace tumble::replay {

/// "world.seed", "channel.knee", "pair.force".
std::string channel_column(const Channel& channel);

/// " (rad)" behind that name, as `import` reads it: the last brackets of a column are its unit. Empty where the unit
/// does not fit there; fits_column() tells.
std::string unit_in_column(const Channel& channel);

/// As number_cell() of a value that is a number; of any other, its text.
std::string value_cell(const ChannelValue& value, ChannelKind kind);

/// The cell of a channel of pairs: all values of the first body of `row`, "7=0.25 9=0.5".
std::string pair_cell(const ChannelValues& values, ChannelKind kind, std::size_t row);

/// Whether a unit comes back from behind the name of a column.
bool fits_column(const std::string& unit);

/// The row of a body's value; values.size() where it has none. Ids that ascend from call to call make it quick: `from`
/// is the row to begin at, and moves.
std::size_t value_row(const ChannelValues& values, sim::BodyId id, std::size_t& from);

}  // namespace tumble::replay
