// `tumble check --heavy` as a person runs it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.h"

namespace tumble::test {
namespace {

constexpr const char* kRules = "[[metric]]\nname = \"lost\"\nmax = 0.0\nwhy = \"nothing falls through the ground\"\n";

bool shows(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

void write_case(const Workshop& shop, const std::string& name, const std::string& front) {
  shop.write("s/cases/" + name + "/scene.toml",
             "title = \"a fall\"\ncategory = \"session\"\n[world]\nmethod = \"layered\"\nsteps = 40\n[[box]]\n"
             "position = [0.0, 0.0, 0.7]\n");
  shop.write("s/cases/" + name + "/metrics.toml", front + kRules);
}

TEST(HeavyCheck, SaysOfEachCaseWhetherItWasGoneOnWith) {
  const Workshop shop;
  write_case(shop, "own", "");
  write_case(shop, "engine", "[command]\nrun = \"" TUMBLE_PROGRAM " record {scene} -o {log} --quiet\"\n");
  ASSERT_EQ(shop.run({"bless", "own", "engine", "--suite", "s", "--reason", "new"}).exit, 0);
  const Outcome plain = shop.run({"check", "--suite", "s"});
  EXPECT_FALSE(shows(plain.out, "gone on with")) << plain.out;
  const Outcome heavy = shop.run({"check", "--suite", "s", "--heavy", "--report", "one"});
  EXPECT_EQ(heavy.exit, 0) << heavy.out << heavy.err;
  EXPECT_TRUE(shows(heavy.out, "; gone on with from each of 40 steps: same bits")) << heavy.out;
  EXPECT_TRUE(shows(heavy.out, "; not gone on with from each step: the session is another engine's")) << heavy.out;
  EXPECT_TRUE(shows(heavy.out, "heavy   1 of 2 gone on with from each step; not so: engine\n")) << heavy.out;
  const nlohmann::ordered_json json = nlohmann::ordered_json::parse(shop.read("one/report.json"));
  for (const auto& one : json.at("cases"))
    EXPECT_EQ(shows(one.at("gone_on"), "same bits"), one.at("name") == "own") << one.at("gone_on");
  for (const auto& one : json.at("cases")) EXPECT_EQ(one.at("was_gone_on"), one.at("name") == "own");
}

TEST(HeavyCheck, IsAnotherCheckThanOneThatIsNot) {
  const Workshop shop;
  for (const char* name : {"one", "two", "three", "four"}) write_case(shop, name, "");
  ASSERT_EQ(shop.run({"bless", "one", "two", "three", "four", "--suite", "s", "--reason", "new"}).exit, 0);
  ASSERT_EQ(shop.run({"check", "--suite", "s", "--heavy", "--shard", "1/2", "--report", "a"}).exit, 0);
  ASSERT_EQ(shop.run({"check", "--suite", "s", "--shard", "2/2", "--report", "b"}).exit, 0);
  const Outcome merged = shop.run({"check", "--merge", "a", "b", "--report", "m"});
  EXPECT_EQ(merged.exit, 2) << merged.out;
  EXPECT_TRUE(shows(merged.err, "options")) << merged.err;
  EXPECT_TRUE(shows(merged.err, " --heavy")) << merged.err;
  EXPECT_FALSE(shows(merged.err, "--heavy yes")) << "there is no such option: " << merged.err;
  EXPECT_EQ(shop.run({"check", "--merge", "--heavy", "a", "b"}).exit, 2);
}

}  // namespace
}  // namespace tumble::test
