#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "replay/format/not_finite.h"
#include "replay/measure/body_track.h"
#include "replay/measure/measure_options.h"
#include "replay/measure/reasonable_space.h"
#include "src/kernels/box_frame.h"
#include "tumble/replay/body_table.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// The largest kinetic energy, J/kg, at which a body counts as at rest in StateMeasures::at_rest: 0.08 m/s without
/// rotation. A fixed number and not the scene's freeze_energy, so that sessions with different settings compare.
inline constexpr double kRestEnergy = 0.0032;

/// The most, m/s in one step, that a body's speed grows by where something drives it: more than a train, a plane or a
/// rocket gains in a step, and less than a body that an engine's failure shoots away.
inline constexpr double kDrivenGain = 50;

/// The measures of one state, compared with the start; docs/metrics.md defines each. They are over the chosen dynamic
/// bodies; lateral, drift, tilt and top_drop are over those of the start that still exist. A measure over no body reads
/// 0 and has no meaning: `bodies` and `of_start` count the bodies.
struct StateMeasures {
  double lateral_max = 0;               ///< m
  double lateral_rms = 0;               ///< m
  std::optional<double> column_spread;  ///< m; none without a body of a [[grid]]
  double drift_max = 0;                 ///< m
  double tilt_max = 0;                  ///< degrees
  double top_drop_max = 0;              ///< m
  double ground_penetration_max = 0;    ///< m; 0 in a scene without ground
  double kinetic_linear = 0;            ///< J
  double kinetic_rotational = 0;        ///< J
  double frozen_fraction = 0;           ///< 0 if there are no bodies
  bool at_rest = true;                  ///< every body is frozen or below kRestEnergy
  std::size_t bodies = 0;               ///< measured
  std::size_t of_start = 0;             ///< of those, the bodies that the start has too
  double height_max = 0;                ///< m, of the centres; 0 if there are no bodies
  double height_min = 0;                ///< m
  double height_mean = 0;               ///< m
};

/// The first body of a session that is not finite in a state, of two sets of bodies.
struct LostBodies {
  std::optional<NotFinite> chosen;  ///< of the bodies measured and the static ones, which they are measured against
  std::optional<NotFinite> any;     ///< of all bodies
};

/// The first chosen body that was lost, for whatever reason.
struct FirstLost {
  sim::BodyId body = 0;
  std::uint64_t step = 0;  ///< whose state shows it
  std::optional<sim::Vec3>
      place;  ///< m, outside of where bodies belong, or not finite; none: no state has the body any more
};

/// Angular velocity in the body's own axes, rad/s.
sim::Vec3 spin_in_body(const sim::Vec3& inertia, const BodyStates& s, std::size_t row);

/// The box of a body where a state has it.
sim::BoxFrame frame_of(const sim::BoxDef& box, const BodyStates& s, std::size_t row);

/// Measures the states of one session, in order, against its start. Uses only what a log holds: the scene's boxes, the
/// states and the inputs.
class StateMeter {
 public:
  /// scene: its boxes define the bodies of the start, its gravity is that of the start. start: the state to compare
  /// with, as stored, with positions rounded to their grid.
  /// shapes: of bodies that are no boxes.
  StateMeter(const sim::SceneDef& scene, BodyStates start, const MeasureOptions& options = {}, BodyTable shapes = {});

  /// The session tells no inputs that could drive its bodies, as one of another engine: a speed that a body gains by at
  /// most kDrivenGain in a step counts as given.
  void take_told_speeds() { told_speeds_ = true; }

  /// Takes the shapes of bodies that appear in a step. Call it before apply() of that step's inputs.
  void describe(const Extras& extras);

  /// Takes an input. Call it before measuring the state that follows.
  void apply(const sim::Command& input);

  /// Measures a state, the one after `step`. Bodies that are defined neither by the scene nor by a throw are left out.
  /// From the first state on in which a chosen or static body is not finite, every measure is NaN.
  /// dt: of the step that led to it, s.
  StateMeasures measure(const BodyStates& now, std::uint64_t step = 0, double dt = 0);

  /// The deepest overlap of two boxes in a state, at least one of them chosen, m; NaN once any body was not finite.
  /// Slower than all of measure().
  double overlap_max(const BodyStates& now);

  /// The kinetic energy of all bodies in a state, J, with the inertia of their shapes; none where all are boxes, whose
  /// energy the log has.
  [[nodiscard]] std::optional<double> kinetic_by_shapes(const BodyStates& now);

  /// For people: what is not measured, or not exactly, for the shapes of bodies. Empty where all are boxes.
  [[nodiscard]] std::vector<std::string> approximations() const;

  /// Chosen bodies that were lost in any state measured so far.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  [[nodiscard]] const std::optional<FirstLost>& first_lost() const { return first_lost_; }

  /// The bodies that were not finite in any state measured so far.
  [[nodiscard]] const LostBodies& not_finite() const { return not_finite_; }

  /// The results of BodyTrack over the steps so far: the worst of any chosen body; bounces: the fewest.
  struct Keeping {
    std::optional<double> momentum_drift;
    std::optional<double> spin_energy_gain;
    std::optional<double> bounce_height_loss;
    std::uint64_t bounces = 0;
  };
  [[nodiscard]] Keeping keeping() const;

  /// Kinetic and potential energy of the start, J, of all bodies, chosen or not. above_rest: the part above the lowest
  /// rest, in which every box lies on the ground on its largest face.
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
    sim::Vec3 inertia;                   // kg·m², own axes
    std::shared_ptr<const Shape> shape;  // null: the box
    BodyTrack track;
    bool measured = false;  // dynamic and chosen
    bool in_start = false;
    bool removed = false;
    bool lost = false;
    bool not_finite = false;  // in this state or an earlier one
    double given_speed = 0;   // m/s, by the start and inputs, and by the states where told_speeds_
    double told_speed = 0;    // m/s, in the state before
    double driven_speed = 0;  // m/s, told_speed without the leaps of more than kDrivenGain
    double given_way = 0;     // m, at given_speed so far
    std::size_t start_row = 0;
    std::size_t grid_row = kNone;  // index into grid_rows_
  };
  // The extent of one grid row in the state being measured, m: along the other horizontal axis, and upwards.
  struct GridRow {
    double across_low, across_high, z_low, z_high;
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  [[nodiscard]] Body body_of(const sim::BoxDef& box);
  double deepest_of_shapes(const BodyStates& now);
  void pass(const BodyStates& now, double dt);
  [[nodiscard]] double reasonable_way(const Body& body) const;
  void place(std::vector<Body>::iterator at, const sim::BoxDef& box);
  void give_speed(sim::BodyId id, double given, bool is_impulse);
  void number_grid_rows();
  void find_rows(const BodyStates& now);
  void find_not_finite(const BodyStates& now, std::uint64_t step);
  void measure_place(Body& body, const BodyStates& now, std::size_t row, StateMeasures& out);
  void measure_motion(Body& body, const BodyStates& now, std::size_t row, StateMeasures& out);
  void lose(Body& body, const std::optional<sim::Vec3>& place);
  void compare_with_start(const Body& body, const BodyStates& now, std::size_t row, StateMeasures& out) const;
  void widen_grid_row(const Body& body, const sim::Vec3& position);
  [[nodiscard]] std::optional<double> column_spread() const;

  BodyStates start_;
  MeasureOptions options_;
  BodyTable shapes_;
  bool told_speeds_ = false;
  bool has_shapes_ = false;      // of any body so far
  bool is_upper_bound_ = false;  // an overlap
  sim::Vec3 start_gravity_;      // m/s²
  sim::Vec3 gravity_;            // now
  bool ground_;
  ReasonableSpace space_;
  std::vector<Body> bodies_;  // ascending id; every one is in each state until it is removed
  std::uint64_t step_ = 0;    // of the state being measured
  std::uint64_t lost_ = 0;
  std::optional<FirstLost> first_lost_;
  LostBodies not_finite_;
  std::vector<GridRow> grid_rows_;
  std::vector<std::size_t> body_of_row_;  // of the rows of row_ids_: index into bodies_, or kNone
  std::vector<sim::BodyId> row_ids_;
};

}  // namespace tumble::replay
