#pragma once

#include <string>
#include <vector>

#include "tumble/sim/result.h"
#include "tumble/sim/rotation.h"
#include "tumble/sim/vec.h"

/// The numbers of an imported table: its axes and units, which a log keeps beside the states in ours.
namespace tumble::replay {

/// One axis of a table that lies along one of ours.
struct EngineAxis {
  char letter = 'x';  ///< the table's axis: x, y or z
  double sign = 1;    ///< −1: the table's axis points the other way
};

/// Converts the vectors of a table to SI units, z up, right-handed, and back. Changes signs and axes, which is exact to
/// the bit in both directions; the unit of length multiplies and divides, which rounds.
struct EngineAxes {
  int up = 2;  ///< the table's axis that points up: 0 x, 1 y, 2 z
  bool left_handed = false;
  double metres = 1;  ///< per unit of length of the table

  [[nodiscard]] sim::Vec3 direction(const sim::Vec3& v) const;  ///< without the unit
  [[nodiscard]] sim::Vec3 length(const sim::Vec3& v) const;     ///< positions, velocities, gravity
  [[nodiscard]] sim::Vec3 axial(const sim::Vec3& w) const;      ///< spins
  [[nodiscard]] sim::Quat turn(const sim::Quat& q) const;
  [[nodiscard]] sim::Vec3 extents(const sim::Vec3& size) const;

  // The other way: from SI units, z up, to the table's.
  [[nodiscard]] sim::Vec3 their_direction(const sim::Vec3& v) const;
  [[nodiscard]] sim::Vec3 their_length(const sim::Vec3& v) const;
  [[nodiscard]] sim::Vec3 their_axial(const sim::Vec3& w) const;
  [[nodiscard]] sim::Quat their_turn(const sim::Quat& q) const;
  /// A length without a direction, m, in the table's unit.
  [[nodiscard]] double their_metres(double length) const { return metres == 1 ? length : length / metres; }

  /// The table's axis that lies along our axis k (0 x, 1 y, 2 z).
  [[nodiscard]] EngineAxis along(int k) const;
  /// As along(), for spins and the vector part of an orientation, whose signs a reflection reverses.
  [[nodiscard]] EngineAxis axial_along(int k) const;

  [[nodiscard]] std::string unit() const;  ///< of length: "m", "cm", "mm", or "[0.3048 m]" for a unit without a name
  /// Our axes and units: nothing is converted.
  [[nodiscard]] bool ours() const { return *this == EngineAxes{}; }
  friend bool operator==(const EngineAxes&, const EngineAxes&) = default;
};

/// "y up, right-handed, cm".
std::string to_string(const EngineAxes& axes);

/// The facts about an imported table that its states do not show.
struct ImportedTable {
  EngineAxes axes;
  std::vector<std::string> passed_over;  ///< names of the columns that the import did not read, in the table's order
  friend bool operator==(const ImportedTable&, const ImportedTable&) = default;
};

/// Errors (kBadInput): axes that are none, a unit of length that is no number above 0, more columns than a log keeps.
Status check_table(const ImportedTable& table);

}  // namespace tumble::replay
