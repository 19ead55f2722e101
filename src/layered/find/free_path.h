#pragma once

#include <cstddef>
#include <span>

#include "src/collide/box_pair.h"
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

  /// How much nearer two bodies, neither of them the ground, may come within dt_s, m, at most. Needs Scratch::turning
  /// of a time dt_s.
  [[nodiscard]] double way_most(BodyIndex a, BodyIndex b) const;

  /// A pair to follow, neither of them the ground, and what becomes of it.
  struct Query {
    BodyIndex a = 0, b = 0;
    double margin = 0;
    Approach* approach = nullptr;
  };
  /// follow() for each query, with the box tests of many pairs in lanes. Pairs that touch now or stay far apart are
  /// told from the others by the test of now alone. Needs Scratch::turning of a time dt_s.
  void follow_all(std::span<const Query> queries) const;

 private:
  struct Flyer;
  struct Course;
  [[nodiscard]] Flyer flyer(BodyIndex i) const;
  [[nodiscard]] Course course(BodyIndex a, BodyIndex b, double margin) const;
  void advance(Flyer& flyer, double time_s, double by_s) const;
  [[nodiscard]] double wait(const Flyer& a, const Flyer& b, const BestAxes& apart) const;
  [[nodiscard]] bool leaves(const Flyer& other, const Flyer& body, const Vec3& n) const;
  [[nodiscard]] Approach::Kind touching_or_parting(const Flyer& a, const Flyer& b, const BestAxes& apart) const;
  [[nodiscard]] bool go_on(Course& course, const BestAxes& apart, Approach& end) const;
  std::size_t leave_undecided(std::span<const Query> queries, const Query** undecided) const;
  void follow_undecided(std::span<const Query* const> queries) const;

  const WorldState& state_;
  const Scratch& scratch_;
  double dt_;
};

}  // namespace tumble::sim
