#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "replay/export/plan/export_plan.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/step_record.h"

/// The parts that the formats of tables share, CSV and NPZ: axes, header lines, words. `import` reads them back.
namespace tumble::replay {

/// The axes of the table that a session was imported from, but lengths in m: changing signs and axes is exact to the
/// bit, multiplying by a unit is not.
EngineAxes table_axes(const LogHeader& header);

/// Lines of the header, key and value, that give `import` back what the columns do not show.
TableSettings table_settings(const ExportPlan& plan);

/// States in the axes of a table. Copies nothing where these are ours.
class TableFrame {
 public:
  explicit TableFrame(const EngineAxes& axes) : axes_(axes), ours_(axes.ours()) {}
  /// Valid until the next call.
  const BodyStates& states(const BodyStates& ours);
  [[nodiscard]] sim::Vec3 extents(const sim::Vec3& size) const;
  [[nodiscard]] const EngineAxes& axes() const { return axes_; }

 private:
  EngineAxes axes_;
  bool ours_;
  BodyStates theirs_;
};

/// The word of the column `shape`; "box" for shapes that need a file, which tables do not have.
std::string shape_word(const ExportBody& body, const EngineAxes& axes);

/// "world.seed", "channel.knee", "pair.force".
std::string channel_column(const Channel& channel);

/// " (rad)" behind that name, as `import` reads it: the last brackets of a column are its unit. Empty where the unit
/// does not fit there; left_out_of_tables() says so.
std::string unit_in_column(const Channel& channel);

/// As number_cell() of a value that is a number; of any other, its text.
std::string value_cell(const ChannelValue& value, ChannelKind kind);

/// The cell of a channel of pairs: all values of the first body of `row`, "7=0.25 9=0.5".
std::string pair_cell(const ChannelValues& values, ChannelKind kind, std::size_t row);

/// For messages: values of bodies, or of pairs by their first body, that are not in the step.
std::string left_out_values(std::uint64_t count);

/// The parts of a session that no table has a place for, each with its reason.
std::vector<std::string> left_out_of_tables(const ExportPlan& plan);

/// The row of a body's value; values.size() where it has none. Ids that ascend from call to call make it quick: `from`
/// is the row to begin at, and moves.
std::size_t value_row(const ChannelValues& values, sim::BodyId id, std::size_t& from);

}  // namespace tumble::replay
