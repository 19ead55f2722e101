// A camera moved by hand, and the body under a pixel.
#include <gtest/gtest.h>

#include "src/render/scene/camera_moves.h"
#include "src/render/scene/pick.h"
#include "src/render/scene/view.h"
#include "tests/support/pictures.h"

namespace tumble::render {
namespace {

using sim::Vec3;

double distance_of(const sim::Camera& camera) { return sim::length(camera.target - camera.position); }

TEST(CameraMoves, TurningKeepsDistanceAndTarget) {
  sim::Camera camera;
  const sim::Camera before = camera;
  orbit(camera, 90, 0, true);
  EXPECT_EQ(camera.target, before.target);
  EXPECT_NEAR(distance_of(camera), distance_of(before), 1e-9);
  EXPECT_NEAR(camera.position.z(), before.position.z(), 1e-9);
  const Vec3 was = before.position - before.target;
  EXPECT_NEAR(camera.position.x(), before.target.x() - was.y(), 1e-9) << "counter-clockwise, seen from above";
  orbit(camera, -90, 0, true);
  EXPECT_NEAR(sim::length(Vec3(camera.position - before.position)), 0, 1e-9);
}

TEST(CameraMoves, TheEyeStaysAboveTheGroundAndBesideTheVertical) {
  sim::Camera camera;
  orbit(camera, 0, -500, true);
  EXPECT_GT(camera.position.z(), 0);
  orbit(camera, 0, -500, false);
  EXPECT_LT(camera.position.z(), 0);
  orbit(camera, 0, 500, true);
  const Vec3 out = camera.position - camera.target;
  EXPECT_GT(sim::length(Vec3(out.x(), out.y(), 0)), 0.01 * distance_of(camera));
}

TEST(CameraMoves, ShiftsByHeightsOfThePicture) {
  sim::Camera camera;
  const View before = camera_view(camera, 400, 300);
  const Vec3 target = camera.target;
  pan(camera, 0, 0.5);
  // The old target is now half a picture's height below the middle: at its lower edge.
  const View after = camera_view(camera, 400, 300);
  const Vec3 offset = target - after.eye;
  EXPECT_NEAR(sim::dot(offset, after.up) / sim::dot(offset, after.forward), -after.tangent_y, 1e-9);
  EXPECT_NEAR(sim::length(Vec3(before.forward - after.forward)), 0, 1e-12);
}

TEST(CameraMoves, ZoomKeepsTheFocusOnWhatItWasOn) {
  sim::Camera camera;
  const double share = camera.focus / distance_of(camera);
  zoom(camera, 0.5);
  EXPECT_NEAR(camera.focus / distance_of(camera), share, 1e-12);
  zoom(camera, 1e-9);
  EXPECT_GT(distance_of(camera), 0.09);
}

TEST(Pick, FindsTheBoxThatIsDrawnThere) {
  const Snapshot snapshot = test::three_boxes();
  const View view = camera_view(snapshot.camera, 160, 120);
  for (const BoxLook& box : snapshot.boxes) {
    const Vec3 to = box.centre - view.eye;
    const double depth = sim::dot(to, view.forward);
    const double x = 0.5 + 0.5 * sim::dot(to, view.right) / (depth * view.tangent_x);
    const double y = 0.5 - 0.5 * sim::dot(to, view.up) / (depth * view.tangent_y);
    const std::optional<Hit> hit = pick(snapshot, ray_through(view, x, y));
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->id, box.id);
    const Vec3 inside = hit->point - box.centre;
    EXPECT_LT(sim::length(inside), sim::length(box.half_extent) + 1e-9);
    EXPECT_LT(hit->distance, sim::length(to)) << "on the near side";
  }
  EXPECT_FALSE(pick(snapshot, ray_through(view, 0.01, 0.01))) << "the sky";
}

TEST(Pick, TakesTheNearestAndNoneAroundTheEye) {
  Snapshot snapshot;
  for (std::uint64_t id = 1; id <= 3; ++id) {
    BoxLook box;
    box.id = id;
    box.centre = {0, 10.0 - 3 * static_cast<double>(id), 0};
    snapshot.boxes.push_back(box);
  }
  const std::optional<Hit> hit = pick(snapshot, {{0, 0.5, 0}, {0, 1, 0}});  // inside box 3
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->id, 2U);
  EXPECT_DOUBLE_EQ(hit->point.y(), 3);
}

}  // namespace
}  // namespace tumble::render
