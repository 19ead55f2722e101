// Results of another machine are accepted from the report of its check, as that machine ran and drew them.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "golden/judge/case_json.h"
#include "tests/support/golden_suite.h"
#include "tumble/golden/bless.h"
#include "tumble/golden/report.h"
#include "tumble/render/png.h"

namespace {

std::string some_commit() { return std::string(40, 'a'); }

std::string& built_at() {
  static std::string text = some_commit() + " clean";
  return text;
}

}  // namespace

/// As the build tells a program; a test is built at no commit.
extern "C" const char* tumble_build_commit() { return built_at().c_str(); }

namespace tumble::golden {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFrame = "frame_0012.png";
constexpr const char* kPicture = R"(
[[picture]]
step = 12
width = 64
height = 48
why = "it shows both boxes"
)";

/// A suite, and the report of a check in which its case "fall" had moved.
class FromReport : public testing::Test {
 protected:
  void SetUp() override {
    built_at() = some_commit() + " clean";
    suite_.add("fall", kFallingBoxes, rules());
    suite_.add("rest");
    suite_.bless();
    suite_.edit("fall", kSceneFile, "2.0]", "2.000000001]");
    write_report();
  }
  [[nodiscard]] virtual std::string rules() const { return kTwoMetrics; }
  [[nodiscard]] fs::path report() const { return suite_.root() / "report"; }
  [[nodiscard]] fs::path of_fall(const std::string& file) const { return report() / "cases/fall" / file; }
  void write_report() const { ASSERT_TRUE(write_reports(suite_.check(), report(), "").ok()); }
  [[nodiscard]] Json json() const { return Json::parse(suite_.read(report() / "report.json")); }
  /// The report with another value of one key of the case.
  void edit_case(const char* key, const Json& value) const {
    Json all = json();
    all["cases"][0][key] = value;
    suite_.write(report() / "report.json", all.dump());
  }
  [[nodiscard]] Result<BlessReport> bless() const {
    BlessOptions options;
    options.suite = suite_.root();
    options.reason = "as the other machine ran it";
    options.report = report();
    return bless_cases(options);
  }
  void accepts() const {
    const Result<BlessReport> blessed = bless();
    ASSERT_TRUE(blessed.ok()) << blessed.error().message;
    ASSERT_EQ(blessed->blessed.size(), 1U);
    EXPECT_EQ(blessed->blessed[0].name, "fall");
  }
  void refuses(const std::string& words) const {
    const Result<BlessReport> blessed = bless();
    ASSERT_FALSE(blessed.ok()) << words;
    EXPECT_NE(blessed.error().message.find(words), std::string::npos) << blessed.error().message;
  }
  TemporarySuite suite_;
};

TEST_F(FromReport, OfThisCommitIsAcceptedWithItsProvenance) {
  edit_case("seconds", 123.5);
  accepts();
  const CaseResult result = suite_.check_one("fall");
  EXPECT_TRUE(result.passed()) << summary(result);
  ASSERT_TRUE(result.blessed_by);
  EXPECT_EQ(result.blessed_by->commit, some_commit());
  EXPECT_EQ(result.blessed_by->seconds, 123.5) << "of the case there, not of reading its session here";
}

TEST_F(FromReport, OfAnotherCommitOrTreeOrSceneIsRefused) {
  for (const char* here : {"b clean", "b changed", ""}) {
    built_at() = here;
    refuses(std::string("but this program ") + (*here == 0 ? "does not know its commit" : "was built at b"));
  }
  built_at() = some_commit() + " changed";
  refuses("with changed sources; build that commit first");
  write_report();
  refuses("its check ran commit " + some_commit() + " with changed sources");
  built_at() = "";
  write_report();
  refuses("does not say which commit");
  built_at() = some_commit() + " clean";
  write_report();
  suite_.edit("fall", kSceneFile, "2.000000001]", "2.25]");
  refuses("is of another scene");
}

TEST_F(FromReport, WithADamagedSessionIsRefused) {
  std::string bytes = suite_.read(of_fall("actual.tumble"));
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1);
  suite_.write(of_fall("actual.tumble"), bytes);
  refuses("fall's log");
  refuses("the stored bytes are not those that were written");
  fs::remove(of_fall("actual.tumble"));
  refuses("holds no session of a failed case");
  suite_.write(report() / "report.json", "{}");
  refuses("is no report of a check");
}

// A golden without a hidden state would never compare one.
TEST_F(FromReport, WithoutTheHashesOfItsEndIsRefused) {
  const std::string end = json()["cases"][0]["continuation"];
  for (const std::string& wrong : {end.substr(1), end + "0", "g" + end.substr(1), "-" + end.substr(1)}) {
    edit_case("continuation", wrong);
    refuses("continuation: found \"" + wrong + "\", wanted 32 hexadecimal digits");
  }
  edit_case("continuation", std::string(32, '0'));
  refuses("does not say the hash of the hidden state");
  edit_case("continuation", end);
  edit_case("final_hash", end);
  refuses("does not end as the report says");
}

/// The case names a picture, which did not move there unless the test says so.
class FromReportWithAPicture : public FromReport {
 protected:
  [[nodiscard]] std::string rules() const override { return std::string(kTwoMetrics) + kPicture; }
  [[nodiscard]] fs::path golden() const { return suite_.file("fall", kFrame); }
  [[nodiscard]] fs::path actual() const { return of_fall("frame_0012.actual.png"); }
  /// The golden with 200 pixels that are far off.
  [[nodiscard]] std::string spoiled() const {
    const fs::path file = suite_.root() / "spoiled.png";
    Result<render::PngFile> png = render::read_png(golden().string());
    EXPECT_TRUE(png.ok());
    for (std::size_t i = 0; i < 200; ++i) png->image.rgb[i * 3] ^= 0x80;
    EXPECT_TRUE(render::write_png(file.string(), png->image, png->text).ok());
    return suite_.read(file);
  }
  /// The report of a machine that drew another picture than this one, which draws the golden.
  void move_there() const {
    const std::string here = suite_.read(golden()), there = spoiled();
    suite_.write(golden(), there);
    write_report();
    ASSERT_TRUE(fs::exists(actual()));
    suite_.write(golden(), here);
    suite_.write(actual(), there);
  }
  /// The newest entry.
  [[nodiscard]] std::string history() const {
    const std::string all = suite_.read(suite_.root() / kHistoryFile);
    return all.substr(0, all.find(": a test"));
  }
};

TEST_F(FromReportWithAPicture, ThatMovedThereIsTheNewGolden) {
  move_there();
  accepts();
  EXPECT_TRUE(suite_.read(golden()) == suite_.read(actual()));
  EXPECT_NE(history().find("frame_0012.png: 200 pixels not as blessed, 200 of them"), std::string::npos) << history();
}

TEST_F(FromReportWithAPicture, ThatDidNotMoveThereIsKept) {
  ASSERT_EQ(json()["cases"][0]["pictures"][0]["words"], "");
  const std::string drawn_there = spoiled();  // this machine draws another
  suite_.write(golden(), drawn_there);
  accepts();
  EXPECT_TRUE(suite_.read(golden()) == drawn_there);
  EXPECT_EQ(history().find(kFrame), std::string::npos) << history();
}

TEST_F(FromReportWithAPicture, ThatCannotBeHadIsRefused) {
  move_there();
  suite_.write(actual(), "no picture");
  refuses("frame_0012.png");
  refuses("not a PNG");
  fs::remove(actual());
  refuses("frame_0012.png is not in the report, which says: 200 pixels not as blessed");
  edit_case("pictures", Json::array());
  refuses("frame_0012.png was not drawn by the check of the report");
}

}  // namespace
}  // namespace tumble::golden
