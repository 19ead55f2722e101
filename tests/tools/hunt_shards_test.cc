// `tumble hunt --shard K/N` and `--merge`: the shards of a hunt are the hunt, and a shard that is wrong is named.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "golden/bundle/sealed_text.h"
#include "tests/support/program.h"

namespace tumble::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Seed 2 against a build whose gravity is weaker by a thousandth: there are findings to merge.
class HuntShards : public ::testing::Test {
 protected:
  HuntShards() {
    shop_.write("other.sh", "#!/bin/sh\nexec " TUMBLE_PROGRAM " \"$@\" --set 'world.gravity=[0,0,-9.8]'\n");
    fs::permissions(shop_.path("other.sh"), fs::perms::owner_all);
  }

  [[nodiscard]] Outcome hunt(const std::string& folder, const Words& more) const {
    Words words = {"hunt",       "--seed",   "2",      "--count",   "14",
                   "--relation", "finishes", "--json", "--against", shop_.path("other.sh"),
                   "--unshrunk", "--folder", folder};
    words.insert(words.end(), more.begin(), more.end());
    return shop_.run(words);
  }
  [[nodiscard]] Outcome merge(const Words& folders, const std::string& out) const {
    Words words = {"hunt", "--folder", out, "--json"};
    for (const std::string& folder : folders) words.insert(words.end(), {"--merge", folder});
    return shop_.run(words);
  }
  void hunt_shards() const {
    ASSERT_EQ(hunt("one", {"--shard", "1/2"}).exit, 1);
    ASSERT_EQ(hunt("two", {"--shard", "2/2"}).exit, 1);
  }
  void expect_refused(const Words& folders, const Words& parts, int exit = 2) const {
    const Outcome run = merge(folders, "refused");
    EXPECT_EQ(run.exit, exit) << run.out;
    for (const std::string& part : parts) EXPECT_TRUE(holds(run.err, part)) << part << "\n" << run.err;
    EXPECT_FALSE(fs::exists(shop_.path("refused")));
  }

  Workshop shop_;
};

TEST_F(HuntShards, MergeToTheHuntThatHasNone) {
  hunt_shards();
  const Outcome whole = hunt("whole", {}), merged = merge({"two", "one"}, "merged");
  ASSERT_EQ(whole.exit, 1) << whole.err;
  ASSERT_EQ(merged.exit, 1) << merged.err;
  Json wanted = Json::parse(whole.out), found = Json::parse(merged.out);
  EXPECT_EQ(found.at("merged"), 2);
  EXPECT_EQ(wanted.at("scenes"), 14);
  EXPECT_GT(wanted.at("findings").size(), 3U);
  found["merged"] = 0;
  EXPECT_EQ(found, wanted);
  for (const Json& one : wanted.at("findings")) {
    const std::string file = "/findings/" + one.at("name").get<std::string>() + ".toml";
    EXPECT_EQ(shop_.read("merged" + file), shop_.read("whole" + file));
  }
}

TEST_F(HuntShards, NameTheShardThatIsLostDoubledForeignOrDamaged) {
  hunt_shards();
  fs::copy(shop_.path("two"), shop_.path("again"), fs::copy_options::recursive);
  expect_refused({"one"},
                 {"merged: 1 problem:\n", "shard 2 of 2: is missing: none of the folders holds one that can be merged",
                  "--shard 2/2"});
  expect_refused({"one", "two", "again"}, {"again: shard 2 of 2: is there twice: two holds it too"});
  expect_refused({"one", "nowhere"}, {"nowhere: holds no hunt.json", "shard 2 of 2: is missing"});
  Json state = Json::parse(shop_.read("again/hunt.json"));
  const auto spoiled = [&](const char* key, const Json& value) {
    Json other = state;
    other[key] = value;
    other.erase("hash");
    shop_.write("again/hunt.json", golden::sealed(other.dump(1)));
  };
  spoiled("seed", 3);
  expect_refused({"one", "again"}, {"again: shard 2 of 2: holds a hunt of another seed: found 3", "is missing"});
  spoiled("program", "0.0.1 commit not known");
  expect_refused({"one", "again"}, {"again: shard 2 of 2: holds a hunt of another program: found 0.0.1"});
  spoiled("engine_hash", "00");
  expect_refused({"one", "again"}, {"another build of the other program (its files' hash): found 00"});
  spoiled("shards", 3);
  expect_refused({"one", "again"}, {"again: shard 2 of 3: holds a hunt of another shard"});
  spoiled("ended", false);
  expect_refused({"one", "again"}, {"again: shard 2 of 2: is not at its end: 7 scenes of 7 are judged"});
  spoiled("count", 24);
  expect_refused({"one", "again"}, {"again: shard 2 of 2: is of a hunt of another --count: found 24, wanted 14",
                                    "again: shard 2 of 2: is not at its end: 7 scenes of 12 are judged"});
  spoiled("count", nullptr);
  expect_refused({"one", "again"}, {"again: shard 2 of 2: was ended by --time alone"});
  spoiled("scenes", 10000);
  expect_refused({"one", "again"}, {"again/hunt.json: damaged: found 7 scenes by finishes, wanted 10000"}, 3);
  spoiled("findings", Json::array());
  expect_refused({"one", "again"}, {"again/hunt.json: damaged: it counts "}, 3);
  state["scenes"] = 8;  // without a new hash
  const std::string text = state.dump(1) + '\n';
  shop_.write("again/hunt.json", text);
  expect_refused({"one", "again"}, {"again/hunt.json: damaged: its text has the hash "}, 3);
  shop_.write("again/hunt.json", text.substr(0, text.size() / 2));
  expect_refused({"one", "again"}, {"again/hunt.json: damaged", "shard 2 of 2: is missing"}, 3);
}

// Each is at its own end; together they are no hunt.
TEST_F(HuntShards, OfUnequalLengthAreNoHunt) {
  ASSERT_EQ(hunt("one", {"--shard", "1/2"}).exit, 1);
  const Outcome longer = shop_.run({"hunt", "--seed", "2", "--count", "24", "--relation", "finishes", "--against",
                                    shop_.path("other.sh"), "--unshrunk", "--folder", "two", "--shard", "2/2"});
  ASSERT_EQ(longer.exit, 1) << longer.err;
  expect_refused({"one", "two"}, {"two: shard 2 of 2: is of a hunt of another --count: found 24, wanted 14"});
  const Outcome timed = shop_.run({"hunt", "--seed", "2", "--time", "0.1", "--relation", "finishes", "--against",
                                   shop_.path("other.sh"), "--unshrunk", "--folder", "timed", "--shard", "2/2"});
  ASSERT_LT(timed.exit, 2) << timed.err;
  expect_refused({"one", "timed"}, {"timed: shard 2 of 2: was ended by --time alone"});
}

TEST_F(HuntShards, AreNotMergedOverAHuntThatIsThere) {
  hunt_shards();
  ASSERT_EQ(merge({"one", "two"}, "out").exit, 1);
  Outcome again = merge({"one", "two"}, "out");
  EXPECT_EQ(again.exit, 2);
  EXPECT_TRUE(holds(again.err, "out: holds a hunt")) << again.err;
  // Damaged, it may still be somebody's hunt.
  shop_.write("out/hunt.json", "{");
  again = merge({"one", "two"}, "out");
  EXPECT_EQ(again.exit, 2);
  EXPECT_TRUE(holds(again.err, "out: holds a hunt")) << again.err;
  EXPECT_EQ(shop_.read("out/hunt.json"), "{");
  const Outcome on = hunt("out", {});
  EXPECT_EQ(on.exit, 3) << "no hunt goes on with it either";
}

TEST_F(HuntShards, GoOnWithTheirOwnProgramAlone) {
  ASSERT_EQ(hunt("one", {"--shard", "1/2"}).exit, 1);
  shop_.write("other.sh", shop_.read("other.sh") + "# built again\n");
  const Outcome on = hunt("one", {"--shard", "1/2"});
  EXPECT_EQ(on.exit, 2);
  EXPECT_TRUE(holds(on.err, "another build of the other program (its files' hash)")) << on.err;
}

}  // namespace
}  // namespace tumble::test
