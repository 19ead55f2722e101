// bisect of a user's engine: each revision is built and run as tumble.toml says, and what goes wrong is said with its
// reason.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/tools/json_output.h"
#include "tests/tools/toy.h"

namespace tumble::test {
namespace {

/// A clone whose engine is a script; the second of three commits plants the fault.
void make_history(const Workshop& shop, const std::string& ignored = "toy.sh\n") {
  const std::string commits = "cd '" + shop.path("project") + R"('
commit() {
  printf '#!/bin/sh\nexec '"'"')" TUMBLE_TOY_ENGINE R"('"'"' "$@" %s\n' "$1" >toy.in
  git add -A && git -c user.name=a -c user.email=a@b commit --allow-empty -qm "$2"
}
git init -q -b main && commit "" first && commit "" second && commit "--fault 9" faulty && commit "--fault 9 " last)";
  shop.write("project/engine/tumble.toml",
             "[engine]\nbuild = ['cp ../toy.in toy.sh', 'chmod +x toy.sh']\nrun = './toy.sh --log {log} --inputs "
             "{inputs}'\n");
  shop.write("project/.gitignore", ignored);
  ASSERT_EQ(std::system(("{ " + commits + "\n} >'" + shop.path("said") + "' 2>&1").c_str()), 0) << shop.read("said");
}

TEST(EngineProject, BisectBuildsAndRunsEachRevision) {
  const Workshop shop;
  make_history(shop);
  record_toy(shop, "a.tumble");
  const Outcome found = shop.run({"bisect", "--repo", "project/engine", "--good", "HEAD~3", "--bad", "HEAD", "a.tumble",
                                  "--work", "work", "--json"});
  EXPECT_EQ(found.exit, 1) << found.err;
  EXPECT_EQ(parsed(found)["commit"]["subject"], "faulty");
  EXPECT_EQ(parsed(found)["sessions"]["first"]["field"], "position.z");
  const Outcome without = shop.run({"bisect", "--repo", "project", "--good", "HEAD~3", "--bad", "HEAD", "a.tumble"});
  EXPECT_EQ(without.exit, 2);
  EXPECT_TRUE(says(without.err, "there is no tumble.toml")) << without.err;
}

/// The lines that builds wrote: one for each that found nothing of the build before.
std::size_t builds_from_scratch(const Workshop& shop) {
  const std::string text = shop.read("scratch");
  return static_cast<std::size_t>(std::ranges::count(text, '\n'));
}

// A folder that git does not ignore goes before each revision, so that nothing of it can reach the next one: that costs
// a build from scratch a revision, which is said. The clone ignores what the user's own list names.
TEST(EngineBisect, SaysThatABuildFolderIsRemovedUnlessGitIgnoresIt) {
  const Workshop shop;
  make_history(shop, "nothing\n");
  record_toy(shop, "a.tumble");
  shop.write("project/engine/tumble.toml",
             "[engine]\nshell = true\nbuild = \"test -d out || echo >>'" + shop.path("scratch") +
                 "'; mkdir -p out && cp ../toy.in out/toy && chmod +x out/toy\"\nrun = 'out/toy --log {log} --inputs "
                 "{inputs}'\n");
  const auto bisect = [&] {
    return shop.run({"bisect", "--repo", "project/engine", "--good", "HEAD~3", "--bad", "HEAD", "a.tumble"});
  };
  const Outcome told = bisect();
  EXPECT_EQ(told.exit, 1) << told.err;
  EXPECT_TRUE(says(told.err, "built from scratch: engine/out/; name it in .git/info/exclude")) << told.err;
  EXPECT_EQ(told.err.find("built from scratch"), told.err.rfind("built from scratch")) << told.err;
  EXPECT_EQ(builds_from_scratch(shop), 4U) << told.out;
  shop.write("scratch", "");
  shop.write("project/.git/info/exclude", "out/\n");
  const Outcome kept = bisect();
  EXPECT_EQ(kept.exit, 1) << kept.err;
  EXPECT_FALSE(says(kept.err, "built from scratch")) << kept.err;
  EXPECT_EQ(builds_from_scratch(shop), 1U) << kept.out;
}

// The file with the output is gone by the time that somebody reads the answer: the reason stands in the line itself.
TEST(EngineBisect, SaysWhyARevisionDoesNotBuild) {
  const Workshop shop;
  make_history(shop);
  record_toy(shop, "a.tumble");
  shop.write(
      "project/engine/tumble.toml",
      "[engine]\nshell = true\nbuild = \"cp ../toy.in toy.sh && chmod +x toy.sh; git log -1 --format=%s | grep -q "
      "second || exit 0; printf 'FAILED: a.o\\nglue.cpp:3:5: error: no member %s\\nninja: stopped\\n' speed; exit "
      "1\"\nrun = './toy.sh --log {log} --inputs {inputs}'\n");
  const Outcome found =
      shop.run({"bisect", "--repo", "project/engine", "--good", "HEAD~3", "--bad", "HEAD", "a.tumble"});
  EXPECT_EQ(found.exit, 4) << found.out << found.err;
  EXPECT_TRUE(says(found.out, "ended with status 1: glue.cpp:3:5: error: no member speed")) << found.out;
  EXPECT_TRUE(says(found.out, "one of these 2 commits")) << found.out;
}

// A stream holds no scene, and old revisions have no file of one: --scene is one file for all of them. More than one
// commit changes this session: the next one is not passed over in silence.
TEST(EngineBisect, TakesASceneForAllRevisionsAndNamesARevisionThatDiffersAgain) {
  const Workshop shop;
  shop.write("project/tumble.toml", "[engine]\nshell = true\nrun = \"sh engine.sh {scene} {log}\"\n");
  shop.write("scene.txt", "ok\n");
  shop.write("engine.in",
             "grep -q ok \"$1\" || exit 1\nexec '" TUMBLE_TOY_ENGINE "' --log \"$2\" --push 10:2:3 FAULT\n");
  const std::string history = "cd '" + shop.path("project") + R"(' && git init -q -b main
commit() {
  sed "s/FAULT/$1/" ../engine.in >engine.sh
  git add -A && git -c user.name=a -c user.email=a@b commit --allow-empty -qm "$2"
}
commit "" first && commit "--fault 9" second && commit "--fault 9 " third && commit "--fault 5" last)";
  ASSERT_EQ(std::system(("{ " + history + "\n} >'" + shop.path("said") + "' 2>&1").c_str()), 0) << shop.read("said");
  record_toy(shop, "a.tumble");
  const std::vector<std::string> question = {"bisect", "--repo", "project",  "--good",    "HEAD~3",
                                             "--bad",  "HEAD",   "a.tumble", "--timeout", "30"};
  const Outcome none = shop.run(question);
  EXPECT_EQ(none.exit, 2) << none.out;
  EXPECT_TRUE(says(none.err, "run of tumble.toml: found {scene}")) << "nobody gave --run\n" << none.err;
  EXPECT_TRUE(says(none.err, "name the file by --scene")) << none.err;
  std::vector<std::string> with = question;
  with.insert(with.end(), {"--scene", "scene.txt"});
  const Outcome found = shop.run(with);
  EXPECT_EQ(found.exit, 1) << found.out << found.err;
  EXPECT_TRUE(says(found.out, "subject  second")) << found.out;
  EXPECT_TRUE(says(found.out, "a later commit changed the session again: ")) << found.out;
  with.back() = "no_such.txt";
  EXPECT_EQ(shop.run(with).exit, 2);
  shop.write("project/tumble.toml", "[engine]\nrun = 'sh engine.sh scene.txt {log}'\n");
  with.back() = "scene.txt";
  EXPECT_TRUE(says(shop.run(with).err, "--scene: found no {scene}"));
}

// Runs that leave the log alike and part later: their difference from the log is one sentence, said once.
TEST(EngineBisect, TwoRunsThatPartLaterAreNotTwoSentencesThatSayTheSame) {
  const Workshop shop;
  shop.write("project/tumble.toml", "[engine]\nshell = true\nrun = \"sh engine.sh {log}\"\n");
  shop.write("project/.gitignore", "runs\n");
  shop.write("project/engine.sh", "echo run >>'" + shop.path("runs") +
                                      "'\nexec '" TUMBLE_TOY_ENGINE
                                      "' --log \"$1\" --push 5:1:2 --push 20:2:$(wc -l <'" +
                                      shop.path("runs") + "')\n");
  const std::string history =
      "cd '" + shop.path("project") +
      "' && git init -q -b main && git add -A && git -c user.name=a -c user.email=a@b commit -qm "
      "first && git -c user.name=a -c user.email=a@b commit --allow-empty -qm second";
  ASSERT_EQ(std::system(("{ " + history + "\n} >'" + shop.path("said") + "' 2>&1").c_str()), 0) << shop.read("said");
  record_toy(shop, "a.tumble");
  const Outcome outcome =
      shop.run({"bisect", "--repo", "project", "--good", "HEAD~1", "--bad", "HEAD", "a.tumble", "--timeout", "30"});
  EXPECT_EQ(outcome.exit, 2) << outcome.out;
  EXPECT_TRUE(says(outcome.err, "two runs: ")) << outcome.err;
  EXPECT_TRUE(says(outcome.err, ", and each another way in later steps")) << outcome.err;
}

}  // namespace
}  // namespace tumble::test
