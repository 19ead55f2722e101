// `tumble hunt --against PROGRAM --within`: two builds whose bits differ on purpose.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

bool tells(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Another build, which sets one value of every scene otherwise.
class HuntAgainst : public ::testing::Test {
 protected:
  [[nodiscard]] std::string build(const std::string& set) const {
    shop_.write("other.sh", "#!/bin/sh\nexec " TUMBLE_PROGRAM " \"$@\" " + set + "\n");
    std::filesystem::permissions(shop_.path("other.sh"), std::filesystem::perms::owner_all);
    return shop_.path("other.sh");
  }
  [[nodiscard]] Outcome hunt(const std::string& other, const Words& more) const {
    Words words = {"hunt", "--seed", "2", "--count", "10", "--relation", "finishes", "--against", other};
    words.insert(words.end(), more.begin(), more.end());
    return shop_.run(words);
  }

  Workshop shop_;
};

TEST_F(HuntAgainst, ABuildIsWithinTheUsualBoundsOfItself) {
  const Outcome run = hunt(TUMBLE_PROGRAM, {"--within", "bounds", "--json"});
  ASSERT_EQ(run.exit, 0) << run.err << run.out;
  const Json json = Json::parse(run.out);
  EXPECT_EQ(json.at("within").at(0), "place=1e-06");
  for (const char* name : {"against", "against_lost"}) EXPECT_EQ(json.at("relations").at(name).at("held"), 10) << name;
  EXPECT_GT(json.at("relations").at("against_place").at("held"), 0);
  EXPECT_GT(json.at("relations").at("against_place").at("not_applicable"), 0) << "where a contact is first";
}

TEST_F(HuntAgainst, AMeasureThatNoSceneHasIsNotJudged) {
  // Over ice it never rests.
  shop_.write("scenes/ice.toml",
              "[world]\nsteps = 40\n[material]\nfriction = 0.0\n[[box]]\nvelocity = [2.0, 0.0, 0.0]\n"
              "position = [0.0, 0.0, 0.5]\n");
  const Outcome run = shop_.run(
      {"hunt", "--judge", "scenes", "--relation", "finishes", "--against", TUMBLE_PROGRAM, "--within", "rest_time=1"});
  EXPECT_EQ(run.exit, 4) << run.err << run.out;
  EXPECT_TRUE(tells(run.err, "nothing was judged: no scene has a value that a bound of --within")) << run.err;
}

TEST_F(HuntAgainst, ItsRelationsCanBeChosen) {
  const auto relations = [&](Words words) {
    words.insert(words.begin(), {"hunt", "--count", "2", "--against", TUMBLE_PROGRAM, "--json"});
    const Outcome run = shop_.run(words);
    Words names;
    if (run.exit != 0) return Words{run.err};
    const Json json = Json::parse(run.out);
    for (const auto& [name, tally] : json.at("relations").items()) names.push_back(name);
    return names;
  };
  EXPECT_EQ(relations({"--relation", "against"}), Words{"against"});
  EXPECT_EQ(relations({"--relation", "ids"}), (Words{"ids", "against"}));
  EXPECT_EQ(relations({"--within", "bounds", "--relation", "against_lost"}), Words{"against_lost"});
  const Outcome alone = shop_.run({"hunt", "--count", "1", "--relation", "against"});
  EXPECT_EQ(alone.exit, 2);
  EXPECT_TRUE(tells(alone.err, "\"against\" without --against")) << alone.err;
  EXPECT_TRUE(tells(relations({"--relation", "against_lost"}).at(0), "wanted --within lost=AMOUNT"));
}

TEST_F(HuntAgainst, OtherBitsWithinBoundsAreNoFinding) {
  const std::string other = build("--set 'world.gravity=[0,0,-9.8]'");
  EXPECT_EQ(hunt(other, {"--unshrunk"}).exit, 1) << "bits";
  const Outcome wide = hunt(other, {"--within", "place=1", "--within", "lost=0"});
  EXPECT_EQ(wide.exit, 0) << wide.out;
  EXPECT_TRUE(tells(wide.out, " within place=1 lost=0\n")) << wide.out;
}

TEST_F(HuntAgainst, BeyondABoundIsShrunkAndNamed) {
  const std::string other = build("--set 'world.gravity=[0,0,-9.8]'");
  const Outcome run = hunt(other, {"--within", "place=1e-4", "--folder", "kept"});
  ASSERT_EQ(run.exit, 1) << run.err << run.out;
  const Json json = Json::parse(shop_.read("kept/hunt.json"));
  ASSERT_FALSE(json.at("findings").empty());
  const Json& one = json.at("findings").at(0);
  EXPECT_EQ(one.at("relation"), "against_place");
  EXPECT_EQ(one.at("shrunk").at("bodies"), 1);
  EXPECT_GE(one.at("shrunk").at("found").at("step"), 1);
  EXPECT_GE(one.at("shrunk").at("found").at("body"), 1);
  EXPECT_EQ(one.at("shrunk").at("found").at("bound"), 1e-4);
  EXPECT_TRUE(tells(run.out, "before anything met, its place is ")) << run.out;
  EXPECT_TRUE(tells(run.out, ", allowed 0.0001 m")) << run.out;
  EXPECT_TRUE(tells(shop_.read("kept/cases/" + one.at("name").get<std::string>() + "/metrics.toml"), "No rule judges"));
  // A hunt with other bounds is another hunt.
  const Outcome others = hunt(other, {"--within", "place=1e-5", "--folder", "kept"});
  EXPECT_EQ(others.exit, 2);
  EXPECT_TRUE(tells(others.err, "another --within: found place=0.0001")) << others.err;
}

TEST_F(HuntAgainst, AMetricIsNamedWithBothValues) {
  const Outcome run = hunt(build("--set 'world.gravity=[0,0,-5]'"), {"--within", "final=1%", "--unshrunk"});
  ASSERT_EQ(run.exit, 1) << run.err << run.out;
  EXPECT_TRUE(tells(run.out, "final is ")) << run.out;
  EXPECT_TRUE(tells(run.out, " J here and ")) << run.out;
}

TEST_F(HuntAgainst, ASessionOfAnotherLengthIsOneFinding) {
  const Outcome run = hunt(build("--set world.steps=3"), {"--within", "bounds", "--unshrunk", "--json"});
  ASSERT_EQ(run.exit, 1) << run.err << run.out;
  const Json relations = Json::parse(run.out).at("relations");
  EXPECT_GT(relations.at("against").at("broken"), 5);
  EXPECT_EQ(relations.at("against_lost").at("broken"), 0);
  EXPECT_EQ(relations.at("against_lost").at("not_applicable"), relations.at("against").at("broken"));
  EXPECT_TRUE(tells(run.out, "ends with step 3, this one with ")) << run.out;
}

TEST_F(HuntAgainst, RefusesWhatIsNoBound) {
  const Outcome near = hunt(TUMBLE_PROGRAM, {"--within", "gain_mx=1"});
  EXPECT_EQ(near.exit, 2);
  EXPECT_TRUE(tells(near.err, "did you mean \"gain_max\"?")) << near.err;
  const Outcome sign = hunt(TUMBLE_PROGRAM, {"--within", "gain_max=-1"});
  EXPECT_EQ(sign.exit, 2);
  EXPECT_TRUE(tells(sign.err, "--within: gain_max: found \"-1\", wanted an amount")) << sign.err;
  EXPECT_EQ(hunt(TUMBLE_PROGRAM, {"--within", "bits", "--within", "bounds"}).exit, 2);
  const Outcome alone = shop_.run({"hunt", "--count", "1", "--within", "bounds"});
  EXPECT_EQ(alone.exit, 2);
  EXPECT_TRUE(tells(alone.err, "found no --against")) << alone.err;
  EXPECT_EQ(shop_.run({"hunt", "--count", "1", "--engine", "--within", "bounds"}).exit, 2);
  EXPECT_EQ(shop_.run({"hunt", "--relations", "--against", TUMBLE_PROGRAM}).exit, 2);
  EXPECT_EQ(shop_.run({"hunt", "--print", "1", "--against", TUMBLE_PROGRAM}).exit, 2);
  EXPECT_TRUE(tells(shop_.run({"hunt", "--relations"}).out, "overlap_peak=0.02+50% (m)"));
  EXPECT_TRUE(tells(shop_.run({"hunt", "--relations", "--json"}).out, "\"against\""));
}

// A program that answers --version as a tumble does, and records by the commands.
class HuntOtherProgram : public HuntAgainst {
 protected:
  [[nodiscard]] std::string recording(const std::string& commands) const {
    shop_.write("other.sh", "#!/bin/sh\n[ \"$1\" = record ] || exec " TUMBLE_PROGRAM " \"$@\"\n" + commands + "\n");
    std::filesystem::permissions(shop_.path("other.sh"), std::filesystem::perms::owner_all);
    return shop_.path("other.sh");
  }
  // A build that takes each scene's file through a program of sed.
  [[nodiscard]] std::string rewriting(const std::string& sed) const {
    return recording("f=$2; sed -e '" + sed +
                     "' \"$f\" >\"$f.other\"; shift 2; exec " TUMBLE_PROGRAM " record \"$f.other\" \"$@\"");
  }
};

TEST_F(HuntOtherProgram, ThatRefusesAScene) {
  const Outcome run = hunt(recording("echo 'some error' >&2; exit 2"), {"--unshrunk", "--json"});
  EXPECT_EQ(run.exit, 1) << run.err << run.out;
  EXPECT_EQ(Json::parse(run.out).at("relations").at("against").at("broken"), 10);
  EXPECT_TRUE(tells(run.out, "refuses the scene, which this one records: \\\"some error\\\"")) << run.out;
}

TEST_F(HuntOtherProgram, ThatIsNoTumble) {
  const Outcome run = hunt("/bin/ls", {});
  EXPECT_EQ(run.exit, 2) << run.err << run.out;
  EXPECT_TRUE(tells(run.err, "which answers --version with ")) << run.err;
  EXPECT_TRUE(tells(run.err, "wanted another build of tumble")) << run.err;
  shop_.write("plain", "text");
  EXPECT_TRUE(tells(hunt(shop_.path("plain"), {}).err, "not executable"));
  EXPECT_TRUE(tells(hunt(shop_.path("none"), {}).err, "where there is no file"));
  EXPECT_TRUE(tells(hunt(shop_.path("."), {}).err, "a folder"));
  const Outcome bare = hunt("plain", {});
  EXPECT_TRUE(tells(bare.err, "looked for in PATH")) << bare.err;
  EXPECT_TRUE(tells(bare.err, "is ./plain")) << bare.err;
  shop_.write("other.sh", "#!/bin/sh\nkill -SEGV $$\n");
  std::filesystem::permissions(shop_.path("other.sh"), std::filesystem::perms::owner_all);
  EXPECT_TRUE(tells(hunt(shop_.path("other.sh"), {}).err, "crashed at --version: it was ended by SIGSEGV"));
}

TEST_F(HuntOtherProgram, ThatBeginsOtherwiseIsFoundAtTheStart) {
  for (const char* within : {"bits", "bounds"}) {
    const Outcome mass = hunt(rewriting("s/^mass = .*/mass = 5/"), {"--within", within, "--unshrunk"});
    EXPECT_EQ(mass.exit, 1) << within << mass.out;
    EXPECT_TRUE(tells(mass.out, ": step 0, phase start, body ")) << mass.out;
    EXPECT_TRUE(tells(mass.out, " mass: ")) << mass.out;
    const Outcome place = hunt(rewriting("s/^position.*/position = [0, 0, 6]/"), {"--within", within, "--unshrunk"});
    EXPECT_EQ(place.exit, 1) << within << place.out;
    EXPECT_TRUE(tells(place.out, "the start differs: body ")) << place.out;
    EXPECT_FALSE(tells(place.out, "phase push")) << place.out;
  }
}

// Another build that ends the process which judges.
std::string deadly_build(const Workshop& shop) {
  shop.write("deadly.sh", "#!/bin/sh\ncase $1 in record) kill -9 $PPID;; *) echo tumble 0;; esac\n");
  std::filesystem::permissions(shop.path("deadly.sh"), std::filesystem::perms::owner_all);
  return shop.path("deadly.sh");
}

TEST(HuntJudge, ThatEndsIsAnErrorOfTheTool) {
  const Workshop shop;
  const std::vector<std::string> words = {"hunt",      "--count",          "2",        "--relation", "ids",
                                          "--against", deadly_build(shop), "--folder", "kept"};
  const Outcome run = shop.run(words);
  EXPECT_EQ(run.exit, 4) << run.err << run.out;
  EXPECT_TRUE(tells(run.err,
                    "scene 0 of seed 1: the program ended by SIGKILL while it judged against: an error of "
                    "tumble, which no relation is judged by; kept as survives_1_0"))
      << run.err;
  const Json json = Json::parse(shop.read("kept/hunt.json"));
  ASSERT_EQ(json.at("findings").size(), 2U);
  EXPECT_EQ(json.at("findings").at(0).at("relation"), "survives");
  EXPECT_EQ(json.at("findings").at(0).at("judging"), "against");
  EXPECT_EQ(shop.run(words).exit, 4) << "the kept finding stays one";
  // The scene as it was drawn is a case, which passes where nothing ends.
  EXPECT_TRUE(tells(shop.read("kept/cases/survives_1_0/metrics.toml"), "[laws]\nsurvives = true\n"));
  EXPECT_EQ(shop.run({"bless", "--suite", "kept", "survives_1_0", "--reason", "mended"}).exit, 0);
  EXPECT_EQ(shop.run({"check", "--suite", "kept", "survives_1_0"}).exit, 0);
  const Outcome judged = shop.run({"hunt", "--judge", "kept/findings", "--relation", "ids", "--against", words[6]});
  EXPECT_EQ(judged.exit, 4) << judged.err << judged.out;
  EXPECT_TRUE(tells(judged.err, "survives_1_0.toml: the program ended by SIGKILL while it judged against"))
      << judged.err;
}

}  // namespace
}  // namespace tumble::test
