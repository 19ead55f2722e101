// Shapes of an engine's bodies and inputs by name: no verdict of a session says that they agree where they do not.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.h"
#include "tests/tools/stream_toy.h"

namespace tumble::test {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A case of that engine, blessed; it requires behaviour alone.
void bless_case(const Workshop& shop, const std::string& options) {
  write_falling(shop, options);
  shop.write("golden/cases/fall/metrics.toml",
             "require = [\"behaviour\"]\n[engine]\ntitle = \"falling\"\ncategory = \"toys\"\ninputs = \"inputs.txt\"\n"
             "[[metric]]\nname = \"lateral_max\"\nmax = 500\nwhy = \"a test\"\n");
  shop.write("golden/cases/fall/inputs.txt", "{}\n");
  const Outcome blessed = shop.run({"bless", "fall", "--reason", "a test"});
  ASSERT_EQ(blessed.exit, 0) << blessed.err;
}

/// What check says of a session with these options.
Outcome check_with(const Workshop& shop, const std::string& options) {
  write_falling(shop, options);
  return shop.run({"check", "--report", "r"});
}

/// Check fails for a session with these options, and says so.
void expect_fails(const Workshop& shop, const std::string& options, const std::string& sentence) {
  const Outcome outcome = check_with(shop, options);
  EXPECT_EQ(outcome.exit, 1) << outcome.out;
  EXPECT_TRUE(has(outcome.out, sentence)) << outcome.out;
}

TEST(EngineShapes, CheckNamesABodyOfAnotherShape) {
  const Workshop shop;
  bless_case(shop, "--sphere 1 --late");
  const Outcome same = check_with(shop, "--sphere 1 --late");
  EXPECT_EQ(same.exit, 0) << same.out;
  expect_fails(shop, "--late", "another shape: body 1: expected sphere of radius 0.5 m, actual box");
  expect_fails(shop, "--sphere 2 --late", "body 2: expected box, actual sphere of radius 0.5 m");
}

TEST(EngineShapes, CheckNamesOneThatAppearsLater) {
  const Workshop shop;
  bless_case(shop, "--sphere 3 --late");
  expect_fails(shop, "--late", "another shape: body 3: expected sphere of radius 0.5 m, actual box");
}

TEST(EngineShapes, CheckSaysOfABodyOfOneSideThatItIsOneOfThem) {
  const Workshop shop;
  bless_case(shop, "");
  const Outcome more = check_with(shop, "--sphere 3 --late");
  EXPECT_EQ(more.exit, 1) << more.out;
  EXPECT_TRUE(has(more.out, "body 3 is not in the golden")) << more.out;
  EXPECT_FALSE(has(more.out, "another shape")) << more.out;
  EXPECT_FALSE(has(more.out, ", id")) << more.out;
  bless_case(shop, "--sphere 3 --late");
  const Outcome fewer = check_with(shop, "");
  EXPECT_EQ(fewer.exit, 1) << fewer.out;
  EXPECT_TRUE(has(fewer.out, "body 3 is in the golden and not in the session")) << fewer.out;
  EXPECT_FALSE(has(fewer.out, "another shape")) << fewer.out;
}

TEST(EngineShapes, DiffSaysWhichSideHasABody) {
  const Workshop shop;
  record_falling(shop, "a");
  record_falling(shop, "b", "--sphere 3 --late");
  const auto json = nlohmann::json::parse(shop.run({"diff", "a.tumble", "b.tumble", "--json"}).out);
  EXPECT_EQ(json["effect"]["field"], "body");
  EXPECT_EQ(json["effect"]["body"], 3);
  EXPECT_EQ(json["effect"]["expected"], nullptr);
  EXPECT_EQ(json["effect"]["actual"], 3);
  EXPECT_EQ(json["aftermath"]["last"]["only_in_a"], 0);
  EXPECT_EQ(json["aftermath"]["last"]["only_in_b"], 1);
  const std::string text = shop.run({"diff", "a.tumble", "b.tumble"}).out;
  EXPECT_TRUE(has(text, "body 3, only in b.tumble")) << text;
  EXPECT_TRUE(has(text, "0 m, step 5, of the bodies that both have")) << text;
  EXPECT_TRUE(has(text, "at the end 1 body only in b.tumble")) << text;
}

TEST(EngineShapes, CheckNamesAnInputByNameThatTheGoldenLacks) {
  const Workshop shop;
  bless_case(shop, "");
  const Outcome poked = check_with(shop, "--poke 7");
  EXPECT_EQ(poked.exit, 1) << poked.out;
  EXPECT_TRUE(has(poked.out, "channel.input.poke: the golden has no such input")) << poked.out;
}

TEST(EngineShapes, DiffNamesOneThatAppearsLater) {
  const Workshop shop;
  record_falling(shop, "a", "--late");
  record_falling(shop, "b", "--late --sphere 3");
  const Outcome diff = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_EQ(diff.exit, 1) << diff.out;
  EXPECT_TRUE(has(diff.out, "only b.tumble has this shape of body 3")) << diff.out;
  EXPECT_EQ(shop.run({"diff", "a.tumble", "a.tumble"}).exit, 0);
}

}  // namespace
}  // namespace tumble::test
