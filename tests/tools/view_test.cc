// `tumble view` as docs/commands.md describes it; tests/session_page works its pages in a browser.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/program.h"
#include "tests/tools/engine_table.h"

namespace tumble::test {
namespace {

TEST(View, WritesAPageThatHoldsTheSession) {
  const Workshop shop;
  shop.record_small("s");
  const Outcome made = shop.run({"view", "s.tumble", "-o", "s.html"});
  ASSERT_EQ(made.exit, 0) << made.err;
  EXPECT_TRUE(says(made.out, "s.html: ")) << made.out;
  EXPECT_TRUE(says(made.out, "s.tumble: every state, 41 in all")) << made.out;
  const std::string page = shop.read("s.html");
  EXPECT_TRUE(page.starts_with("<!doctype html>"));
  EXPECT_TRUE(says(page, "default-src 'none'") || says(page, "default-src &#39;none&#39;"));
  EXPECT_TRUE(says(page, "id=\"session-0-frames\""));
  EXPECT_FALSE(says(page, "id=\"session-0-difference\""));
}

TEST(View, PutsTwoLogsAndTheirComparisonIntoOnePage) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--set", "world.gravity=[0, 0, -9.8]"});
  const Outcome made = shop.run({"view", "a.tumble", "b.tumble", "-o", "both.html"});
  ASSERT_EQ(made.exit, 0) << made.err;
  const std::string page = shop.read("both.html");
  EXPECT_TRUE(says(page, "id=\"session-1-frames\""));
  EXPECT_TRUE(says(page, "id=\"session-0-difference\""));
}

TEST(View, KeepsToItsSize) {
  const Workshop shop;
  shop.record_small("s", {"--seconds", "20"});
  const Outcome made = shop.run({"view", "s.tumble", "-o", "s.html", "--megabytes", "0.76"});
  ASSERT_EQ(made.exit, 0) << made.err;
  EXPECT_TRUE(says(made.out, " of 1201 states, to 0.1 mm")) << made.out;
  EXPECT_LE(std::filesystem::file_size(shop.path("s.html")), 760'000U);
}

// A metric that compares with another scene has no value step by step, and says so.
TEST(View, TakesTheBoundsOfACase) {
  const Workshop shop;
  shop.record_small("s");
  const std::string rules =
      "[[metric]]\nname = \"lost\"\nmax = 0.0\nwhy = \"none\"\n"
      "[[metric]]\nname = \"drift_max\"\nmin = 0.5\nmax = 2.0\nbodies = [1]\nwhy = \"it moves\"\n";
  shop.write("metrics.toml", rules + "[[metric]]\nname = \"order_error\"\nmax = 0.0\nwhy = \"none\"\n");
  const Outcome made = shop.run({"view", "s.tumble", "-o", "s.html", "--bounds", "metrics.toml"});
  ASSERT_EQ(made.exit, 0) << made.err;
  EXPECT_TRUE(says(made.err, "order_error compares with a transformed scene")) << made.err;
  const std::string page = shop.read("s.html");
  for (const char* bound : {R"(lost \u003c= 0)", "drift_max of 1 >= 0.5", R"(drift_max of 1 \u003c= 2)"}) {
    EXPECT_TRUE(says(page, bound)) << bound;
  }
  shop.write("wrong.toml", "[[metric]]\nname = \"wobble\"\nmax = 0.0\nwhy = \"none\"\n");
  const Outcome wrong = shop.run({"view", "s.tumble", "-o", "s.html", "--bounds", "wrong.toml"});
  EXPECT_EQ(wrong.exit, 2);
  EXPECT_TRUE(says(wrong.err, "wrong.toml")) << wrong.err;
}

// Bounds of a case are metres in every engine; the lane has the session's unit.
TEST(View, TakesTheBoundsOfAnEnginesCaseAsCheckDoes) {
  const Workshop shop;
  const std::string centimetres = "# length: cm\n" + table();
  ASSERT_EQ(import(shop, centimetres).exit, 0);
  const std::string rule = "[command]\nrun = \"x {scene} {log}\"\n[[metric]]\nname = \"drift_max\"\nmax = 2.0\n";
  const std::string against = "[[metric]]\nname = \"parting_time.0.1\"\nmin = 0.1\nagainst = \"o\"\nwhy = \"x\"\n";
  shop.write("metrics.toml", rule + "why = \"x\"\n" + against);
  const Outcome made = shop.run({"view", "t.tumble", "-o", "t.html", "--bounds", "metrics.toml"});
  ASSERT_EQ(made.exit, 0) << made.err;
  EXPECT_TRUE(says(shop.read("t.html"), R"(drift_max \u003c= 200)"));
  EXPECT_TRUE(says(made.err, "parting_time.0.1 compares with another session")) << made.err;
  shop.write("metrics.toml", rule + "bodies = \"wheel\"\nwhy = \"x\"\n");
  const Outcome none = shop.run({"view", "t.tumble", "-o", "t.html", "--bounds", "metrics.toml"});
  EXPECT_EQ(none.exit, 2) << "all bodies in place of one that is not there";
  EXPECT_TRUE(says(none.err, "metrics.toml:4: drift_max: ") && says(none.err, "wheel")) << none.err;
}

TEST(View, RefusesBadUsage) {
  const Workshop shop;
  shop.record_small("s");
  EXPECT_EQ(shop.run({"view", "none.tumble", "-o", "p.html"}).exit, 2);
  EXPECT_EQ(shop.run({"view", "s.tumble", "-o", "s.tumble"}).exit, 2);
  EXPECT_EQ(shop.run({"view", "s.tumble", "-o", "p.html", "--port", "80"}).exit, 2);
  EXPECT_EQ(shop.run({"view", "s.tumble", "--megabytes", "3"}).exit, 2);
  EXPECT_EQ(shop.run({"view", "s.tumble", "--port", "70000"}).exit, 2);
  shop.write("broken.tumble", "no log");
  EXPECT_EQ(shop.run({"view", "broken.tumble"}).exit, 2);
}

TEST(View, ShowsTheIntactPartOfATornLog) {
  const Workshop shop;
  shop.record_small("s", {"--seconds", "5"});
  const std::string bytes = shop.read("s.tumble");
  shop.write("torn.tumble", bytes.substr(0, bytes.size() * 3 / 4));
  const Outcome made = shop.run({"view", "torn.tumble", "-o", "torn.html"});
  EXPECT_EQ(made.exit, 3);
  EXPECT_TRUE(says(made.err, "torn"));
  EXPECT_TRUE(says(shop.read("torn.html"), "session-0-frames"));
}

TEST(View, SaysWhyASessionMayHaveGoneOn) {
  const Workshop shop;
  shop.record_small("s", {"--seconds", "12"});
  EXPECT_EQ(shop.run({"view", "s.tumble", "-o", "s.html"}).exit, 0);
  EXPECT_TRUE(says(shop.read("s.html"), R"("cut_short":"")"));
  const std::string bytes = shop.read("s.tumble");
  shop.write("torn.tumble", bytes.substr(0, bytes.size() * 3 / 4));
  ASSERT_EQ(shop.run({"recover", "torn.tumble", "-o", "saved.tumble"}).exit, 3);
  const Outcome made = shop.run({"view", "saved.tumble", "-o", "saved.html"});
  EXPECT_EQ(made.exit, 0) << made.err;
  EXPECT_TRUE(says(shop.read("saved.html"), R"("cut_short":"recovered up to step )"));
}

}  // namespace
}  // namespace tumble::test
