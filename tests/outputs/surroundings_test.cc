// Limits and settings that a process inherits: what cannot work ends with status 4 and a reason.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/outputs/small_table.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

using Words = std::vector<std::string>;

void expect_reason(const Outcome& outcome, const std::string& part) {
  EXPECT_EQ(outcome.exit, 4) << outcome.out << outcome.err;
  EXPECT_TRUE(outcome.err.starts_with("tumble")) << outcome.err;
  EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("internal error"), std::string::npos) << outcome.err;
}

TEST(Surroundings, AFileThatReachesItsLimitIsAnError) {
  const Workshop shop;
  shop.record_small("a");
  expect_reason(shop.run_after("ulimit -f 4; ", {"record", "a.toml", "-o", "b.tumble"}), "File too large");
  expect_reason(shop.run_after("ulimit -f 1; ", {"measure", "a.tumble", "--series", "s.csv"}), "File too large");
  expect_reason(shop.run_after("ulimit -f 1; ", {"dump", "a.tumble", "--steps", "0:40", "--csv"}), "standard output");
}

TEST(Surroundings, ATooSmallStackIsAnError) {
  const Workshop shop;
  shop.record_small("a");
  for (const Words& words : {Words{"record", "a.toml", "-o", "b.tumble"}, Words{"check", "--suite", "s"},
                             Words{"render", "a.tumble"}, Words{"measure", "a.tumble"}}) {
    expect_reason(shop.run_after("ulimit -s 64; ", words), "stack of 64 KiB");
  }
  EXPECT_EQ(shop.run_after("ulimit -s 512; ", {"measure", "a.tumble"}).exit, 0);
}

TEST(Surroundings, ARemovedFolderIsAnError) {
  const Workshop shop;
  shop.record_small("a");
  for (const Words& words : {Words{"record", "a.toml"}, Words{"check"}, Words{"info", "a.tumble"}}) {
    expect_reason(shop.run_after("mkdir g; cd g; rmdir ../g; ", words), "the current folder was removed");
  }
  EXPECT_EQ(shop.run_after("mkdir g; cd g; rmdir ../g; ", {"--version"}).exit, 0);
}

// A canary that cannot write its files would tell that the build cannot be trusted.
TEST(Surroundings, ANonexistentPlaceForTemporaryFilesIsAnError) {
  const Workshop shop;
  shop.record_small("a");
  for (const Words& words :
       {Words{"check", "bounce"}, Words{"bless", "bounce", "--reason", "x"}, Words{"bench", "export"},
        Words{"hunt", "--count", "1"}, Words{"bisect", "--good", "a", "--bad", "b", "a.tumble"}}) {
    expect_reason(shop.run_after("export TMPDIR=/none; ", words), "TMPDIR: ");
  }
  EXPECT_EQ(shop.names_with("tumble-").size(), 0U) << "nothing is written here instead";
  EXPECT_EQ(shop.run_after("export TMPDIR=/none; ", {"info", "a.tumble"}).exit, 0) << "needs none";
}

#if !defined(__SANITIZE_ADDRESS__)
TEST(Surroundings, AWrongFloatingPointEnvironmentIsAnError) {
  const Workshop shop;
  shop.record_small("a");
  shop.write("t.csv", kSmallTable);
  Words modes = {"upward"};
#ifdef __SSE2__
  modes.insert(modes.end(), {"ftz", "daz"});
#endif
  for (const std::string& mode : modes) {
    const std::string before = "export LD_PRELOAD='" TUMBLE_WRONG_FLOATS "' WRONG_FLOATS=" + mode + "; ";
    for (const Words& words :
         {Words{"record", "a.toml", "-o", "b.tumble"}, Words{"replay", "a.tumble"}, Words{"measure", "a.tumble"},
          Words{"diff", "a.tumble", "a.tumble"}, Words{"diff", "a.tumble", "a.tumble", "--tolerance", "position=1"},
          Words{"bisect", "a.tumble", "a.tumble"}, Words{"check"}, Words{"import", "t.csv"},
          Words{"dump", "a.tumble", "--step", "3"}, Words{"render", "a.tumble"},
          Words{"bless", "--all", "--reason", "x"}, Words{"recover", "a.tumble", "-o", "c.tumble"}}) {
      expect_reason(shop.run_after(before, words), "floating-point environment");
    }
  }
}
#endif

}  // namespace
}  // namespace tumble::test
