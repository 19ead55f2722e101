#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "src/world/scratch.h"
#include "tumble/sim/manifold.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// A separation that no motion closes, m.
inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// Where two bodies, or a body and the ground, are within a time as long as nothing changes their free flights.
struct Encounter {
  enum class Kind : std::uint8_t {
    kTouching,  ///< touch now
    kPassing,   ///< never touch, and stay farther apart than the margin
    kNear,      ///< never touch, but come within the margin
    kMeeting,   ///< touch within the step
  };
  /// A body at the meeting, and its mean velocities until then.
  struct Side {
    BoxFrame frame = {Vec3::Zero(), axes_of(Quat{}), Vec3::Zero()};
    Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
    Vec3 mean_velocity = Vec3::Zero(), mean_spin = Vec3::Zero();
  };
  Kind kind = Kind::kPassing;
  double time_s = 0;  ///< until the meeting; 0 for bodies that turn unevenly
  Side a, b;          ///< written for kMeeting only, like time_s

  /// Turns separations at the meeting into those of now, from which the points close evenly until the meeting. Points
  /// that close then and come within `reach`, m, in the `rest_s` after it are kept: what hits with one corner may hit
  /// with another in the same step. The separation of all others becomes kNever. reversed: whether b is the manifold's
  /// reference.
  void separate_as_now(const Manifold& m, bool reversed, double rest_s, double reach,
                       std::span<ManifoldPoint> points) const;
};

/// Free flights of a step's bodies, turns included. State and scratch must outlive the object and must not change.
class FreePaths {
 public:
  FreePaths(const WorldState& state, const Scratch& scratch, double dt_s);

  /// How far corners leave the tangents of their paths within the step, m, at most. a may be kGround.
  [[nodiscard]] double bend(BodyIndex a, BodyIndex b) const;

  /// Follows both bodies until they touch or the step ends. margin: m, tells kNear from kPassing; 0: finds no kNear.
  /// a may be kGround.
  /// Source: conservative advancement, Mirtich (1996), section 2.3, along the normals of the separating-axis test.
  [[nodiscard]] Encounter follow(BodyIndex a, BodyIndex b, double margin) const;

 private:
  struct Flyer;
  [[nodiscard]] Flyer flyer(BodyIndex i) const;
  void advance(Flyer& flyer, double time_s, double by_s) const;
  [[nodiscard]] double wait(const Flyer& a, const Flyer& b, double& separation) const;
  [[nodiscard]] Encounter meeting(const Flyer& a, const Flyer& b, double time_s) const;
  [[nodiscard]] Encounter::Side side(const Flyer& flyer, double time_s) const;

  const WorldState& state_;
  const Scratch& scratch_;
  double dt_;
};

}  // namespace tumble::sim
