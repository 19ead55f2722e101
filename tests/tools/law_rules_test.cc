// [laws] of a metrics.toml: what a hunt found goes on failing `check` until it is mended.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kLost = "[[metric]]\nname = \"lost\"\nmax = 0.0\nwhy = \"nothing falls through the ground\"\n";

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void write_case(const Workshop& shop, const std::string& name, const std::string& laws) {
  shop.write("golden/cases/" + name + "/metrics.toml", "require = [\"behaviour\"]\n" + laws + kLost);
}

// A scene that gains energy.
TEST(LawRules, AGoldenThatWasBlessedExcusesNoBrokenLaw) {
  const Workshop shop;
  const std::string scene = std::string(TUMBLE_SOURCE_DIR) + "/tests/data/hunt_known/energy_1_16410.toml";
  ASSERT_EQ(
      shop.run_after("mkdir -p golden/cases/ghost; cp '" + scene + "' golden/cases/ghost/scene.toml; ", {"--version"})
          .exit,
      0);
  write_case(shop, "ghost", "");
  ASSERT_EQ(shop.run({"bless", "ghost", "--reason", "as it was found"}).exit, 0);
  ASSERT_EQ(shop.run({"check", "ghost"}).exit, 0);
  // The blessed values stay, so that nothing but the law can fail the case.
  const std::string blessed = shop.read("golden/cases/ghost/metrics.toml");
  shop.write("golden/cases/ghost/metrics.toml", blessed + "\n[laws]\nenergy = true\n");
  ASSERT_TRUE(holds(blessed, "value = ")) << blessed;
  const Outcome check = shop.run({"check", "ghost", "--report", "report", "--junit", "junit.xml", "--json"});
  EXPECT_EQ(check.exit, 1) << check.out << check.err;
  const Json json = Json::parse(check.out, nullptr, false);
  ASSERT_TRUE(json.is_object()) << check.out;
  const Json law = json.at("cases").at(0).at("metrics").at(1);
  EXPECT_EQ(law.at("name"), "energy");
  EXPECT_EQ(law.at("group"), "law");
  EXPECT_EQ(law.at("pass"), false);
  EXPECT_GT(law.at("value"), law.at("max"));
  const std::string words = law.at("words");
  EXPECT_TRUE(holds(words, "energy was gained") && holds(words, ", allowed ")) << words;
  EXPECT_TRUE(holds(shop.read("junit.xml"), "energy: step ")) << shop.read("junit.xml");
  EXPECT_TRUE(holds(shop.read("report/index.html"), "energy is never gained"));
  EXPECT_TRUE(holds(shop.run({"check", "ghost"}).out, "laws not held: energy"));
  const Outcome refused = shop.run({"bless", "ghost", "--reason", "again"});
  EXPECT_EQ(refused.exit, 2) << refused.out;
  EXPECT_TRUE(holds(refused.err, "energy: step ") && holds(refused.err, "out of [laws] in ")) << refused.err;
}

TEST(LawRules, AreHeldOrNotJudged) {
  const Workshop shop;
  shop.write(
      "golden/cases/fall/scene.toml",
      "title = \"a fall\"\ncategory = \"session\"\n[world]\nmethod = \"layered\"\ndt = 0.01\nsteps = 5\n[[box]]\n"
      "position = [0.0, 0.0, 9.0]\n");
  write_case(shop, "fall", "[laws]\nflight = true\nids = true\n");
  EXPECT_EQ(shop.run({"bless", "fall", "--reason", "new"}).exit, 0);
  const Outcome held = shop.run({"check", "fall", "--json"});
  EXPECT_EQ(held.exit, 0) << held.out;
  EXPECT_TRUE(holds(held.out, "2 laws held")) << held.out;
  write_case(shop, "fall", "[laws]\nslope = true\n");
  const Outcome none = shop.run({"check", "fall"});
  EXPECT_EQ(none.exit, 1) << none.out;
  EXPECT_TRUE(holds(none.out, "not judged: ")) << none.out;
  write_case(shop, "fall", "[laws]\nunmeet = true\n");
  EXPECT_TRUE(holds(shop.run({"check", "fall"}).out, "unmet")) << "the nearest name is shown";
  write_case(shop, "fall", "[laws]\nunmet = false\n");
  EXPECT_TRUE(holds(shop.run({"check", "fall"}).out, "wanted true; leave out a law"));
  write_case(shop, "fall", "[laws]\nsurvives = true\n");
  EXPECT_TRUE(holds(shop.run({"check", "fall", "--json"}).out, "1 law held"));
  for (const char* key : {"against", "against_lost"}) {
    write_case(shop, "fall", std::string("[laws]\n") + key + " = true\n");
    const Outcome other = shop.run({"check", "fall"});
    EXPECT_EQ(other.exit, 1);
    EXPECT_TRUE(holds(other.out, "a case has no other build to compare with")) << other.out;
  }
}

// Found in an engine whose gravity is wrong, and mended by another command in its tumble.toml.
TEST(LawRules, AFindingOfAnEngineFailsUntilTheEngineIsMended) {
  const Workshop shop;
  const auto engine = [&shop](const std::string& more) {
    shop.write("tumble.toml",
               "[engine]\nrun = \"'" TUMBLE_PROGRAM "' record {scene} -o {log} --quiet " + more + "\"\n");
  };
  engine("--set world.gravity=[0,0,-9]");
  const Outcome hunt =
      shop.run({"hunt", "--engine", "--count", "12", "--relation", "flight", "--folder", "kept", "--json"});
  const Json json = Json::parse(hunt.out, nullptr, false);
  ASSERT_TRUE(json.is_object() && !json.at("findings").empty()) << hunt.err << hunt.out;
  const std::string name = json.at("findings").at(0).at("name");
  const std::string rules = shop.read("kept/cases/" + name + "/metrics.toml");
  EXPECT_TRUE(holds(rules, "\n[engine]\nscene = \"scene.toml\"\n") && holds(rules, "\n[laws]\nflight = true\n"))
      << rules;
  const Outcome refused = shop.run({"bless", "--suite", "kept", name, "--reason", "found"});
  EXPECT_TRUE(holds(refused.err, "flight: step ")) << refused.err;
  EXPECT_EQ(shop.run({"check", "--suite", "kept", name}).exit, 1);
  engine("");
  EXPECT_EQ(shop.run({"bless", "--suite", "kept", name, "--reason", "mended"}).exit, 0);
  EXPECT_EQ(shop.run({"check", "--suite", "kept", name}).exit, 0);
  engine("--set world.gravity=[0,0,-9]");
  EXPECT_TRUE(holds(shop.run({"check", "--suite", "kept", name}).out, "laws not held: flight"));
}

}  // namespace
}  // namespace tumble::test
