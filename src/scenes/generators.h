#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "src/scenes/read_bodies.h"
#include "tumble/sim/scene.h"

namespace tumble::scenes {

// The shapes of the generators, in the words of the scene format. Lengths in m, angles in degrees.

/// rows × cols boxes in a plane tilted about x.
struct GridShape {
  std::uint64_t rows = 20;
  std::uint64_t cols = 20;
  double pitch = 1.25;
  double tilt = 45;
  double base = 0.5;
};
/// count boxes on top of each other, each `taper` times the one below in every edge.
struct TowerShape {
  std::uint64_t count = 10;
  double taper = 1;
  sim::Vec3 position = {0, 0, 0};
};
/// Rows of base, base − 1, …, 1 boxes along x.
struct PyramidShape {
  std::uint64_t base = 20;
  double spacing = 1.05;
  sim::Vec3 position = {0, 0, 0};
};
/// Courses of bricks along x, even ones moved by −shift, odd ones by +shift.
struct WallShape {
  std::uint64_t courses = 17;
  std::uint64_t bricks = 13;
  double spacing = 2.02;
  double shift = 0.5;
  sim::Vec3 position = {0, 0, 0};
};
/// Boxes at the points of a lattice.
struct PileShape {
  std::uint64_t nx = 8, ny = 8, nz = 8;
  double pitch = 1.1;
  sim::Vec3 position = {0, 0, 1};
};
using Shape = std::variant<GridShape, TowerShape, PyramidShape, WallShape, PileShape>;

/// Body k of a generator is moved by `position` times a uniform number of [−1, 1) along x and another along y, and
/// turned about the vertical by `degrees` times a third: draws 0, 1, 2 of (seed, k) in src/base/rng.h.
struct Jitter {
  double position = 0;
  double degrees = 0;
  std::uint64_t seed = 0;
};

/// One table [[grid]], [[tower]], [[pyramid]], [[wall]] or [[pile]].
struct Generator {
  std::uint32_t table = 0;  ///< 0-based among the tables of its kind
  Shape shape;
  BodyTemplate body;
  Jitter jitter;
  std::optional<sim::BodyId> first_id;
};

/// The number of bodies of a shape, or nothing above kBodiesMax. Each count of the shape must be at most
/// kBodiesMax itself.
std::optional<std::uint64_t> body_count(const Shape& shape);

/// The bodies, row by row, with ids 0. Precondition (SIM_CHECK): body_count() has a value.
std::vector<sim::BoxDef> generate(const Generator& generator);

}  // namespace tumble::scenes
