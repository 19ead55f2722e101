// The renderer's parts that need no OpenGL: PNG files, lists of effects, views, materials, moments between states.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "src/render/gl/context.h"
#include "src/render/gl/shared_library.h"
#include "src/render/picture/image_difference.h"
#include "src/render/scene/material_texels.h"
#include "src/render/scene/materials.h"
#include "src/render/scene/view.h"
#include "tests/support/pictures.h"
#include "tumble/render/effects.h"
#include "tumble/render/png.h"
#include "tumble/render/renderer.h"

namespace tumble::test {
namespace {

using render::Image;

class PngFiles : public testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(path_); }
  static Image gradient() {
    Image image = Image::blank(37, 11);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = static_cast<std::uint8_t>(i * 7);
    return image;
  }
  std::string path_ = testing::TempDir() + "tumble-picture.png";
};

TEST_F(PngFiles, ComeBackAsTheyWere) {
  const render::PngText text = {{"Scene", "größe"}, {"Step", "12"}};
  ASSERT_TRUE(render::write_png(path_, gradient(), text).ok());
  const auto read = render::read_png(path_);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->image, gradient());
  EXPECT_EQ(read->text, text);
}

TEST_F(PngFiles, AreNotLeftHalfWritten) {
  const Status written = render::write_png(testing::TempDir() + "no-such-folder/x.png", gradient());
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.error().kind, ErrorKind::kBadInput);
  ASSERT_TRUE(render::write_png(path_, gradient()).ok());
  EXPECT_FALSE(std::filesystem::exists(path_ + ".part"));
}

TEST_F(PngFiles, OfOtherKindsAreRefused) {
  EXPECT_EQ(render::read_png(path_ + "-missing").error().kind, ErrorKind::kBadInput);
  std::ofstream(path_) << "no picture";
  EXPECT_NE(render::read_png(path_).error().message.find("not a PNG"), std::string::npos);
}

TEST_F(PngFiles, WithAnyByteDamagedAreRefusedOrReadWithoutHarm) {
  ASSERT_TRUE(render::write_png(path_, gradient(), {{"Step", "12"}}).ok());
  std::ostringstream whole;
  whole << std::ifstream(path_, std::ios::binary).rdbuf();
  const std::string bytes = whole.str();
  std::size_t refused = 0;
  for (std::size_t i = 8; i < bytes.size(); ++i) {
    std::string broken = bytes;
    broken[i] = static_cast<char>(broken[i] ^ 0x10);
    std::ofstream(path_, std::ios::binary) << broken;
    const auto read = render::read_png(path_);
    refused += read.ok() ? 0U : 1U;
    if (!read.ok()) continue;
    EXPECT_EQ(read->image, gradient()) << "byte " << i;
  }
  EXPECT_GT(refused, bytes.size() / 2);
  std::ofstream(path_, std::ios::binary) << bytes.substr(0, bytes.size() / 2);
  EXPECT_EQ(render::read_png(path_).error().kind, ErrorKind::kDamaged);
}

TEST(ImageDifferences, CountPixelsAndNotChannels) {
  const Image expected = Image::blank(4, 2);
  Image actual = expected;
  EXPECT_TRUE(render::difference_of(expected, actual).equal());
  actual.rgb[0] = 8;
  actual.rgb[3] = actual.rgb[4] = actual.rgb[5] = 9;
  actual.rgb[23] = 200;
  const render::ImageDifference found = render::difference_of(expected, actual);
  EXPECT_EQ(found.pixels, 3U);
  EXPECT_EQ(found.far_off, 2U);
  EXPECT_EQ(found.largest, 200);
  const Image map = render::difference_map(expected, actual);
  EXPECT_EQ(map.rgb[3], 255) << "far off";
  EXPECT_LT(map.rgb[0], 100) << "a little off";
  EXPECT_EQ(map.rgb[9], 0) << "the same";
}

TEST(EffectLists, NameTakeAwayAndComeBack) {
  const render::Effects all;
  EXPECT_EQ(effects("all"), all);
  EXPECT_EQ(effects("none"), (render::Effects{false, false, false, false, false, false}));
  EXPECT_EQ(effects("shadow,bloom"), (render::Effects{false, true, true, false, false, false}));
  EXPECT_EQ(effects("-dof,-motion"), (render::Effects{true, true, true, false, false, false}));
  EXPECT_EQ(effects("vertex"), (render::Effects{true, true, true, true, true, true}));
  EXPECT_EQ(effects("vertex,-bloom"), (render::Effects{true, true, false, true, true, true}));
  EXPECT_EQ(effects("vertex,shadow"), (render::Effects{false, true, false, false, false, true}));
  for (const char* list : {"all", "none", "shadow,bloom", "-dof,-motion", "vertex,shadow"}) {
    EXPECT_EQ(effects(render::to_string(effects(list)).c_str()), effects(list)) << list;
  }
}

TEST(EffectLists, ThatAreWrongSayWhatIsWanted) {
  for (const char* list : {"", "shadows", "shadow,,bloom", "shadow,-bloom", "all,shadow"}) {
    const auto parsed = render::parse_effects(list);
    ASSERT_FALSE(parsed.ok()) << list;
    EXPECT_NE(parsed.error().message.find("wanted all, none"), std::string::npos);
  }
}

TEST(RendererSettings, OutOfLimitsAreRefused) {
  for (const render::Settings& settings : {render::Settings{8, 100, 1, {}}, render::Settings{100, 5000, 1, {}},
                                           render::Settings{100, 100, 0, {}}, render::Settings{100, 100, 9, {}}}) {
    const auto made = render::Renderer::create(settings);
    ASSERT_FALSE(made.ok());
    EXPECT_EQ(made.error().kind, ErrorKind::kBadInput);
  }
}

TEST(RenderContext, SaysWhatItDrawsWith) {
  const auto context = render::Context::open();
  ASSERT_TRUE(context.ok()) << context.error().message;
  EXPECT_NE((*context)->driver().find("Mesa"), std::string::npos);
  EXPECT_TRUE(render::parse_backend("egl").ok());
  EXPECT_FALSE(render::parse_backend("vulkan").ok());
}

TEST(RenderContext, NamesALibraryThatIsMissing) {
  constexpr std::array kNames = {"libNoSuchOpenGL.so.7"};
  const auto library = render::SharedLibrary::load(kNames);
  ASSERT_FALSE(library.ok());
  EXPECT_NE(library.error().message.find("libNoSuchOpenGL.so.7"), std::string::npos);
}

TEST(RenderContext, NamesEntryPointsThatADriverLacks) {
  const auto gl = render::load_gl([](const char* name) -> render::GlFunction {
    if (std::string(name) == "glViewport") return nullptr;
    return [] {};
  });
  ASSERT_FALSE(gl.ok());
  EXPECT_NE(gl.error().message.find("lacks glViewport;"), std::string::npos) << gl.error().message;
}

TEST(Materials, ShineWhereTheyAreSteel) {
  const auto crate = render::make_levels(0);
  ASSERT_EQ(crate[0].size(), 256U * 256 * 4);
  ASSERT_EQ(crate.back().size(), 4U);
  const auto shine_at = [&](std::size_t x, std::size_t y) { return int{crate[0][(y * 256 + x) * 4 + 3]}; };
  EXPECT_GT(shine_at(4, 100), 200) << "the band along the edge";
  EXPECT_GT(shine_at(128, 128), 200) << "the band across";
  EXPECT_LT(shine_at(80, 80), 60) << "a board";
}

TEST(Materials, KeepTheirBrightnessInEveryLevel) {
  for (int layer = 0; layer < render::kLayerCount; ++layer) {
    const auto levels = render::make_levels(layer);
    const auto mean_square = [](const render::Texels& texels) {
      double sum = 0;
      for (std::size_t i = 0; i < texels.size(); i += 4) sum += texels[i] * texels[i];
      return std::sqrt(sum / (static_cast<double>(texels.size()) / 4));
    };
    EXPECT_NEAR(mean_square(levels[0]), mean_square(levels.back()), 4) << "layer " << layer;
  }
}

TEST(Materials, OfTwoBricksDifferAndOfWhiteDoNot) {
  render::BoxLook a, b;
  a.id = 1;
  b.id = 2;
  a.texture = b.texture = sim::Texture::kBrick;
  EXPECT_NE(render::variation_of(a).tint.g, render::variation_of(b).tint.g);
  a.texture = b.texture = sim::Texture::kWhite;
  EXPECT_EQ(render::variation_of(a).tint.g, render::variation_of(b).tint.g);
}

// A point in clip coordinates, divided.
std::array<double, 3> projected(const render::Matrix& m, const sim::Vec3& p) {
  std::array<double, 4> clip{};
  for (std::size_t row = 0; row < 4; ++row)
    clip[row] = m[row] * p.x() + m[4 + row] * p.y() + m[8 + row] * p.z() + m[12 + row];
  return {clip[0] / clip[3], clip[1] / clip[3], clip[2] / clip[3]};
}

TEST(RenderView, HasItsTargetInTheMiddleAndUpUpwards) {
  for (const sim::Vec3& eye : {sim::Vec3(3, -7, 3), sim::Vec3(0, 0, 30), sim::Vec3(0, 0, -30)}) {
    const sim::Camera camera = {eye, {0, 0, 0}, 40, 10, 1};
    const render::View view = render::camera_view(camera, 200, 100);
    const auto middle = projected(view.clip_from_world, {0, 0, 0});
    EXPECT_NEAR(middle[0], 0, 1e-9);
    EXPECT_NEAR(middle[1], 0, 1e-9);
    const bool is_vertical = eye.x() == 0;
    EXPECT_GT(projected(view.clip_from_world, is_vertical ? sim::Vec3(0, 1, 0) : sim::Vec3(0, 0, 1))[1], 0.01);
  }
}

TEST(RenderView, OfTheLightHoldsEveryBox) {
  const render::Snapshot snapshot = three_boxes();
  const render::View light = render::light_view(snapshot);
  for (const render::BoxLook& box : snapshot.boxes) {
    for (const double side : {-0.5, 0.5}) {
      const auto at = projected(light.clip_from_world, box.centre + sim::Vec3(side, side, -side));
      EXPECT_LT(std::max(std::fabs(at[0]), std::fabs(at[1])), 1);
      EXPECT_LT(std::fabs(at[2]), 1);
    }
  }
}

TEST(Moments, BetweenStatesAreInterpolated) {
  render::Snapshot before = three_boxes(), after = before;
  before.boxes.pop_back();  // box 3 is thrown in
  after.boxes[0].centre.z() += 2;
  after.boxes[1].orientation = {-std::sqrt(0.5), 0, 0, -std::sqrt(0.5)};  // a quarter turn, by its other name
  after.boxes[2].velocity = {10, 0, 0};
  const render::Snapshot half = render::between(before, after, 0.5, 0.1);
  EXPECT_DOUBLE_EQ(half.boxes[0].centre.z(), before.boxes[0].centre.z() + 1);
  EXPECT_NEAR(std::fabs(half.boxes[1].orientation.w), std::cos(std::atan(1.0) / 2), 1e-12) << "an eighth turn";
  EXPECT_DOUBLE_EQ(half.boxes[2].centre.x(), after.boxes[2].centre.x() - 0.5) << "on its way in";
  EXPECT_EQ(half.boxes.size(), 3U);
}

}  // namespace
}  // namespace tumble::test
