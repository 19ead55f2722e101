// Each effect changes what it should and nothing else; what is in the scene is in the picture.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/pictures.h"

namespace tumble::test {
namespace {

using render::Image;
using render::Snapshot;
using render::Stage;

constexpr std::uint64_t kPixels = 160 * 120;

bool is_white(int r, int g, int b) { return std::min({r, g, b}) >= 250; }

TEST(RenderPicture, IsTheSameEveryTime) {
  const Snapshot snapshot = three_boxes();
  const Image first = draw(snapshot);
  EXPECT_EQ(first, draw(snapshot));
  const auto renderer = render::Renderer::create({160, 120, 1, {}});
  ASSERT_TRUE(renderer.ok());
  Snapshot other = snapshot;
  other.boxes.pop_back();
  other.camera.position.x() += 3;
  ASSERT_TRUE((*renderer)->draw(other).ok());
  EXPECT_EQ(first, *(*renderer)->draw(snapshot)) << "what was drawn before left something behind";
}

TEST(RenderPicture, AMissingBoxIsSeen) {
  const Snapshot snapshot = three_boxes();
  const Image whole = draw(snapshot);
  for (std::size_t i = 0; i < snapshot.boxes.size(); ++i) {
    Snapshot less = snapshot;
    less.boxes.erase(less.boxes.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_GT(difference(whole, draw(less)).far_off, kPixels / 100) << "without box " << snapshot.boxes[i].id;
  }
}

TEST(RenderPicture, ACameraOnePercentOffIsSeen) {
  Snapshot moved = three_boxes();
  const Image before = draw(moved);
  moved.camera.position += (moved.camera.position - moved.camera.target) * 0.01;
  EXPECT_GT(difference(before, draw(moved)).far_off, kPixels / 200);
}

TEST(RenderPicture, NearerBoxesHideFartherOnesInAnyOrder) {
  Snapshot snapshot = three_boxes();
  const Image before = draw(snapshot);
  std::swap(snapshot.boxes[0], snapshot.boxes[2]);
  EXPECT_EQ(before, draw(snapshot));
}

TEST(RenderPicture, HasNoGroundWhereTheSceneHasNone) {
  Snapshot snapshot = three_boxes();
  const Image with = draw(snapshot, effects("none"));
  snapshot.ground = false;
  const PictureDifference found = difference(with, draw(snapshot, effects("none")));
  EXPECT_GT(found.far_off, kPixels / 4);
  EXPECT_LT(found.pixels, kPixels) << "the boxes stay";
}

TEST(RenderPicture, MarkersLieOverEverything) {
  Snapshot snapshot = three_boxes();
  snapshot.markers.push_back({{0, 0, 0.5}, {}, {0.1, 0.1, 0.1}, {1, 0.25, 0}});  // inside the crate
  const auto orange = [](int r, int g, int b) { return r == 255 && g == 128 && b == 0; };
  EXPECT_GT(count_pixels(draw(snapshot, effects("none")), orange), 20U);
  snapshot.markers.clear();
  EXPECT_EQ(count_pixels(draw(snapshot, effects("none")), orange), 0U);
}

TEST(RenderEffects, ShadowsOnlyDarken) {
  const PictureDifference found =
      difference(draw(three_boxes(), effects("none")), draw(three_boxes(), effects("shadow")));
  EXPECT_GT(found.far_off, kPixels / 100);
  EXPECT_LT(found.far_off, kPixels / 4) << "most of the picture lies in the light";
  EXPECT_EQ(found.brighter, 0U);
}

TEST(RenderEffects, LitSurfacesDoNotShadeThemselves) {
  Snapshot snapshot = three_boxes();
  snapshot.boxes.resize(1);
  snapshot.camera.position = {4, -4, 9};  // seen from where the light comes
  snapshot.light.position = {4, -4, 9};
  snapshot.ground = false;  // whose soft edges of shadow peep out
  EXPECT_EQ(difference(draw(snapshot, effects("none")), draw(snapshot, effects("shadow"))).far_off, 0U);
}

TEST(RenderEffects, HighlightsOnlyBrighten) {
  Snapshot snapshot = three_boxes();
  snapshot.light.position = {-4, -10, 4};  // mirrored by the crate's front into the camera
  const PictureDifference found = difference(draw(snapshot, effects("none")), draw(snapshot, effects("specular")));
  EXPECT_GT(found.far_off, 100U);
  EXPECT_EQ(found.darker, 0U);
}

TEST(RenderEffects, BloomGlowsAroundAbsoluteWhiteAlone) {
  Snapshot snapshot = three_boxes();
  const Image plain = draw(snapshot, effects("none"));
  ASSERT_GT(count_pixels(plain, is_white), 50U) << "the scene has nothing white";
  const PictureDifference found = difference(plain, draw(snapshot, effects("bloom")));
  EXPECT_GT(found.far_off, 100U);
  EXPECT_EQ(found.darker, 0U);
  snapshot.boxes[1].texture = sim::Texture::kBrick;
  EXPECT_EQ(difference(draw(snapshot, effects("none")), draw(snapshot, effects("bloom"))).far_off, 0U);
}

TEST(RenderEffects, BloomReachesAFifteenthOfThePicture) {
  Snapshot snapshot = three_boxes();
  snapshot.ground = false;
  const Image mask = draw(snapshot, effects("bloom"), Stage::kHdr);
  const Image glow = draw(snapshot, effects("bloom"), Stage::kGlow);
  ASSERT_EQ(mask.width, 40);
  const auto rightmost = [](const Image& image, int level) {
    int found = -1;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) found = image.rgb[image.at(x, y)] > level ? std::max(found, x) : found;
    }
    return found;
  };
  EXPECT_GE(rightmost(glow, 8) - rightmost(mask, 8), 40 / 30) << "half the kernel, which is at least 1/15 of the width";
}

TEST(RenderEffects, DepthOfFieldSparesThePlaneOfFocus) {
  Snapshot snapshot = three_boxes();
  const Image masks = draw(snapshot, effects("dof"), Stage::kMasks);
  EXPECT_EQ(masks.rgb[masks.at(80, 70)], 0) << "the crate, in focus";
  EXPECT_GT(masks.rgb[masks.at(80, 2)], 200) << "the background";
  snapshot.camera.blur = 0;
  EXPECT_EQ(draw(snapshot, effects("none")), draw(snapshot, effects("dof"))) << "blur 0 switches it off";
  snapshot.camera.blur = 1;
  EXPECT_GT(difference(draw(snapshot, effects("none")), draw(snapshot, effects("dof"))).far_off, 50U);
}

TEST(RenderEffects, MotionBlurIsOnWhatMoves) {
  Snapshot snapshot = three_boxes();
  EXPECT_EQ(draw(snapshot, effects("none")), draw(snapshot, effects("motion"))) << "nothing moves";
  snapshot.boxes[2].velocity = {0, 0, 8};
  const Image masks = draw(snapshot, effects("motion"), Stage::kMasks);
  const auto some = [](int r, int /*g*/, int /*b*/) { return r > 0; };
  const std::uint64_t moving = count_pixels(masks, some);
  EXPECT_GT(moving, 200U);
  EXPECT_LT(moving, kPixels / 8) << "the others stand still";
  EXPECT_GT(difference(draw(snapshot, effects("none")), draw(snapshot, effects("motion"))).far_off, 20U);
}

TEST(RenderEffects, SpinAloneMakesAMotionMaskThatGrowsOutwards) {
  Snapshot snapshot = three_boxes();
  snapshot.boxes.resize(1);
  snapshot.boxes[0].spin = {0, 0, 3};
  const Image masks = draw(snapshot, effects("motion"), Stage::kMasks);
  const auto strong = [](int r, int /*g*/, int /*b*/) { return r > 60; };
  const auto any = [](int r, int /*g*/, int /*b*/) { return r > 0; };
  EXPECT_GT(count_pixels(masks, strong), 10U);
  EXPECT_GT(count_pixels(masks, any), count_pixels(masks, strong) * 5 / 4) << "the middle moves less than the edges";
}

TEST(RenderEffects, VertexLightingHasNoHighlight) {
  EXPECT_EQ(draw(three_boxes(), effects("vertex,specular")),
            draw(three_boxes(), effects("vertex,-specular,-shadow,-bloom,-dof,-motion")));
  EXPECT_GT(difference(draw(three_boxes(), effects("specular")),
                       draw(three_boxes(), effects("vertex,-specular,-shadow,-bloom,-dof,-motion")))
                .pixels,
            50U);
}

TEST(RenderEffects, MoreSamplesSmoothEdgesAndKeepTheRest) {
  const Image one = draw(three_boxes()), two = draw(three_boxes(), {}, Stage::kFinal, 2);
  const PictureDifference found = difference(one, two);
  EXPECT_GT(found.pixels, 100U);
  EXPECT_LT(found.far_off, kPixels / 10);
}

TEST(RenderPasses, HaveTheirSizes) {
  const Snapshot snapshot = three_boxes();
  EXPECT_EQ(draw(snapshot, {}, Stage::kDepth).width, 512);
  EXPECT_EQ(draw(snapshot, {}, Stage::kBase).width, 160);
  for (const Stage stage : {Stage::kShrunk, Stage::kHdr, Stage::kBlurX, Stage::kBlurred, Stage::kGlow}) {
    EXPECT_EQ(draw(snapshot, {}, stage).width, 40);
    EXPECT_EQ(draw(snapshot, {}, stage).height, 30);
  }
}

TEST(RenderPasses, TheDepthMapIsDarkWhereBoxesAreNearTheLight) {
  const Image map = draw(three_boxes(), {}, Stage::kDepth);
  const auto near = [](int r, int /*g*/, int /*b*/) { return r < 40; };
  const auto nothing = [](int r, int /*g*/, int /*b*/) { return r == 255; };
  EXPECT_GT(count_pixels(map, near), 1000U);
  EXPECT_GT(count_pixels(map, nothing), 50000U) << "the ground casts no shadow";
}

TEST(RenderPasses, BlurKeepsTheMeanAndNarrowsTheRange) {
  const Image before = draw(three_boxes(), {}, Stage::kShrunk), after = draw(three_boxes(), {}, Stage::kBlurred);
  const auto [low_before, high_before] = std::ranges::minmax(before.rgb);
  const auto [low_after, high_after] = std::ranges::minmax(after.rgb);
  EXPECT_GE(low_after, low_before);
  EXPECT_LE(high_after, high_before);
  EXPECT_LT(high_after - low_after, high_before - low_before);
}

}  // namespace
}  // namespace tumble::test
