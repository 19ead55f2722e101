// Commands that say "same" have read what they speak of: damage goes before every other status, and answers say what
// they looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/support/program.h"
#include "tests/tools/json_output.h"

namespace tumble::test {
namespace {

using nlohmann::ordered_json;

bool says(const Outcome& outcome, const std::string& words) { return outcome.out.find(words) != std::string::npos; }

TEST(SameCommand, DamageGoesBeforeEveryOtherStatus) {
  const Workshop shop;
  const std::vector<std::string> long_one = {"--steps", "200", "--set", "world.freezing=false"};  // of several chunks
  std::vector<std::string> other = long_one;
  other.insert(other.end(), {"--set", "input.1.velocity=[0.0, 6.5, 0.0]"});
  shop.record_small("a", long_one);
  shop.record_small("c", other);
  for (const char* name : {"a", "c"}) {
    const std::string whole = shop.read(std::string(name) + ".tumble");
    const std::size_t header = 3000;  // bytes that hold the header; what follows is the chunk, index and footer
    ASSERT_GT(whole.size(), 2 * header);
    for (std::size_t at = header; at < whole.size(); at += (whole.size() - header) / 5) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(bytes[at] ^ 16);
      shop.write("b.tumble", bytes);
      for (const std::vector<std::string>& words :
           {std::vector<std::string>{"diff", "a.tumble", "b.tumble"},
            {"diff", "b.tumble", "a.tumble", "--tolerance", "position=10", "--json"},
            {"bisect", "a.tumble", "b.tumble"},
            {"replay", "b.tumble"}}) {
        const Outcome outcome = shop.run(words);
        EXPECT_EQ(outcome.exit, 3) << words[0] << ' ' << name << " byte " << at << ": " << outcome.out << outcome.err;
        EXPECT_NE(outcome.err.find("b.tumble"), std::string::npos) << outcome.err;
      }
    }
  }
}

TEST(SameCommand, BriefSaysThatPayloadsWereNotRead) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b");
  shop.record_small("c", {"--set", "input.1.velocity=[0.0, 6.5, 0.0]"});
  const Outcome same = shop.run({"diff", "a.tumble", "b.tumble", "--brief"});
  EXPECT_EQ(same.exit, 0);
  EXPECT_TRUE(says(same, "identical: 40 steps, by hashes; payloads not read")) << same.out;
  EXPECT_TRUE(says(shop.run({"diff", "a.tumble", "c.tumble", "--brief"}), "payloads not read"));
  const ordered_json json = ordered_json::parse(shop.run({"diff", "a.tumble", "b.tumble", "--brief", "--json"}).out);
  EXPECT_EQ(json["read"], "hashes; payloads not read");
  const ordered_json all = ordered_json::parse(shop.run({"diff", "a.tumble", "b.tumble", "--json"}).out);
  EXPECT_EQ(all["read"], "every byte of both logs");
}

/// Two sessions of 40 steps that differ from step 5 on, by less than the tolerances of kAllowing.
void record_near(const Workshop& shop) {
  shop.record_small("a");
  shop.record_small("b", {"--set", "input.1.velocity=[0.0, 6.0000001, 0.0]"});
}
const std::vector<std::string> kAllowing = {
    "diff",        "a.tumble", "b.tumble",    "--tolerance",   "position=9",  "--tolerance",      "velocity=9",
    "--tolerance", "spin=9",   "--tolerance", "orientation=3", "--tolerance", "throw.velocity=1", "--brief"};

TEST(SameCommand, BriefWithTolerancesSaysThatStatesWereRead) {
  const Workshop shop;
  record_near(shop);
  const Outcome near = shop.run(kAllowing);
  EXPECT_EQ(near.exit, 0) << near.out << near.err;
  EXPECT_TRUE(says(near,
                   "same within tolerances: 40 steps, by hashes, and the states of 36 steps whose hashes differ; "
                   "other payloads not read"))
      << near.out;
  EXPECT_TRUE(says(near, "state hashes where they are equal, states of 36 steps whose hashes differ")) << near.out;
  std::vector<std::string> words = kAllowing;
  words.emplace_back("--json");
  const ordered_json json = ordered_json::parse(shop.run(words).out);
  EXPECT_EQ(json["read"], "hashes, and the states of 36 steps whose hashes differ; other payloads not read");
  const std::string whole = shop.read("b.tumble");
  for (std::size_t at = 3000; at < whole.size(); at += (whole.size() - 3000) / 9) {
    std::string bytes = whole;
    bytes[at] = static_cast<char>(bytes[at] ^ 16);
    shop.write("b.tumble", bytes);
    const Outcome damaged = shop.run(kAllowing);
    EXPECT_EQ(damaged.exit, 3) << "byte " << at << " of " << whole.size() << ": " << damaged.out << damaged.err;
  }
}

TEST(SameCommand, IdenticalListsWhatWasCompared) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b", {"--states", "hashes"});
  for (const std::vector<std::string>& words : {std::vector<std::string>{"diff", "a.tumble", "b.tumble"},
                                                {"bisect", "a.tumble", "b.tumble"},
                                                {"replay", "b.tumble"}}) {
    const Outcome outcome = shop.run(words);
    EXPECT_EQ(outcome.exit, 0) << outcome.err;
    const bool is_replay = words[0] == "replay";
    EXPECT_TRUE(says(outcome, is_replay ? "the world made of the scene" : "complete states of ")) << outcome.out;
    EXPECT_EQ(says(outcome, "states of 40 steps, which a log does not hold"), !is_replay) << outcome.out;
    std::vector<std::string> with_json = words;
    with_json.emplace_back("--json");
    const ordered_json json = ordered_json::parse(shop.run(with_json).out);
    EXPECT_FALSE(json["compared"].empty());
    EXPECT_FALSE(json["not_compared"].empty());
  }
}

TEST(SameCommand, AStepSideBySideSaysThatTheRestWasNotRead) {
  const Workshop shop;
  shop.record_small("a");
  shop.record_small("b");
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble", "--step", "7"});
  EXPECT_EQ(outcome.exit, 0);
  EXPECT_TRUE(says(outcome, "not the rest of the logs")) << outcome.out;
}

TEST(SameCommand, ADifferenceHasACauseAnEffectAndTheFilesNames) {
  const Workshop shop;
  shop.record_small("before");
  shop.record_small("after", {"--set", "material.friction=0.400001"});
  const Outcome outcome = shop.run({"diff", "before.tumble", "after.tumble"});
  ASSERT_EQ(outcome.exit, 1) << outcome.err;
  for (const char* words : {"header: material.friction: 0.4 → 0.400001", "cause   material.friction: 0.4 → 0.400001",
                            "effect  step ", "  before.tumble  ", "  after.tumble  ", " apart"}) {
    EXPECT_TRUE(says(outcome, words)) << words << "\n" << outcome.out;
  }
  const ordered_json json = ordered_json::parse(shop.run({"diff", "before.tumble", "after.tumble", "--json"}).out);
  EXPECT_EQ(json["cause"], "material.friction: 0.4 → 0.400001");
  EXPECT_TRUE(json["effect"].is_object());
  const auto& rows = json["header_differences"];
  EXPECT_TRUE(std::ranges::any_of(rows, [](const ordered_json& row) {
    return row["key"] == "material.friction" && row["expected"] == 0.4 && row["actual"] == 0.400001;
  })) << rows.dump();
}

/// Two logs, torn.tumble without its last bytes and flipped.tumble with a changed footer.
void damage_two(const Workshop& shop) {
  shop.record_small("s");
  std::string bytes = shop.read("s.tumble");
  shop.write("torn.tumble", bytes.substr(0, bytes.size() - 60));
  bytes[bytes.size() - 30] = static_cast<char>(bytes[bytes.size() - 30] ^ 1);
  shop.write("flipped.tumble", bytes);
  shop.write("two.tumble", shop.read("s.tumble") + shop.read("s.tumble"));
}

TEST(SameCommand, PartsOfADamagedLogAreNoPartOfTheAnswer) {
  const Workshop shop;
  damage_two(shop);
  for (const std::string name : {"torn.tumble", "flipped.tumble", "two.tumble"}) {
    for (const char* command : {"diff", "bisect"}) {
      const Outcome outcome = shop.run({command, name, name, "--json"});
      EXPECT_EQ(outcome.exit, 3) << command << ' ' << name;
      const ordered_json json = ordered_json::parse(outcome.out);
      EXPECT_EQ(json["read"], "the intact part of both logs") << name;
      ASSERT_EQ(json["notes"].size(), 1U) << json["notes"];
      EXPECT_NE(json["notes"][0].get<std::string>().find(name + " is not whole: "), std::string::npos) << json["notes"];
      EXPECT_NE(json["not_compared"].dump().find("of " + name + ": "), std::string::npos) << json["not_compared"];
    }
    const Outcome text = shop.run({"diff", name, "s.tumble"});
    EXPECT_TRUE(says(text, "  not compared")) << text.out;
    EXPECT_TRUE(says(text, "of " + name + ": ")) << text.out;
    const ordered_json replayed = ordered_json::parse(shop.run({"replay", name, "--json"}).out);
    EXPECT_NE(replayed["not_compared"].dump().find("of " + name + ": "), std::string::npos) << replayed;
  }
}

TEST(SameCommand, NothingGoesOnOrIsBlessedFromADamagedLogUnsaid) {
  const Workshop shop;
  damage_two(shop);
  for (const std::string name : {"torn.tumble", "flipped.tumble"}) {
    const Outcome on = shop.run({"record", "--from", name + ":10", "-o", "y.tumble", "--steps", "3"});
    EXPECT_EQ(on.exit, 3) << name << on.err;
    EXPECT_NE(on.err.find("'tumble recover' saves the intact part"), std::string::npos) << on.err;
    shop.write("s/cases/README", "a suite\n");
    const Outcome bless = shop.run({"bless", "one", "--from", name, "--suite", "s", "--reason", "r", "--dry-run"});
    EXPECT_EQ(bless.exit, 3) << name << bless.err;
    EXPECT_NE(bless.err.find("wanted a whole log"), std::string::npos) << bless.err;
  }
}

TEST(SameCommand, StepsThatNoLogHoldsAreNotCounted) {
  const Workshop shop;
  shop.record_small("s", {"--steps", "900"});
  std::string bytes = shop.read("s.tumble");
  char& changed = bytes[bytes.size() / 10 * 9];
  changed = static_cast<char>(changed ^ 1);
  shop.write("hurt.tumble", bytes);
  ASSERT_EQ(shop.run({"recover", "hurt.tumble", "-o", "r.tumble"}).exit, 3);
  const ordered_json json = ordered_json::parse(shop.run({"diff", "r.tumble", "r.tumble", "--json"}).out);
  ASSERT_LT(json["steps"], 900) << json;
  const std::string lost = std::to_string(900 - json["steps"].get<int>()) + " of 900 steps, lost from r.tumble: steps ";
  const std::string left_out = json["not_compared"].dump();
  EXPECT_NE(left_out.find(lost), std::string::npos) << left_out;
  EXPECT_EQ(left_out.find(lost), left_out.rfind(lost)) << "once per log";
  const Outcome measured = shop.run({"measure", "r.tumble"});
  EXPECT_EQ(measured.exit, 3);
  EXPECT_TRUE(says(measured, "note: measured up to step ")) << measured.out;
  EXPECT_TRUE(says(measured, "r.tumble is not whole: ")) << measured.out;
}

TEST(SameCommand, InputsBehindTheLastStepAreNamed) {
  const Workshop shop;
  shop.write("q.toml",
             std::string("[world]\nsteps = 9\n[[box]]\nposition = [0.0, 0.0, 9.0]\n") +
                 "[[input]]\nstep = 8\nkind = \"throw\"\nposition = [5.0, 0.0, 9.0]\nvelocity = [0.0, 1.0, 0.0]\n");
  const Outcome all = shop.run({"record", "q.toml", "-o", "q.tumble", "--json"});
  EXPECT_TRUE(ordered_json::parse(all.out)["warnings"].empty()) << all.out;
  const Outcome fewer = shop.run({"record", "q.toml", "-o", "q.tumble", "--steps", "7", "--json"});
  EXPECT_EQ(fewer.exit, 0) << fewer.err;
  EXPECT_EQ(ordered_json::parse(fewer.out)["warnings"][0],
            "1 input is planned behind step 7, the last one, and not given; the first: throw before step 8");
}

TEST(SameCommand, EqualStepsOfUnequalParametersSaySo) {
  const Workshop shop;
  shop.write("q.toml", "[world]\nsteps = 3\n[[box]]\nposition = [0.0, 0.0, 9.0]\n");
  ASSERT_EQ(shop.run({"record", "q.toml", "-o", "a.tumble", "--quiet"}).exit, 0);
  ASSERT_EQ(shop.run({"record", "q.toml", "-o", "b.tumble", "--quiet", "--set", "world.freeze_energy=0.5"}).exit, 0);
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_EQ(outcome.exit, 0) << outcome.out;
  EXPECT_TRUE(says(outcome, "though the headers differ in 1 value that a step depends on")) << outcome.out;
  const Outcome loose = shop.run({"diff", "a.tumble", "a.tumble", "--tolerance", "position=1e-9", "--json"});
  const std::string compared = ordered_json::parse(loose.out)["compared"].dump();
  EXPECT_EQ(compared.find("state hashes"), std::string::npos) << compared;
}

constexpr const char* kTable = R"(# engine: toy
# dt: 0.1
# up: UP
step,id,position.x,position.y,position.z,orientation.w,orientation.x,orientation.y,orientation.z,velocity.x,velocity.y,velocity.z,spin.x,spin.y,spin.z
)";

void import_rows(const Workshop& shop, const std::string& name, const std::string& up, const std::string& rows) {
  std::string table = kTable;
  table.replace(table.find("UP"), 2, up);
  shop.write(name + ".csv", table + rows);
  const Outcome outcome = shop.run({"import", name + ".csv"});
  ASSERT_EQ(outcome.exit, 0) << outcome.err;
}

TEST(SameCommand, NothingIsSaidOfContactsThatAnotherEngineDoesNotRecord) {
  const Workshop shop;
  import_rows(shop, "a", "z", "0,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n1,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n");
  import_rows(shop, "b", "z", "0,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n1,1,0,0,1.5,1,0,0,0,0,0,0,0,0,0\n");
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_EQ(outcome.exit, 1) << outcome.err;
  for (const char* words : {"matches neither", "taken again", "the same"}) {
    EXPECT_FALSE(says(outcome, words)) << words << "\n" << outcome.out;
  }
  const ordered_json json = ordered_json::parse(shop.run({"diff", "a.tumble", "b.tumble", "--json"}).out);
  EXPECT_TRUE(json["narrowed"]["this_build_follows"].is_null());
}

TEST(SameCommand, AFiniteSeparationIsANumberHoweverLarge) {
  const Workshop shop;
  import_rows(shop, "a", "z", "0,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n1,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n");
  import_rows(shop, "b", "z", "0,1,0,0,1,1,0,0,0,0,0,0,0,0,0\n1,1,1e308,0,1,1,0,0,0,0,0,0,0,0,0\n");
  const ordered_json json = ordered_json::parse(shop.run({"diff", "a.tumble", "b.tumble", "--json"}).out);
  EXPECT_EQ(json["aftermath"]["largest"]["gap"], 1e308) << json["aftermath"];
}

TEST(SameCommand, AnotherAxisThatPointsUpIsNoDifference) {
  const Workshop shop;
  import_rows(shop, "z", "z", "0,1,1,2,3,1,0,0,0,0,0,0,0,0,0\n1,1,1,2,3,1,0,0,0,0,0,-1,0,0,0\n");
  import_rows(shop, "y", "y", "0,1,1,3,-2,1,0,0,0,0,0,0,0,0,0\n1,1,1,3,-2,1,0,0,0,0,-1,0,0,0,0\n");
  const Outcome outcome = shop.run({"diff", "z.tumble", "y.tumble"});
  EXPECT_EQ(outcome.exit, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(says(outcome, "identical: 1 step, but for the sign of ")) << outcome.out;
  EXPECT_FALSE(says(outcome, "every bit")) << outcome.out;
  EXPECT_FALSE(says(outcome, "0 → -0")) << outcome.out;
  EXPECT_EQ(shop.run({"diff", "z.tumble", "y.tumble", "--step", "1"}).exit, 0);
}

TEST(SameCommand, ColumnsThatTheImportPassedOverAreNamed) {
  const Workshop shop;
  std::string head = kTable;
  head.replace(head.find("UP"), 2, "z");
  head.insert(head.size() - 1, ",_joint");
  for (const std::string name : {"a", "b"}) {
    const std::string joint = name == "a" ? ",0.2\n" : ",0.3\n";
    const std::string row = ",1,0,0,1,1,0,0,0,0,0,0,0,0,0" + joint;
    std::string table = head;
    table.append("0").append(row).append("1").append(row);
    shop.write(name + ".csv", table);
    const Outcome imported = shop.run({"import", name + ".csv"});
    ASSERT_EQ(imported.exit, 0) << imported.err;
  }
  const Outcome outcome = shop.run({"diff", "a.tumble", "b.tumble"});
  EXPECT_EQ(outcome.exit, 0) << outcome.out << outcome.err;
  EXPECT_TRUE(says(outcome, "column _joint of the table of b.tumble: the import passed over")) << outcome.out;
}

}  // namespace
}  // namespace tumble::test
