#pragma once

#include <cstdint>
#include <vector>

#include "tumble/sim/step.h"
#include "tumble/sim/world.h"

/// Scenes for the tests of the simulation, built in code so that those tests need no files, and short-hands to run
/// them. SI units, z up; ids ascend from 1.
namespace tumble::test {

/// Uniform numbers from a seed (SplitMix64): the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// In [low, high).
  double uniform(double low, double high);
  /// Any rotation; not normalised, never zero.
  sim::Quat rotation();

 private:
  std::uint64_t state_;
};

/// Each coordinate in [−limit, limit).
sim::Vec3 random_vector(Random& random, double limit);

/// Fisher-Yates.
template <class T>
void shuffle(std::vector<T>& items, Random& random) {
  for (std::size_t k = items.size(); k > 1; --k) std::swap(items[k - 1], items[random.next() % k]);
}

/// A unit cube of 1 kg at rest, friction 0.4, restitution 0.2.
sim::BoxDef cube(sim::BodyId id, const sim::Vec3& position);
/// A box of 1000 kg/m³.
sim::BoxDef box(sim::BodyId id, const sim::Vec3& size, const sim::Vec3& position);
/// The rotation about a unit axis whose cosine and sine (of the whole angle, sine >= 0) are given.
sim::Quat turn(const sim::Vec3& axis, double cosine, double sine);

/// A world without ground, gravity and freezing, in which nothing happens that a test has not asked for.
sim::SceneDef empty_space();
/// The default world, with ground.
sim::SceneDef on_ground();

/// The thesis's comparison scene (Fig. 21): n × n cubes in a plane tilted 45° about x, 1.25 m apart; id = 1 + row·n +
/// column.
sim::SceneDef tilted_grid(std::uint32_t n);
sim::SceneDef tower(std::uint32_t count);
sim::SceneDef pyramid(std::uint32_t base);
/// Bricks of 2 × 1 × 1 m and 2 kg in courses along x, shifted by turns.
sim::SceneDef wall(std::uint32_t courses, std::uint32_t bricks);
/// n³ cubes, 1.1 m apart.
sim::SceneDef pile(std::uint32_t n);
/// n³ uneven boxes, turned, spinning and flying in all directions.
sim::SceneDef tumble_of_boxes(std::uint32_t n, std::uint64_t seed);
/// 19 cubes whose volumes span 15,625 : 1, dropped clear of each other.
sim::SceneDef size_ratio();
/// Thin plates and long bars, dropped in a heap.
sim::SceneDef plates_and_bars(std::uint32_t count, std::uint64_t seed);
/// Boxes dropped on a static ramp of 20 degrees or so.
sim::SceneDef ramp(std::uint32_t count, std::uint64_t seed);

/// Moves each box by up to ±amount horizontally and turns it a little about z.
void jitter(sim::SceneDef& scene, double amount, std::uint64_t seed);
/// Everything in the scene starts frozen.
void freeze_all(sim::SceneDef& scene);
/// A 2 m cube of 20 kg thrown at what stands around the origin; its id is one above the others.
void add_thrown_cube(sim::SceneDef& scene);

/// Runs one phase on a world.
inline Status run_phase(Status (*phase)(sim::WorldState&, sim::Scratch&, double), sim::World& world, double dt_s) {
  return phase(world.mutable_state(), world.mutable_scratch(), dt_s);
}

/// create_world, step() and apply(); each throws std::runtime_error with the message when there is an error.
sim::World made(const sim::SceneDef& scene);
sim::StepCounters advance(sim::World& world, sim::Observer* observer = nullptr);
/// The world after so many steps.
sim::World after_steps(const sim::SceneDef& scene, int steps);
void give(sim::World& world, const sim::Command& command);

/// The phase hashes of so many steps of a world, one after the other; throws likewise.
std::vector<std::uint64_t> phase_words_of(sim::World& world, int steps);

}  // namespace tumble::test
