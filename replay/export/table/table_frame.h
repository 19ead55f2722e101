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

/// For messages: values of bodies, or of pairs by their first body, that are not in the step.
std::string left_out_values(std::uint64_t count);

/// The parts of a session that no table has a place for, each with its reason.
std::vector<std::string> left_out_of_tables(const ExportPlan& plan);

}  // namespace tumble::replay
