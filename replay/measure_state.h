#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "replay/step_record.h"
#include "src/model/scene.h"

namespace tumble::replay {

/// A body whose kinetic energy is at most this, J/kg, counts as at rest in StateMeasures::at_rest: 0.08 m/s without
/// spin. It is a fixed number, not the scene's freeze_energy, so that sessions can be compared.
inline constexpr double kRestEnergy = 0.0032;

/// What one state shows, compared with state 0. docs/metrics.md defines each. Static bodies never count; lateral,
/// drift, tilt and top_drop are over the bodies of state 0 that still exist, the rest over all bodies there are.
struct StateMeasures {
  double lateral_max = 0;               ///< m
  double lateral_rms = 0;               ///< m
  std::optional<double> column_spread;  ///< m; none without a [[grid]]
  double drift_max = 0;                 ///< m
  double tilt_max = 0;                  ///< degrees
  double top_drop_max = 0;              ///< m
  double ground_penetration_max = 0;    ///< m; 0 in a scene without ground
  double kinetic = 0;                   ///< J
  double frozen_fraction = 0;           ///< of the dynamic bodies; 0 if there are none
  bool at_rest = true;                  ///< every dynamic body is frozen or below kRestEnergy
};

/// Measures states of one session against its start. Needs nothing but what a log says: the scene's boxes, state 0, and
/// the boxes thrown in since.
class StateMeter {
 public:
  /// scene: LogHeader::scene. start: state 0, as stored (positions are on the grid there).
  StateMeter(const sim::SceneDef& scene, BodyStates start);

  /// A box that an input threw in. Call before measuring a state that has it.
  void add_thrown(const sim::BoxDef& box);

  /// Measures a state. Bodies that neither the scene nor a throw explains are left out.
  StateMeasures measure(const BodyStates& now);

  /// The deepest overlap of two boxes in a state, m: slower than measure(), so asked for by itself.
  double overlap_max(const BodyStates& now);

  /// Bodies whose centre was below the ground in any state measured so far.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }

  /// Kinetic and potential energy of state 0, J, and how much of it lies above the lowest rest: every box on the ground
  /// on its largest face.
  struct StartEnergy {
    double kinetic = 0;
    double potential = 0;
    double above_rest = 0;
    [[nodiscard]] double total() const { return kinetic + potential; }
  };
  [[nodiscard]] StartEnergy start_energy() const;

 private:
  struct Body {
    sim::BoxDef box;
    sim::Vec3 inertia;  // kg·m², own axes
    bool in_start = false;
    bool lost = false;
    std::size_t start_row = 0;
    std::size_t grid_row = kNone;  // index into grid_rows_
  };
  // What the bodies of one grid row span in the state being measured, m.
  struct GridRow {
    double y_low, y_high, z_low, z_high;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void number_grid_rows();
  void find_rows(const BodyStates& now);
  void compare_with_start(const Body& body, const BodyStates& now, std::size_t row, StateMeasures& out) const;
  void widen_grid_row(const Body& body, const sim::Vec3& position);
  [[nodiscard]] std::optional<double> column_spread() const;

  BodyStates start_;
  sim::Vec3 gravity_;  // at the start, m/s²
  bool ground_;
  std::vector<Body> bodies_;  // ascending id
  std::uint64_t lost_ = 0;
  std::vector<GridRow> grid_rows_;
  std::vector<std::size_t> body_of_row_;  // of the rows of row_ids_: index into bodies_, or kNone
  std::vector<sim::BodyId> row_ids_;
};

}  // namespace tumble::replay
