// The box test in lanes against BoxPair, bit for bit, over boxes of every kind that the test treats in a way of its
// own.
#include "src/kernels/box_tests.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "src/collide/box_pair.h"
#include "src/kernels/kernels_by_width.h"
#include "src/math/half_turn.h"
#include "tests/support/sim_scenes.h"

namespace tumble::sim {
namespace {

constexpr std::uint64_t kSeeds = 2000;

using Maker = std::function<std::pair<BoxFrame, BoxFrame>(test::Random&)>;

Vec3 vector_in(test::Random& random, double low, double high) {
  const double x = random.uniform(low, high), y = random.uniform(low, high), z = random.uniform(low, high);
  return {x, y, z};
}

BoxFrame box_at(const Vec3& position, const Vec3& half_extent, const Quat& orientation = {}) {
  return {position, axes_of(normalised(orientation)), half_extent};
}

BoxFrame random_box(test::Random& random, double reach) {
  return box_at(vector_in(random, -reach, reach), vector_in(random, 0.1, 1), random.rotation());
}

// On a lattice of half sizes: touching, coincident and tied, and with no offset along some axes.
BoxFrame lattice_box(test::Random& random) {
  const auto lattice = [&](int low, int high) { return 0.5 * std::floor(random.uniform(low, high + 1)); };
  const Vec3 position(lattice(-2, 2), lattice(-2, 2), lattice(-2, 2));
  return box_at(position, {lattice(1, 2), lattice(1, 2), lattice(1, 2)});
}

// b stands as a does, but for up to so much.
std::pair<BoxFrame, BoxFrame> nearly_parallel(test::Random& random, double turn) {
  const Quat q = normalised(random.rotation());
  const BoxFrame a = box_at(vector_in(random, -1, 1), vector_in(random, 0.1, 1), q);
  const Quat other = turned(q, vector_in(random, -turn, turn));
  return {a, box_at(vector_in(random, -1, 1), vector_in(random, 0.1, 1), other)};
}

// Nothing changes when x and y are exchanged, so edges tie.
std::pair<BoxFrame, BoxFrame> mirrored_in_diagonal(test::Random& random) {
  const double across = random.uniform(0.1, 1), along = random.uniform(-1, 1), turn = random.uniform(-1, 1);
  const Vec3 half_extent(across, across, random.uniform(0.1, 1)), position(along, along, random.uniform(-1, 1));
  return {box_at({0, 0, 0}, half_extent), box_at(position, half_extent, {1, turn, -turn, 0})};
}

BoxFrame plate(test::Random& random) {
  return box_at(vector_in(random, -0.3, 0.3), {0.6, 0.6, 0.01}, random.rotation());
}

const std::vector<Maker>& makers() {
  static const std::vector<Maker> kMakers = {
      [](test::Random& r) { return std::pair(random_box(r, 1), random_box(r, 1)); },
      [](test::Random& r) { return std::pair(random_box(r, 100), random_box(r, 100)); },
      [](test::Random& r) { return std::pair(lattice_box(r), lattice_box(r)); },
      [](test::Random& r) { return std::pair(lattice_box(r), random_box(r, 1)); },
      mirrored_in_diagonal,
      [](test::Random& r) { return nearly_parallel(r, 0); },
      [](test::Random& r) { return nearly_parallel(r, 0.0005); },  // about where edges count as parallel
      [](test::Random& r) { return nearly_parallel(r, 0.04); },    // about where edges count as facelike
      [](test::Random& r) { return std::pair(plate(r), plate(r)); },
      [](test::Random& r) { return std::pair(plate(r), lattice_box(r)); },
  };
  return kMakers;
}

struct Pairs {
  std::vector<BoxFrame> frames;
  BoxTests tests;

  Pairs(std::uint64_t seed, std::size_t count) {
    test::Random random(seed);
    tests.count = count;
    for (std::size_t k = 0; k < count; ++k) {
      const auto& [a, b] = makers()[random.next() % makers().size()](random);
      tests.a[k] = static_cast<std::uint32_t>(frames.size());
      tests.b[k] = tests.a[k] + 1;
      frames.insert(frames.end(), {a, b});
      // At times not where the frames are, as for pairs that meet later.
      const Vec3 moved = random.next() % 8 == 0 ? vector_in(random, -1, 1) : Vec3(Vec3::Zero());
      for (int axis = 0; axis < 3; ++axis) tests.offset[axis][k] = offset(k)[axis] + moved[axis];
    }
    tests.frames = frames.data();
  }

  [[nodiscard]] Vec3 offset(std::size_t k) const { return frames[2 * k + 1].position - frames[2 * k].position; }
  [[nodiscard]] BoxPair reference(std::size_t k) const {
    return {frames[2 * k], frames[2 * k + 1], {tests.offset[0][k], tests.offset[1][k], tests.offset[2][k]}};
  }
};

bool same(const BoxTests::Best& x, const BoxTests::Best& y, std::size_t k) {
  return x.axes[k] == y.axes[k] &&
         std::bit_cast<std::uint64_t>(x.separation[k]) == std::bit_cast<std::uint64_t>(y.separation[k]);
}

bool same(const BestAxes& best, const BoxTests::Best& found, std::size_t k) {
  return best.axes == found.axes[k] &&
         std::bit_cast<std::uint64_t>(best.separation) == std::bit_cast<std::uint64_t>(found.separation[k]);
}

// find_all against the kernels of single kinds, and BoxPair::apart_along_facelike_edges.
void expect_all_together(const BoxTestKernels& box_tests, const Pairs& pairs, const char* width) {
  const BoxTests& single = pairs.tests;
  BoxTests all = pairs.tests;
  all.faces_of_a = all.faces_of_b = all.edges = {};
  box_tests.find_all(all);
  for (std::size_t k = 0; k < all.count; ++k) {
    EXPECT_TRUE(same(single.faces_of_a, all.faces_of_a, k)) << width;
    EXPECT_TRUE(same(single.faces_of_b, all.faces_of_b, k)) << width;
    EXPECT_TRUE(same(single.edges, all.edges, k)) << width;
    EXPECT_EQ(all.apart_along_facelike[k], pairs.reference(k).apart_along_facelike_edges() ? 1 : 0) << width;
  }
}

TEST(BoxTests, EveryWidthGivesTheBitsOfBoxPair) {
  for (const LaneWidth width :
       {LaneWidth::kOne, LaneWidth::kTwo, LaneWidth::kFour, LaneWidth::kEight, LaneWidth::kWidest}) {
    if (!runs_lanes(width)) continue;
    const BoxTestKernels& box_tests = kernels(width).box_tests;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      Pairs pairs(seed, 1 + seed % BoxTests::kMost);
      box_tests.find_faces(pairs.tests);
      box_tests.find_edges(pairs.tests);
      box_tests.find_best(pairs.tests);
      for (std::size_t k = 0; k < pairs.tests.count; ++k) {
        const BoxPair pair = pairs.reference(k);
        ASSERT_TRUE(same(pair.best(kFacesOfA), pairs.tests.faces_of_a, k)) << name_of(width) << ", seed " << seed;
        ASSERT_TRUE(same(pair.best(kFacesOfB), pairs.tests.faces_of_b, k)) << name_of(width) << ", seed " << seed;
        ASSERT_TRUE(same(pair.best(kEdges), pairs.tests.edges, k)) << name_of(width) << ", seed " << seed;
        ASSERT_TRUE(same(pair.best_of_all(), pairs.tests.all, k)) << name_of(width) << ", seed " << seed;
        ASSERT_EQ(pair.second(kFacesOfA), pairs.tests.second_of_a[k]) << name_of(width) << ", seed " << seed;
        ASSERT_EQ(pair.second(kFacesOfB), pairs.tests.second_of_b[k]) << name_of(width) << ", seed " << seed;
      }
      expect_all_together(box_tests, pairs, name_of(width));
    }
  }
}

// Otherwise the test above would prove less than it says.
TEST(BoxTests, InputHasEveryKindOfAnswer) {
  std::array<int, 3> without{}, single{}, tied{};
  int edges_win = 0, facelike_part = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Pairs pairs(seed, BoxTests::kMost);
    for (std::size_t k = 0; k < BoxTests::kMost; ++k) {
      const BoxPair pair = pairs.reference(k);
      const std::array<BestAxes, 3> best = {pair.best(kFacesOfA), pair.best(kFacesOfB), pair.best(kEdges)};
      for (std::size_t set = 0; set < best.size(); ++set) {
        const int axes = std::popcount(best[set].axes);
        ++(axes == 0 ? without : axes == 1 ? single : tied)[set];
      }
      if (best[2].axes != 0 && best[2].separation > larger_separation(best[0], best[1])) ++edges_win;
      if (pair.apart_along_facelike_edges()) ++facelike_part;
    }
  }
  for (std::size_t set = 0; set < 3; ++set) {
    EXPECT_GT(without[set], 10) << set;
    EXPECT_GT(single[set], 1000) << set;
    EXPECT_GT(tied[set], 10) << set;
  }
  EXPECT_GT(edges_win, 100);
  EXPECT_GT(facelike_part, 100);
}

}  // namespace
}  // namespace tumble::sim
