#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "replay/format/step_record.h"
#include "replay/import/csv_reader.h"
#include "src/base/result.h"
#include "src/model/scene.h"

/// What the lines "# key: value" and the columns of an imported table mean. docs/other_engines.md is the format.
namespace tumble::replay {

/// How an engine's numbers become ours: SI, z up, right-handed. Every way is a change of signs and axes, exact to the
/// bit, but for the unit of length, which multiplies.
struct CsvAxes {
  int up = 2;  ///< the engine's axis that points up: 0 x, 1 y, 2 z
  bool left_handed = false;
  double metres = 1;  ///< in the engine's unit of length

  [[nodiscard]] sim::Vec3 direction(const sim::Vec3& v) const;  ///< without the unit
  [[nodiscard]] sim::Vec3 length(const sim::Vec3& v) const;     ///< positions, velocities, gravity
  [[nodiscard]] sim::Vec3 axial(const sim::Vec3& w) const;      ///< spins
  [[nodiscard]] sim::Quat turn(const sim::Quat& q) const;
  [[nodiscard]] sim::Vec3 extents(const sim::Vec3& size) const;
};

struct CsvSettings {
  EngineName engine = {"CSV", "", kBinary64Bits};
  CsvAxes axes;
  std::optional<double> dt;  ///< s, of one step of the engine
  sim::SceneDef scene;       ///< name, gravity, ground
  sim::BoxDef box;           ///< what a body is where no column says it: size, mass, material
};

/// Reads the settings of a file, then `more` ("key: value", from the command line), which win. `start`: what holds
/// where neither says anything. Errors (kBadInput): an unknown key, a value that cannot be; file and line, or the
/// argument.
Result<CsvSettings> read_settings(const CsvReader& table, std::span<const std::string> more, CsvSettings start);

/// Where the table has what; kNone where it does not.
struct CsvColumns {
  static constexpr std::size_t kNone = ~std::size_t{0};
  std::size_t step = kNone, time = kNone, id = kNone, frozen = kNone, mass = kNone, is_static = kNone;
  std::size_t friction = kNone, restitution = kNone, row = kNone, column = kNone;
  std::array<std::size_t, 3> position = {}, velocity = {}, spin = {}, size = {};  ///< all of a vector or none
  std::array<std::size_t, 4> orientation = {};
};

/// Finds the columns. Errors (kBadInput): one that is missing, given twice, unknown (and what it may have meant) or
/// part of a vector without the rest.
Result<CsvColumns> find_columns(const CsvReader& table);

}  // namespace tumble::replay
