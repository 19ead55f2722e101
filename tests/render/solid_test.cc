// The surfaces of bodies that are no boxes: closed, facing outwards, of the right volume; and hulls of hard points.
#include "src/render/scene/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "src/render/scene/hull_faces.h"

namespace tumble::test {
namespace {

using render::Solid;
using sim::Vec3;

Vec3 vector_of(const float (&v)[3]) { return {double{v[0]}, double{v[1]}, double{v[2]}}; }

/// By the divergence theorem: right only where the surface is closed and faces outwards.
double volume(const Solid& solid) {
  double sum = 0;
  for (std::size_t k = 0; k + 2 < solid.corners.size(); k += 3) {
    const Vec3 a = vector_of(solid.corners[k].at), b = vector_of(solid.corners[k + 1].at),
               c = vector_of(solid.corners[k + 2].at);
    sum += sim::dot(a, sim::cross(b, c)) / 6;
  }
  return sum;
}

/// Every corner's normal is a unit vector on the outer side of its triangle.
void expect_outward(const Solid& solid) {
  for (std::size_t k = 0; k + 2 < solid.corners.size(); k += 3) {
    const Vec3 a = vector_of(solid.corners[k].at);
    const Vec3 face = sim::cross(vector_of(solid.corners[k + 1].at) - a, vector_of(solid.corners[k + 2].at) - a);
    for (std::size_t i = k; i < k + 3; ++i) {
      const Vec3 normal = vector_of(solid.corners[i].normal);
      EXPECT_NEAR(sim::length(normal), 1, 1e-6);
      EXPECT_GT(sim::dot(face, normal), 0) << k;
    }
  }
}

constexpr double kPi = 3.14159265358979323846;

TEST(Solids, RoundOnesHaveTheirVolume) {
  for (int axis = 0; axis < 3; ++axis) {
    const Solid sphere = render::make_capsule(axis, 0.5, 0), capsule = render::make_capsule(axis, 0.5, 2),
                cylinder = render::make_cylinder(axis, 0.5, 2);
    EXPECT_NEAR(volume(sphere), 4 * kPi / 3 / 8, 0.01);
    EXPECT_NEAR(volume(capsule), 4 * kPi / 3 / 8 + kPi, 0.02);
    EXPECT_NEAR(volume(cylinder), kPi, 0.02);
    expect_outward(sphere);
    expect_outward(capsule);
    expect_outward(cylinder);
    Vec3 reach = {0, 0, 0};
    for (const render::SolidVertex& corner : capsule.corners) {
      for (int k = 0; k < 3; ++k) reach[k] = std::max(reach[k], std::fabs(double{corner.at[k]}));
    }
    EXPECT_NEAR(reach[axis], 2.5, 1e-6);
    EXPECT_NEAR(reach[(axis + 1) % 3], 0.5, 1e-6);
  }
}

// So that a material is as fine on the caps as on the side.
TEST(Solids, PlacesAlongTheAxisAreLengthsOnTheSurface) {
  for (const Solid& solid : {render::make_cylinder(2, 0.5, 2), render::make_capsule(2, 0.5, 2)}) {
    std::size_t compared = 0;
    for (std::size_t k = 0; k + 2 < solid.corners.size(); k += 3) {
      for (std::size_t i = k; i < k + 3; ++i) {
        const render::SolidVertex &a = solid.corners[i], &b = solid.corners[i == k + 2 ? k : i + 1];
        if (a.place[0] != b.place[0]) continue;  // not one above the other
        const double along = std::fabs(double{a.place[1]} - double{b.place[1]});
        EXPECT_NEAR(along, sim::length(Vec3(vector_of(a.at) - vector_of(b.at))), 1e-3) << k;
        ++compared;
      }
    }
    EXPECT_GT(compared, 3U * render::kSolidParts);
  }
}

TEST(Solids, AHullLeavesOutWhatLiesInside) {
  std::vector<Vec3> points = {{0, 0, 0}, {0.5, 0.5, 0.5}, {0.1, 0.9, 0.3}};
  for (int k = 0; k < 8; ++k) points.push_back({double(k & 1), double(k / 2 & 1), double(k >> 2)});
  points.push_back({0.5, 0.5, 1});  // on a face
  const Solid hull = render::make_hull(points);
  EXPECT_NEAR(volume(hull), 1, 1e-6);
  expect_outward(hull);
  EXPECT_GE(hull.corners.size(), 36U);
  std::vector<Vec3> ball;  // points of a sphere, in a grid of angles, poles many times
  for (int i = 0; i <= 16; ++i) {
    for (int j = 0; j < 24; ++j) {
      const double a = kPi * i / 16, b = 2 * kPi * j / 24;
      ball.push_back({std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)});
    }
  }
  EXPECT_NEAR(volume(render::make_hull(ball)), 4 * kPi / 3, 0.15);
}

TEST(Solids, PointsWithoutAVolumeHaveNoHull) {
  EXPECT_TRUE(render::hull_faces(std::vector<Vec3>{}).empty());
  EXPECT_TRUE(render::hull_faces(std::vector<Vec3>(9, Vec3{1, 2, 3})).empty());
  EXPECT_TRUE(render::hull_faces(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}).empty());
  EXPECT_TRUE(render::hull_faces(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {5, 3, 0}}).empty());
}

TEST(Solids, AMeshIsSeenFromBothSides) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> triangles = {0, 1, 2};
  const Solid mesh = render::make_mesh(points, triangles);
  ASSERT_EQ(mesh.corners.size(), 6U);
  EXPECT_EQ(mesh.corners[0].normal[2], 1);
  EXPECT_EQ(mesh.corners[3].normal[2], -1);
  EXPECT_NEAR(volume(mesh), 0, 1e-12);
}

}  // namespace
}  // namespace tumble::test
