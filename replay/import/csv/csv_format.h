#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "replay/import/camera_change.h"
#include "replay/import/csv/csv_reader.h"
#include "replay/import/derived_motion.h"
#include "tumble/replay/channel.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

/// The meaning of the lines "# key: value" and of the columns of an imported table. docs/other_engines.md specifies the
/// format.
namespace tumble::replay {

struct CsvSettings {
  EngineName engine = {"CSV", "", kBinary64Bits};
  EngineAxes axes;
  std::optional<double> dt;  ///< s, of one step of the engine
  sim::SceneDef scene;       ///< name, gravity, ground
  sim::BoxDef box;           ///< size, mass and material of a body without such columns
  EulerOrder euler;          ///< of the columns euler.1 to euler.3
  bool radians = false;      ///< the unit of these columns; else degrees
  bool wide_cells = false;   ///< cells are doubles, also of an engine that computes with floats
  bool velocity_derived = false, spin_derived = false;  ///< the columns, where there are any, hold derived values
  std::vector<ChannelKind> kinds;  ///< of the channels, in the order of their columns; empty: as the cells look
  CameraChange camera;             ///< in the engine's axes and units until all settings are read
};

/// Reads the settings of a table, then `more` ("key: value", from the command line), which override the table. start:
/// the values of keys that neither has. Errors (kBadInput): an unknown key, a repeated one, an impossible value. The
/// message names file and line, or the argument.
Result<CsvSettings> read_settings(const CsvReader& table, std::span<const std::string> more, CsvSettings start);

/// Whether the settings of a table have a key of this name.
bool is_setting(std::string_view key);

/// The number of each column in the table; kNone for an absent column.
struct CsvColumns {
  static constexpr std::size_t kNone = ~std::size_t{0};
  std::size_t step = kNone, time = kNone, id = kNone, frozen = kNone, mass = kNone, is_static = kNone;
  std::size_t friction = kNone, restitution = kNone, row = kNone, column = kNone;
  std::size_t name = kNone, shape = kNone, dt = kNone, friction_dynamic = kNone, texture = kNone;
  std::array<std::size_t, 3> position = {}, velocity = {}, spin = {}, euler = {},
                             size = {};  ///< all components of a vector or none
  std::array<std::size_t, 4> orientation = {};
  std::vector<std::string> passed_over;  ///< names that begin with _, in their order
  struct ChannelColumn {
    std::size_t column = 0;
    std::string name;  ///< of the channel, with its unit: "knee (rad)"
    ChannelScope scope = ChannelScope::kBody;
  };
  std::vector<ChannelColumn> channels;  ///< "channel.NAME" of bodies, "world.NAME" of the step as a whole, "pair.NAME"
  [[nodiscard]] bool has_velocity() const { return velocity[0] != kNone; }
  [[nodiscard]] bool has_spin() const { return spin[0] != kNone; }
};

/// Finds the columns. others_are_channels: a column that the format does not know is a channel of bodies. Errors
/// (kBadInput): a column is missing, given twice or unknown, a vector lacks components, or a name is too long.
Result<CsvColumns> find_columns(const CsvReader& table, bool others_are_channels = false);

}  // namespace tumble::replay
