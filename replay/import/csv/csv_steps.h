#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "replay/import/csv/csv_bodies.h"
#include "replay/import/csv/csv_channels.h"
#include "replay/import/csv/csv_clock.h"
#include "replay/import/csv/csv_format.h"
#include "replay/import/csv/csv_reader.h"
#include "replay/import/csv/table_map.h"
#include "replay/import/motion_check.h"
#include "replay/import/table_notes.h"
#include "tumble/replay/engine_log.h"
#include "tumble/replay/imported_table.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// The rows of an imported table, gathered step by step.
namespace tumble::replay {

/// Another session, for values that the table lacks: sizes, masses and materials by id, gravity, dt, camera.
struct SessionLike {
  sim::SceneDef scene;             ///< of the header
  std::vector<sim::BoxDef> boxes;  ///< all bodies of the session, thrown ones included; ascending id
  bool dt_varies = false;          ///< its steps differ in length, so that it has no dt for a table
};

/// The rows of one step.
struct TableStep {
  using Row = std::pair<sim::BodyId, EngineState>;
  double dt = 0;                              ///< s, since the step before; 0 for the first step
  std::uint64_t line = 0;                     ///< line of the first row
  std::vector<Row> rows;                      ///< ascending id
  StepValues values{std::vector<Channel>{}};  ///< of channels; only in the second reading
};

/// How a table is read.
struct TableOptions {
  std::vector<std::string> settings = {};  ///< "key: value"; override the settings of the table
  std::optional<SessionLike> like = {};
  TableMap map = {};
  std::vector<ChannelKind> kinds = {};  ///< CsvChannels::kinds() of the first reading; empty in the first
  bool scalar_last = false;             ///< ImportOptions::scalar_last
};

/// Reads a table step by step and records which bodies exist. Errors (kBadInput) name file, line and column.
class CsvSteps {
 public:
  /// Reads up to the first row.
  static Result<CsvSteps> open(std::string_view text, const std::string& name, const TableOptions& options);

  /// The next step; false after the last one.
  Result<bool> next(TableStep& step);

  [[nodiscard]] const CsvSettings& settings() const { return settings_; }
  /// The facts about the table that the states do not show; none where there are none.
  [[nodiscard]] std::optional<ImportedTable> facts() const;
  /// A body with its values from the step in which it first appears.
  [[nodiscard]] const sim::BoxDef& box(sim::BodyId id) const { return boxes_.at(id); }
  /// Name and shape of a body; with an empty name and no shape where the table gives none.
  [[nodiscard]] const BodyInfo& info(sim::BodyId id) const { return infos_.at(id); }
  [[nodiscard]] const Shape* shape(sim::BodyId id) const;
  [[nodiscard]] const CsvChannels& channels() const { return channels_; }
  /// By the engine that made the table, as the table says.
  [[nodiscard]] bool velocity_derived() const { return !columns_.has_velocity() || settings_.velocity_derived; }
  [[nodiscard]] bool spin_derived() const { return !columns_.has_spin() || settings_.spin_derived; }
  [[nodiscard]] const TableNotes& notes() const { return notes_; }  ///< on the steps read so far
  /// Whether these fit what the table says of them.
  [[nodiscard]] const MotionCheck& plausible() const { return plausible_; }
  [[nodiscard]] Error at_line(std::uint64_t line, const std::string& message) const {
    return table_.at_line(line, message);
  }

 private:
  /// A body that a step had.
  struct Met {
    std::uint64_t last_step = 0;  // counted from 0
    CsvBodies::FirstRow first;
    std::string shape;  // the cell
  };

  CsvSteps(CsvReader table, CsvSettings settings, CsvColumns columns)
      : table_(std::move(table)),
        settings_(std::move(settings)),
        columns_(std::move(columns)),
        clock_(columns_, settings_.dt),
        bodies_(columns_, settings_),
        channels_(columns_, settings_.kinds, single()) {}
  /// Cells are floats.
  [[nodiscard]] bool single() const {
    return settings_.engine.precision_bits == kBinary32Bits && !settings_.wide_cells;
  }
  Result<bool> next_row();
  Status take_row(TableStep& step);
  Status meet(sim::BodyId id, const EngineState& state);
  Status describe(sim::BodyId id, const sim::Vec3& size);
  Status check_description(sim::BodyId id, const Met& met);
  Result<sim::BodyId> read_id();
  Result<sim::Quat> read_orientation();
  Result<EngineState> read_state(sim::BodyId id, double dt);
  Status check_state(sim::BodyId id, const std::array<double, 4>& q);
  void look_for_lost(sim::BodyId id, std::size_t first, std::span<const std::size_t> columns,
                     std::span<const double> numbers);
  template <std::size_t N>
  Status read_numbers(const std::array<std::size_t, N>& columns, std::array<double, N>& out) const;

  CsvReader table_;
  CsvSettings settings_;
  CsvColumns columns_;
  CsvClock clock_;
  CsvBodies bodies_;
  CsvChannels channels_;
  DerivedMotion motion_;
  bool first_reading_ = true;
  std::map<std::string, sim::BodyId, std::less<>> ids_;  // of bodies with a text for an id
  std::map<sim::BodyId, BodyInfo> infos_;
  std::map<sim::BodyId, Shape> shapes_;
  std::map<sim::BodyId, sim::BoxDef> like_;
  std::map<sim::BodyId, sim::BoxDef> boxes_;  // of every body met
  std::map<sim::BodyId, Met> met_;
  std::uint64_t steps_ = 0;  // read so far
  bool has_row_ = false;
  TableNotes notes_;
  MotionCheck plausible_;
};

}  // namespace tumble::replay
