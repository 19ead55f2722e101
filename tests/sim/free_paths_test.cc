// Free paths of many pairs, with box tests in lanes, against the paths of one pair after the other.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <vector>

#include "src/kernels/kernels_by_width.h"
#include "src/layered/find/find_near_pairs.h"
#include "src/layered/find/free_path.h"
#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::Approach;
using sim::BodyIndex;
using sim::FreePaths;
using sim::Vec3;

constexpr double kDt = 1.0 / 60;

// Boxes that fly and turn close to each other, cubes and long ones, a few of which do not move.
sim::SceneDef swarm(Random& random) {
  sim::SceneDef scene = empty_space();
  scene.world.method = sim::Method::kLayered;
  scene.world.dt = kDt;
  scene.world.air_drag = random.next() % 2 == 0 ? 0 : 0.3;
  const double speed = random.uniform(0, 20), spin = random.uniform(0, 60);
  const auto any = [&](double most) {
    return Vec3(random.uniform(-most, most), random.uniform(-most, most), random.uniform(-most, most));
  };
  for (sim::BodyId id = 1; id <= 60; ++id) {
    const auto edge = [&] { return random.uniform(0.2, 1); };
    const double cube = edge();
    sim::BoxDef b = box(id, random.next() % 2 == 0 ? Vec3::Constant(cube) : Vec3(edge(), edge(), edge()), any(2.5));
    b.orientation = random.rotation();
    b.is_static = random.next() % 8 == 0;
    if (!b.is_static) {
      b.velocity = any(speed);
      b.spin = any(spin);
    }
    scene.boxes.push_back(b);
  }
  return scene;
}

// The pairs of the swarm that the broad phase keeps, each followed with a margin.
struct Followed {
  std::vector<Approach> found, wanted;

  Followed(sim::World& world, sim::LaneWidth width, Random& random) {
    sim::Scratch& scratch = world.mutable_scratch();
    scratch.lanes = width;
    const sim::PairTable& pairs = world.state().pairs;
    const FreePaths paths(world.state(), scratch, kDt);
    std::vector<FreePaths::Query> queries;
    found.resize(pairs.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const double margin = random.next() % 2 == 0 ? 0 : 0.05;
      queries.push_back({pairs.a[k], pairs.b[k], margin, &found[k]});
      wanted.push_back(paths.follow(pairs.a[k], pairs.b[k], margin));
    }
    paths.follow_all(queries);
  }
};

TEST(FreePaths, ManyAtOnceEndAsOneByOne) {
  std::array<std::size_t, 4> kinds{};
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    sim::World world = made(swarm(random));
    ASSERT_TRUE(run_phase(sim::find_near_pairs, world, kDt).ok());
    for (const sim::LaneWidth width : {sim::LaneWidth::kOne, sim::LaneWidth::kTwo, sim::LaneWidth::kWidest}) {
      if (!sim::runs_lanes(width)) continue;
      const Followed followed(world, width, random);
      for (std::size_t k = 0; k < followed.found.size(); ++k) {
        const Approach &found = followed.found[k], &wanted = followed.wanted[k];
        ASSERT_EQ(found.kind, wanted.kind) << "seed " << seed << ", pair " << k;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(found.time_s), std::bit_cast<std::uint64_t>(wanted.time_s));
        ++kinds[static_cast<std::size_t>(wanted.kind)];
      }
    }
  }
  for (const std::size_t count : kinds) EXPECT_GT(count, 100U);
}

}  // namespace
}  // namespace tumble::test
