// The fifteen axes of two boxes: separations by hand, refused axes, and the symmetry of the arithmetic.
#include "src/collide/box_pair.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>

#include "tests/support/sim_scenes.h"

namespace tumble::test {
namespace {

using sim::AxisSet;
using sim::BestAxes;
using sim::BoxFrame;
using sim::BoxPair;
using sim::kAxisCount;
using sim::kEdges;
using sim::kFaces;
using sim::kFacesOfA;
using sim::only;
using sim::Quat;
using sim::Vec3;

const double kHalfRoot = std::sqrt(0.5);
constexpr AxisSet kAll = kFaces | kEdges;

BoxFrame frame(const Vec3& position, const Vec3& size = {1, 1, 1}, const Quat& q = {}) {
  return {position, axes_of(normalised(q)), size * 0.5};
}

BoxFrame random_frame(Random& random, double spread) {
  const double x = random.uniform(-spread, spread), y = random.uniform(-spread, spread);
  const double z = random.uniform(-spread, spread);
  const double sx = random.uniform(0.2, 2), sy = random.uniform(0.2, 2), sz = random.uniform(0.2, 2);
  return frame({x, y, z}, {sx, sy, sz}, random.rotation());
}

// Unit cubes with centres (1.5, 0.25, 0.125) apart: gaps 1.5 − 1, 0.25 − 1, 0.125 − 1 along x, y, z, on both boxes.
TEST(BoxPair, FaceSeparationsOfAlignedCubes) {
  const BoxFrame a = frame({1, 2, 3}), b = frame({2.5, 2.25, 3.125});
  const BoxPair pair(a, b);
  const BestAxes x = pair.best(only(0)), y = pair.best(only(4)), z = pair.best(only(2));
  EXPECT_EQ(x.separation, 0.5);
  EXPECT_EQ(y.separation, -0.75);
  EXPECT_EQ(z.separation, -0.875);
  EXPECT_EQ(pair.separating(kFaces), only(0) | only(3));
  EXPECT_EQ(pair.best(kFaces).axes, only(0) | only(3)) << "an exact tie keeps both";
  EXPECT_EQ(pair.normal(0), Vec3(1, 0, 0));
  EXPECT_EQ(BoxPair(b, a).normal(0), Vec3(-1, 0, 0)) << "from a to b";
}

// b turned 45° about z reaches √½ along x: a gap of 1.5 − ½ − √½ on a's face; on b's face, whose normal is
// (√½, √½, 0), the centres are 1.5·√½ apart and a reaches √½ too: 1.5·√½ − ½ − √½.
TEST(BoxPair, FaceSeparationsOfATurnedCube) {
  const BoxFrame a = frame({0, 0, 0}), b = frame({1.5, 0, 0.25}, {1, 1, 1}, turn({0, 0, 1}, kHalfRoot, kHalfRoot));
  const BoxPair pair(a, b);
  EXPECT_NEAR(pair.best(only(0)).separation, 1 - kHalfRoot, 1e-15);
  EXPECT_NEAR(pair.best(only(3)).separation, 0.5 * kHalfRoot - 0.5, 1e-15);
  EXPECT_EQ(pair.best(kFacesOfA).axes, only(0));
}

// Beams along x and y, each standing on an edge (turned 45° about its own length): only x × y = z keeps them apart,
// 2 m less twice √½. Edge axis 6 + 3·0 + 1.
TEST(BoxPair, EdgeSeparationOfCrossedBeams) {
  const BoxFrame a = frame({0, 0, 0}, {4, 1, 1}, turn({1, 0, 0}, kHalfRoot, kHalfRoot));
  const BoxFrame b = frame({0.3, 0.2, 2}, {1, 4, 1}, turn({0, 1, 0}, kHalfRoot, kHalfRoot));
  const BoxPair pair(a, b);
  EXPECT_EQ(pair.best(kAll).axes, only(7));
  EXPECT_NEAR(pair.best(only(7)).separation, 2 - 2 * kHalfRoot, 1e-15);
  EXPECT_LT((pair.normal(7) - Vec3(0, 0, 1)).cwiseAbs().maxCoeff(), 1e-15);
}

// Zero offset has no direction: two cubes above each other are not pushed apart sideways, whichever overlap is least.
TEST(BoxPair, AxisWithoutOffsetIsSkipped) {
  const BoxFrame a = frame({0, 0, 0}, {0.1, 0.1, 1}), b = frame({0, 0, 0.5}, {0.1, 0.1, 1});
  const BestAxes best = BoxPair(a, b).best(kAll);
  EXPECT_EQ(best.axes, only(2) | only(5)) << "least overlap would be 0.1 along x and y";
  EXPECT_EQ(best.separation, -0.5);
  const BestAxes in_one_place = BoxPair(a, a).best(kAll);
  EXPECT_EQ(in_one_place.axes, 0);
}

// Findings 3: an edge axis with |c · face normal| > 0.999 repeats a face. Aligned boxes have no other edge axes, nor
// has any pair that shares one axis (here z): every cross product is a face normal of one of them.
TEST(BoxPair, EdgeAxesParallelToAFaceAreRefused) {
  const BoxFrame a = frame({0, 0, 0});
  for (const double angle : {0.0, 1e-9, 1e-3, 0.3, 0.7}) {
    const BoxFrame b = frame({0.7, 0.3, 0.5}, {1, 1, 1}, {std::cos(angle / 2), 0, 0, std::sin(angle / 2)});
    EXPECT_EQ(BoxPair(a, b).best(kEdges).axes, 0) << angle;
  }
}

// The rule restated, for random boxes and for boxes nearly aligned.
TEST(BoxPair, EdgeAxisCountsExactlyWhenItIsNeitherShortNorFaceLike) {
  Random random(4);
  int accepted = 0, refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const BoxFrame a = random_frame(random, 1);
    BoxFrame b = random_frame(random, 1);
    if (trial % 2 == 0) {
      const double s = random.uniform(0, 0.2);
      const Quat small = {1, random.uniform(-s, s), random.uniform(-s, s), random.uniform(-s, s)};
      b.axes = axes_of(normalised(small));
      for (sim::Vec3& axis : b.axes.axis) axis = to_world(a.axes, axis);
    }
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        const Vec3 c = a.axes[i].cross(b.axes[j]);
        double face_like = 0;
        for (int k = 0; k < 3; ++k) {
          face_like = std::max({face_like, std::fabs(c.dot(a.axes[k])), std::fabs(c.dot(b.axes[k]))});
        }
        const double cosine = face_like / c.norm();
        if (std::fabs(cosine - 0.999) < 1e-9 || std::fabs(c.squaredNorm() - 1e-6) < 1e-12) continue;
        const bool wanted = c.squaredNorm() > 1e-6 && cosine < 0.999;
        const AxisSet found = BoxPair(a, b).best(only(6 + 3 * i + j)).axes;
        EXPECT_EQ(found != 0, wanted) << "cosine " << cosine << ", length " << c.norm();
        ++(wanted ? accepted : refused);
      }
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 1000);
}

// Along any unit axis n the gap is |d · n| minus both boxes' reach, Σ h_k |axis_k · n|.
TEST(BoxPair, SeparationIsTheGapBetweenTheProjections) {
  Random random(8);
  for (int trial = 0; trial < 1000; ++trial) {
    const BoxFrame a = random_frame(random, 3), b = random_frame(random, 3);
    const BoxPair pair(a, b);
    for (int axis = 0; axis < kAxisCount; ++axis) {
      const BestAxes best = pair.best(only(axis));
      if (best.axes == 0) continue;
      const Vec3 n = pair.normal(axis);
      EXPECT_NEAR(n.norm(), 1, 1e-14);
      double gap = (b.position - a.position).dot(n);
      EXPECT_GT(gap, 0) << "the normal points from a to b";
      for (int k = 0; k < 3; ++k) {
        gap -= a.half_extent[k] * std::fabs(a.axes[k].dot(n)) + b.half_extent[k] * std::fabs(b.axes[k].dot(n));
      }
      EXPECT_NEAR(best.separation, gap, 1e-13) << "axis " << axis;
      EXPECT_EQ(pair.separating(only(axis)) != 0, best.separation >= 0);
    }
  }
}

int exchanged(int axis) { return axis < 6 ? (axis + 3) % 6 : 6 + 3 * ((axis - 6) % 3) + (axis - 6) / 3; }

// Which of two boxes is called a must not move a bit.
TEST(BoxPair, ExchangingTheBoxesGivesTheSameBits) {
  Random random(15);
  for (int trial = 0; trial < 2000; ++trial) {
    const BoxFrame a = random_frame(random, 1), b = random_frame(random, 1);
    const BoxPair there(a, b), back(b, a);
    for (int axis = 0; axis < kAxisCount; ++axis) {
      const BestAxes one = there.best(only(axis)), other = back.best(only(exchanged(axis)));
      ASSERT_EQ(one.axes != 0, other.axes != 0);
      if (one.axes == 0) continue;
      EXPECT_EQ(std::bit_cast<std::uint64_t>(one.separation), std::bit_cast<std::uint64_t>(other.separation));
      EXPECT_EQ(there.normal(axis), Vec3(-back.normal(exchanged(axis))));
    }
  }
}

}  // namespace
}  // namespace tumble::test
