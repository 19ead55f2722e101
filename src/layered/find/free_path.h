#pragma once

#include "src/kernels/box_frame.h"
#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Free flights of bodies, turns included. State and scratch must outlive the object.
class FreePaths {
 public:
  /// dt_s: the length of a flight.
  FreePaths(const WorldState& state, const Scratch& scratch, double dt_s);

  /// How far corners leave the tangents of their paths within dt_s, m, at most. a may be kGround.
  [[nodiscard]] double bend(BodyIndex a, BodyIndex b) const;

  /// Follows both bodies until they touch or dt_s ends. margin: m, tells kNear from kPassing; 0: finds no kNear. a may
  /// be kGround.
  /// Source: conservative advancement, Mirtich (1996), section 2.3, along the normals of the separating-axis test.
  [[nodiscard]] Approach follow(BodyIndex a, BodyIndex b, double margin) const;

 private:
  struct Flyer;
  [[nodiscard]] Flyer flyer(BodyIndex i) const;
  void advance(Flyer& flyer, double time_s, double by_s) const;
  [[nodiscard]] double wait(const Flyer& a, const Flyer& b, double& separation) const;

  const WorldState& state_;
  const Scratch& scratch_;
  double dt_;
};

}  // namespace tumble::sim
