// An output that fails leaves the old file; an old file does not pass for a new one.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

const char* const kAlmostNoRoom = "ulimit -f 1; ";  // 512 or 1024 bytes a file
const std::string kOld = "the old content";

/// An older file that begins like an output of this name.
std::string older(const std::string& name) {
  using namespace std::string_literals;
  if (name.ends_with(".png")) return "\x89PNG\r\n\x1a\n" + kOld;
  if (name.ends_with(".svg")) return "<svg>" + kOld;
  if (name.ends_with(".mp4")) return "\0\0\0\x18"s + "ftyp" + kOld;
  if (name.ends_with(".npz")) return "PK\x03\x04" + kOld;
  if (name.ends_with(".glb")) return "glTF" + kOld;
  if (name.ends_with(".json")) return "{\"x\": \"" + kOld + "\"}";
  if (name.ends_with(".csv")) return "step," + kOld;
  return kOld;
}

TEST(FullDisk, NeverCostsTheOldFile) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--set", "material.friction=0.3"});
  const std::vector<Words> commands = {
      {"measure", "a.tumble", "--series", "x.csv"}, {"measure", "a.tumble", "--plot", "x.svg"},
      {"measure", "a.tumble", "--plot", "x.png"},   {"diff", "a.tumble", "b.tumble", "--plot", "x.svg"},
      {"render", "a.tumble", "-o", "x.png"},        {"render", "a.tumble", "-o", "x.mp4", "--size", "64x48"},
      {"export", "a.tumble", "-o", "x.csv"},        {"export", "a.tumble", "-o", "x.npz"},
      {"export", "a.tumble", "-o", "x.glb"},        {"bench", "memory", "--scene", "a.toml", "--save", "x.json"}};
  for (const Words& words : commands) {
    const std::string& output = words.back() == "64x48" ? words[3] : words.back();
    shop.write(output, older(output));
    const Outcome outcome = shop.run_after(kAlmostNoRoom, words);
    EXPECT_EQ(outcome.exit, 4) << words[0] << ' ' << output << ": " << outcome.err;
    EXPECT_NE(outcome.err.find(output), std::string::npos) << outcome.err;
    EXPECT_EQ(shop.read(output), older(output)) << words[0] << ' ' << output;
    EXPECT_EQ(shop.names_with(".part"), Words{}) << words[0] << ' ' << output;
  }
}

TEST(FullDisk, RecoverKeepsTheLogThatWasThere) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("saved", {"--steps", "10"});
  const std::string before = shop.read("saved.tumble");
  const Outcome outcome = shop.run_after(kAlmostNoRoom, {"recover", "a.tumble", "-o", "saved.tumble"});
  EXPECT_EQ(outcome.exit, 4) << outcome.err;
  EXPECT_TRUE(shop.read("saved.tumble") == before);
  EXPECT_EQ(shop.names_with(".part"), Words{});
}

TEST(RecoverCommand, ReadsALogThatAnEarlierRecoveryLeft) {
  const Workshop shop;
  shop.record_small("a");
  shop.write("saved.tumble.partial", shop.read("a.tumble"));
  const Outcome outcome = shop.run({"recover", "saved.tumble.partial", "-o", "saved.tumble"});
  EXPECT_EQ(outcome.exit, 0) << outcome.err;
  EXPECT_TRUE(shop.read("saved.tumble.partial") == shop.read("a.tumble")) << "it is only read";
}

class EarlierReport : public testing::Test {
 protected:
  void SetUp() override {
    shop_.write("s/cases/one/scene.toml", kSmallScene);
    shop_.write("s/cases/one/metrics.toml", "[[metric]]\nname = \"drift_max\"\nmax = 100.0\nwhy = \"they fall\"\n");
    ASSERT_EQ(shop_.run({"bless", "--all", "--suite", "s", "--reason", "a test"}).exit, 0);
  }
  [[nodiscard]] Outcome check(Words more) const {
    more.insert(more.begin(), {"check", "--suite", "s", "--report", "r"});
    return shop_.run(more);
  }
  Workshop shop_;
};

TEST_F(EarlierReport, IsGoneWhereTheNewOneLiesElsewhere) {
  ASSERT_EQ(check({}).exit, 0);
  ASSERT_TRUE(fs::exists(shop_.path("r/junit.xml")));
  ASSERT_EQ(check({"--junit", "new.xml"}).exit, 0);
  EXPECT_FALSE(fs::exists(shop_.path("r/junit.xml"))) << "the verdict of another run";
  EXPECT_TRUE(fs::exists(shop_.path("new.xml")));
}

TEST_F(EarlierReport, IsGoneWhereTheCheckIsNotFinished) {
  ASSERT_EQ(check({}).exit, 0);
  const Outcome outcome = shop_.run_after("ulimit -f 4; ", {"check", "--suite", "s", "--report", "r"});
  EXPECT_EQ(outcome.exit, 4);
  EXPECT_NE(outcome.err.find(": no temporary files can be written: File too large; "), std::string::npos)
      << outcome.err;
  EXPECT_EQ((outcome.out + outcome.err).find("trusted"), std::string::npos) << "no build is at fault";
  for (const char* name : {"r/junit.xml", "r/report.json", "r/index.html"}) {
    EXPECT_FALSE(fs::exists(shop_.path(name))) << name << " says what an earlier run found";
  }
}

TEST_F(EarlierReport, TakesItsFilesOfCasesAlong) {
  shop_.write(
      "r/report.json",
      R"({"schema": "urn:tumble:json:1:check", "cases": [{"artifacts": ["cases/gone/actual.tumble", "cases/../../s/HISTORY.md", "", 7]}]})");
  shop_.write("r/cases/gone/actual.tumble", "of a case that is no more");
  shop_.write("r/cases/mine/notes.txt", "a person's");
  ASSERT_EQ(check({}).exit, 0);
  EXPECT_FALSE(fs::exists(shop_.path("r/cases/gone")));
  EXPECT_TRUE(fs::exists(shop_.path("r/cases/mine/notes.txt"))) << "only what a report names is removed";
  EXPECT_TRUE(fs::exists(shop_.path("s/HISTORY.md")));
}

// A suite may be another's place for a report: only files that a report has are an earlier report's.
TEST_F(EarlierReport, IsToldFromTheGoldensOfAnotherSuite) {
  const Words goldens = {"other/cases/one/scene.toml", "other/cases/one/frame_0012.png",
                         "other/cases/two/frame_0001.png"};
  for (const std::string& file : goldens) shop_.write(file, kOld);
  const Words left = {"other/cases/one/frame_0012.actual.png", "other/cases/one/series.json",
                      "other/cases/gone/expected_track.csv"};
  for (const std::string& file : left) shop_.write(file, kOld);
  // A folder that never held a report has none to remove.
  const Outcome refused = shop_.run({"check", "--suite", "s", "--report", "other"});
  EXPECT_EQ(refused.exit, 2);
  EXPECT_NE(refused.err.find("holds no earlier report"), std::string::npos) << refused.err;
  for (const std::string& file : left) EXPECT_TRUE(fs::exists(shop_.path(file))) << file;
  EXPECT_FALSE(fs::exists(shop_.path("other/index.html")));
  shop_.write("other/report.json", R"({"schema": "urn:tumble:json:1:check"})");
  ASSERT_EQ(shop_.run({"check", "--suite", "s", "--report", "other"}).exit, 0);
  for (const std::string& file : goldens) EXPECT_TRUE(fs::exists(shop_.path(file))) << file;
  for (const std::string& file : left) EXPECT_FALSE(fs::exists(shop_.path(file))) << file;
  EXPECT_FALSE(fs::exists(shop_.path("other/cases/gone"))) << "it is empty";
}

// A check that was stopped leaves files of cases and no report.
TEST_F(EarlierReport, IsClearedWhereItIsNotFinished) {
  EXPECT_EQ(shop_.run_after("ulimit -f 4; ", {"check", "--suite", "s", "--report", "r"}).exit, 4);
  shop_.write("r/cases/one/actual.tumble", kOld);
  EXPECT_EQ(check({}).exit, 0);
  EXPECT_FALSE(fs::exists(shop_.path("r/cases/one")));
}

TEST(EarlierPictures, AreSaidWhereTheyStay) {
  const Workshop shop;
  shop.record_small("a");
  const auto draw = [&](const std::string& every) {
    return shop.run({"render", "a.tumble", "--every", every, "-o", "f", "--size", "32x32", "--json"});
  };
  EXPECT_EQ(nlohmann::json::parse(draw("10").out)["older_pictures"], 0);
  EXPECT_EQ(nlohmann::json::parse(draw("20").out)["older_pictures"], 2);
}

}  // namespace
}  // namespace tumble::test
