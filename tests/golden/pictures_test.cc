// The image verdict: golden pictures drawn, compared, blessed, and what a person gets to see when one moved.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "tests/support/golden_suite.h"
#include "tumble/golden/suite.h"
#include "tumble/render/png.h"

namespace tumble::golden {
namespace {

constexpr const char* kPicture = R"(
[[picture]]
step = 12
width = 64
height = 48
far_off_max = 3
why = "what another driver may do to three pixels"
)";
constexpr const char* kFrame = "frame_0012.png";

class PicturedCase : public testing::Test {
 protected:
  void SetUp() override {
    suite_.add("fall", kFallingBoxes, std::string(kTwoMetrics) + kPicture);
    suite_.bless();
  }
  // The golden picture with its first `count` pixels off by `levels`.
  void spoil(std::size_t count, int levels) const {
    const std::string path = suite_.file("fall", kFrame).string();
    Result<render::PngFile> golden = render::read_png(path);
    ASSERT_TRUE(golden.ok());
    for (std::size_t i = 0; i < count; ++i) {
      std::uint8_t& red = golden->image.rgb[i * 3];
      red = static_cast<std::uint8_t>(red + (red > 128 ? -levels : levels));
    }
    ASSERT_TRUE(render::write_png(path, golden->image, golden->text).ok());
  }
  [[nodiscard]] Verdict image() const { return suite_.check_one("fall").verdict(VerdictKind::kImage); }

  TemporarySuite suite_;
};

TEST_F(PicturedCase, PassesWithEveryPixelTheSame) {
  ASSERT_TRUE(std::filesystem::exists(suite_.file("fall", kFrame)));
  EXPECT_EQ(image().outcome, Outcome::kPass);
  EXPECT_EQ(image().message, "1 picture, every pixel the same");
}

TEST_F(PicturedCase, PassesWithinItsBoundAndSaysSo) {
  spoil(500, 8);  // many, but none far off
  EXPECT_EQ(image().outcome, Outcome::kPass);
  EXPECT_NE(image().message.find("within their bounds"), std::string::npos) << image().message;
  spoil(3, 100);
  EXPECT_EQ(image().outcome, Outcome::kPass);
}

TEST_F(PicturedCase, FailsBeyondItsBoundWithNumbers) {
  spoil(4, 100);
  EXPECT_EQ(image().outcome, Outcome::kFail);
  EXPECT_NE(image().message.find("4 of them by more than 8 levels (bound: 3)"), std::string::npos) << image().message;
}

TEST_F(PicturedCase, FailsWhereOnlyTheLookOfTheSceneChanged) {
  suite_.edit("fall", kSceneFile, "[world]", "[camera]\nposition = [12.5, -16.0, 8.0]\n[world]");
  const CaseResult result = suite_.check_one("fall");
  EXPECT_EQ(result.verdict(VerdictKind::kExact).outcome, Outcome::kPass);
  EXPECT_EQ(result.verdict(VerdictKind::kImage).outcome, Outcome::kFail);
  suite_.bless();
  EXPECT_EQ(image().outcome, Outcome::kPass) << "blessed";
}

TEST_F(PicturedCase, FailsWithoutItsGoldenAndWithOneTooMany) {
  const auto problem = [&] {
    const CaseResult result = suite_.check_one("fall");
    EXPECT_FALSE(result.passed());
    return result.problems.empty() ? "" : result.problems.front();
  };
  std::filesystem::copy(suite_.file("fall", kFrame), suite_.file("fall", "frame_0013.png"));
  EXPECT_NE(problem().find("frame_0013.png"), std::string::npos);
  std::filesystem::remove(suite_.file("fall", "frame_0013.png"));
  EXPECT_TRUE(suite_.check_one("fall").passed());
  suite_.write(suite_.file("fall", kFrame), "no picture");
  EXPECT_NE(problem().find("not a PNG"), std::string::npos);
  std::filesystem::remove(suite_.file("fall", kFrame));
  EXPECT_NE(problem().find("no frame_0012.png"), std::string::npos);
}

TEST_F(PicturedCase, FailsWhereItsStepIsNotInTheSession) {
  suite_.edit("fall", kRulesFile, "step = 12", "step = 31");
  EXPECT_EQ(image().outcome, Outcome::kFail);
}

TEST_F(PicturedCase, LeavesWhatExplainsADifference) {
  suite_.edit("fall", kRulesFile, "[[metric]]", "require = [\"image\"]\n[[metric]]");
  spoil(200, 100);
  CheckOptions options;
  options.suite = suite_.root();
  options.report = suite_.root() / "report";
  ASSERT_TRUE(check_suite(options).ok());
  for (const char* name : {"frame_0012.actual.png", "frame_0012.expected.png", "frame_0012.difference.png"}) {
    EXPECT_TRUE(render::read_png((options.report / "cases/fall" / name).string()).ok()) << name;
  }
  suite_.bless();
  ASSERT_TRUE(check_suite(options).ok());
  EXPECT_FALSE(std::filesystem::exists(options.report / "cases/fall")) << "what the failed check left";
}

}  // namespace
}  // namespace tumble::golden
